"""``gspot-verified`` and ``python -m gspot_verified``: the command line.

Its libraries take a second to load on a busy machine, so Ctrl-C is listened to before. While Python itself and the
list of public names load, some hundredths of a second, Python ends by the signal, which shells show as 130.
"""

import sys

from gspot_verified.work.interrupt import INTERRUPTED, listen, was_interrupted


def run() -> None:
    """The console script; from here on it ends with 130 wherever Ctrl-C meets it."""
    listen()
    try:
        from gspot_verified.cli.main import run as run_commands

        run_commands()
    except Exception as error:
        if not was_interrupted():
            raise
        _leave(error)
    except KeyboardInterrupt as error:
        _leave(error)


def _leave(error: BaseException) -> None:
    """An import that was interrupted may have failed with any error."""
    print("interrupted", file=sys.stderr)
    raise SystemExit(INTERRUPTED) from error


if __name__ == "__main__":
    run()
