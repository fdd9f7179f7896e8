"""The function Θ(τ, β): initial values, routes with their bounds, evaluation to a given accuracy, arrays."""
