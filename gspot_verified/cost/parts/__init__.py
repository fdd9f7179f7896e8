"""The parts of the measurement."""
