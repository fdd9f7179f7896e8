"""The equations of one phase of a scene: terms, what moves, and the system scaled for integration."""
