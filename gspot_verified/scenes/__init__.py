"""Scenes: a mechanism, the effects that matter, initial values and a question; float runs and certified runs."""
