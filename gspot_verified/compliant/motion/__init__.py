"""The motion from any state: the force, its first zero, touch-down, and runs."""
