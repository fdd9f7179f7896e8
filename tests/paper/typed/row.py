r"""Where a typed formula stands in the paper: which lines, which equation and side, and what the names are."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

from paper.typed.latex_formula import Sides

Parts = Mapping[str, str]
Names = dict[str, str]


class Row(NamedTuple):
    """One typed formula and its place; ``inline``: in the text between dollars; ``columns``: & separates equations."""

    entry: str
    part: str
    table: Parts
    first: int
    last: int
    piece: int
    printed: Callable[[Sides], str]
    names: Names
    typed: Callable[[Parts], str] | None = None
    layout: str = "display"

    @property
    def text(self) -> str:
        """The typed text."""
        return self.typed(self.table) if self.typed else self.table[self.part]


def of_side(k: int, times: str = "1") -> Callable[[Sides], str]:
    """One side, times a factor."""
    return lambda sides: f"({times})*({sides[k]})"


def difference(sides: Sides) -> str:
    """The first side minus the second."""
    return f"({sides[0]})-({sides[1]})"


def order_of(k: int) -> Callable[[Sides], str]:
    """What stands in O(...) on one side."""
    return lambda sides: sides.orders(k)[0]


def jets(function: str, time: str, symbol: str) -> Names:
    """A function and its derivatives in a time, as fractions."""
    return {function: f"{symbol}0", rf"\frac{{d{function}}}{{d{time}}}": f"{symbol}1"} | {
        rf"\frac{{d^{k}{function}}}{{d{time}^{k}}}": f"{symbol}{k}" for k in (2, 3, 4)
    }


GREEK = {rf"\{name}": name for name in ("beta", "kappa", "delta", "epsilon", "chi", "mu", "tau", "pi")} | {
    r"\eps": "epsilon", r"\varepsilon": "epsilon", r"\lambda": "lam", r"\lambda_N": "lam",
}  # fmt: skip
PLAIN = {
    letter: letter
    for letter in ["a", "b", "c", "e", "g", "h", "i", "k", "l", "m", "n", "p", "r", "s", "t", "u", "v", "x", "y", "z"]
}
CONSTANTS = GREEK | PLAIN | {rf"\alpha_{k}^*": f"alpha{k}" for k in (1, 2, 3)}
QUOTIENT = "(alpha2/(alpha1-alpha3))"


def rows(
    entry: str,
    table: Mapping[str, Parts],
    names: Names,
    *places: tuple[str, int, int, int, Callable[[Sides], str]],
) -> list[Row]:
    """Rows of one entry with the same names: part, lines, equation, what is read."""
    return [
        Row(entry, part, table[entry], first, last, piece, printed, names)
        for part, first, last, piece, printed in places
    ]
