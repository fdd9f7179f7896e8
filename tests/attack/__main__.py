"""The referee as a program: ``make attack MINUTES=30``. See ``tests/attack/README.md``."""

from __future__ import annotations

import argparse
import secrets
import signal
import sys
from collections.abc import Sequence

from attack.answers import Tally
from attack.runner import KINDS, LIMIT, Record, answered, attacked, draw_of, table


def main(arguments: Sequence[str] | None = None) -> int:
    """0: nothing wrong was found. 1: something was; it is printed with what repeats it."""
    parser = argparse.ArgumentParser(prog="make attack", description=__doc__)
    parser.add_argument("--minutes", type=float, default=5, help="how long (default 5)")
    parser.add_argument("--seed", help="which questions (default: a random one, which is printed)")
    parser.add_argument("--kind", action="append", choices=KINDS, help="only this kind; may be given more than once")
    parser.add_argument("--number", type=int, help="only this question of one kind; needs --kind and --seed")
    parser.add_argument("--most", type=int, help="so many questions of each kind, and no more")
    parser.add_argument("--limit", type=float, default=LIMIT, help=f"seconds of one question (default {LIMIT})")
    options = parser.parse_args(arguments)
    kinds = options.kind or [*KINDS]
    seed = options.seed or secrets.token_hex(4)
    if options.number is not None:
        if len(kinds) != 1 or options.seed is None:
            parser.error("--number needs one --kind and a --seed")
        question, answer = answered(draw_of(kinds[0]), kinds[0], seed, options.number, options.limit)
        print(f"{question}\n{answer.tally.value} {answer.detail}")
        return int(answer.tally is Tally.WRONG)
    print(f"seed {seed}, {options.minutes:g} minutes, kinds: {', '.join(kinds)}", flush=True)
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    records = {kind: Record() for kind in kinds}
    try:
        draws = {kind: draw_of(kind) for kind in kinds}
        seconds, tell = 60 * options.minutes, lambda text: print(text, flush=True)
        attacked(draws, seed, seconds, records, options.limit, tell, options.most)
    except KeyboardInterrupt:
        print("interrupted; so far:")
    print(table(records), flush=True)
    return int(any(record.counts[Tally.WRONG] for record in records.values()))


if __name__ == "__main__":
    sys.exit(main())
