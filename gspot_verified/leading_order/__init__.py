"""The contact force at leading order: impact without collision and lift-off from Θ."""
