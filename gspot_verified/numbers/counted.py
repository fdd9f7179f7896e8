"""How many there are of a thing, as a person says it."""


def counted(number: int, thing: str, things: str = "") -> str:
    """``one piece``, ``2 pieces``; ``things`` is the plural where it is not the singular with an s.

    >>> counted(1, "real zero"), counted(0, "real zero"), counted(2, "box", "boxes")
    ('one real zero', '0 real zeros', '2 boxes')
    """
    return f"one {thing}" if number == 1 else f"{number} {things or thing + 's'}"
