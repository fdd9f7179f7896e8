"""How many there are of a thing, and how many of them are done, as a person says it."""


def counted(number: int, thing: str, things: str = "") -> str:
    """``one piece``, ``2 pieces``; ``things`` is the plural where it is not the singular with an s.

    >>> counted(1, "real zero"), counted(0, "real zero"), counted(2, "box", "boxes")
    ('one real zero', '0 real zeros', '2 boxes')
    """
    return f"one {thing}" if number == 1 else f"{number} {things or thing + 's'}"


def done_of(done: int, total: int, thing: str, things: str = "") -> str:
    """``3 of 40 cells``, ``1 of 1 cell``: in digits, so that a program may read how far the work is.

    >>> done_of(3, 40, "cell"), done_of(1, 1, "cell"), done_of(0, 2, "entry", "entries")
    ('3 of 40 cells', '1 of 1 cell', '0 of 2 entries')
    """
    return f"{done} of {total} {thing if total == 1 else things or thing + 's'}"
