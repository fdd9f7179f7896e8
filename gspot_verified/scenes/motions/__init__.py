"""What can move: the model system, or a mechanism."""
