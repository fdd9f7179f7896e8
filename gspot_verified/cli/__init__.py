"""The command line ``gspot-verified``."""

from gspot_verified.cli.main import main

__all__ = ["main"]
