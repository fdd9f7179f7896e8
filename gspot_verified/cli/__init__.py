"""The command line ``gspot-verified``."""

from gspot_verified.cli.main import main, run

__all__ = ["main", "run"]
