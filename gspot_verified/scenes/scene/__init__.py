"""A scene, its file, its start, and what a run of it gives."""
