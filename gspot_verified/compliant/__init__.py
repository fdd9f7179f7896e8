"""The model system with compliant contact at every epsilon: exact solution, side rule, force, zeros."""
