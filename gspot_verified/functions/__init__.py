"""Functions of the state as graphs of few operations: derivatives, rings of numbers, power series, boxes."""
