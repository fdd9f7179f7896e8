"""Runs in floats, which prove nothing."""
