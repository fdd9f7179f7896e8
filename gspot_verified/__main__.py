"""``python -m gspot_verified``: the command line."""

from gspot_verified.cli import run

if __name__ == "__main__":
    run()
