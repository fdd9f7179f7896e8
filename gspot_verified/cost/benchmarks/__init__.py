"""The benchmarks behind ``gspot-verified cost PART``."""
