"""The look of the figures, names of variables in them, and a figure as SVG text and PNG bytes.

Matplotlib is imported only when one is drawn.
"""

from __future__ import annotations

import base64
import io
import re
import struct
from collections.abc import Callable
from dataclasses import dataclass
from functools import wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

from gspot_verified.numbers.written import Written
from gspot_verified.work.draft import draft

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_GREEK_WORDS = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi chi psi "
    "omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega"
)
_GREEK = frozenset(_GREEK_WORDS.split())
_ACCENTS = {"dot": r"\dot", "ddot": r"\ddot", "hat": r"\hat", "bar": r"\bar"}
_VARIANTS = {"epsilon": r"\varepsilon", "phi": r"\varphi"}

LAMBDA_N = r"$\lambda_\mathrm{N}$"


def typeset(name: str) -> str:
    """A name as a formula; one that does not read as a letter with accents and one index stays as it is.

    >>> typeset("theta_dot"), typeset("theta_ref"), typeset("X"), typeset("a__b")
    ('$\\\\dot{\\\\theta}$', '$\\\\theta_{\\\\mathrm{ref}}$', '$X$', 'a__b')
    """
    head, *rest = name.split("_")
    accents = [_ACCENTS[part] for part in rest if part in _ACCENTS]
    indices = [part for part in rest if part not in _ACCENTS]
    if (
        not (head in _GREEK or (len(head) == 1 and head.isascii() and head.isalpha()))
        or len(accents) > 1
        or len(indices) > 1
    ):
        return name
    if not all(part.isalnum() and part.isascii() for part in indices):
        return name
    letter = _letter(head)
    for accent in accents:
        letter = f"{accent}{{{letter}}}"
    return f"${letter}{''.join(_index(part) for part in indices)}$"


def _letter(name: str) -> str:
    return _VARIANTS.get(name, f"\\{name}") if name in _GREEK else name


def _index(name: str) -> str:
    return f"_{{{_letter(name)}}}" if name in _GREEK or len(name) == 1 else f"_{{\\mathrm{{{name}}}}}"


# Okabe and Ito's palette, which colour-blind readers can tell apart; each colour lighter on dark paper.
BLUE, VERMILION, GREEN, PURPLE, ORANGE = "#0072b2", "#d55e00", "#009e73", "#b5548c", "#c98a00"
COLOURS = (BLUE, VERMILION, GREEN, PURPLE, ORANGE)
STYLES: tuple[Any, ...] = ("-", (0, (5, 1.5)), (0, (1.2, 1.2)), (0, (6, 1.5, 1.2, 1.5)), (0, (9, 2)))
INK, PAPER, GRID = "#1c2024", "#fdfdfc", "#d9dcdf"

_ON_DARK = {
    BLUE: "#4aa8e0", VERMILION: "#f08a3c", GREEN: "#2bc79a", PURPLE: "#e08abc", ORANGE: "#e8b23a",
    INK: "#dfe3e7", PAPER: "#16191d", GRID: "#343a41",
}  # fmt: skip

_STYLE: dict[Any, Any] = {
    "font.family": "DejaVu Sans",
    "font.size": 9.5,
    "text.color": INK,
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "axes.facecolor": PAPER,
    "axes.linewidth": 0.8,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.titlesize": 9.5,
    "axes.unicode_minus": True,
    "figure.facecolor": PAPER,
    "grid.color": GRID,
    "grid.linewidth": 0.6,
    "xtick.color": INK,
    "ytick.color": INK,
    "legend.frameon": True,
    "legend.framealpha": 0.9,
    "legend.facecolor": PAPER,
    "legend.edgecolor": PAPER,
    "lines.linewidth": 1.7,
    "savefig.facecolor": PAPER,
    "svg.fonttype": "path",
}

_WIDTH = 7.2  # inches, of every picture
_RESOLUTION = 160  # dots an inch, of a PNG
_METADATA: dict[str, dict[str, Any]] = {
    "png": {"Software": None},
    "pdf": {"CreationDate": None, "Creator": None, "Producer": None},
    "svg": {"Date": None, "Creator": None},
}


@dataclass(frozen=True, slots=True)
class Picture(Written):
    """A figure: its texts, its SVG (light and dark in one), and a PNG and a PDF on light paper."""

    written: ClassVar[str] = "name title caption alternative"

    name: str
    title: str
    caption: str
    alternative: str
    svg: str
    png: bytes
    pdf: bytes = b""

    def __repr__(self) -> str:
        width, height = self.size
        return f"<Picture {self.name}: {self.title}, {width} × {height}>"

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of the PNG in dots, as its header says."""
        width, height = struct.unpack(">II", self.png[16:24])
        return width, height

    def _repr_mimebundle_(self, **_: object) -> tuple[dict[str, str], dict[str, dict[str, str]]]:
        """For a notebook: the PNG too, which is also shown where a notebook of somebody else is not trusted."""
        kinds = {"image/svg+xml": self.svg, "image/png": base64.b64encode(self.png).decode()}
        return {"text/plain": repr(self), **kinds}, {kind: {"alt": self.alternative} for kind in kinds}

    def _repr_svg_(self) -> str:
        return self.svg

    def _repr_html_(self) -> None:
        """Nothing: a notebook would show it in place of the picture."""

    def save(self, path: str | Path) -> Path:
        """Write it as PNG, PDF or SVG (on light paper), by the suffix; a file that is there is replaced in one step.

        :raises ValueError: another suffix.
        :raises OSError: the file cannot be written.
        """
        place = Path(path)
        contents = {"png": self.png, "pdf": self.pdf, "svg": _light(self.svg).encode()}
        content = contents[checked_suffix(place)]
        with draft(place) as unfinished:
            unfinished.write_bytes(content)
        return place


def styled(draw: Callable[[], Picture]) -> Callable[[], Picture]:
    """``draw`` in the report's style; matplotlib's settings are as before when it returns."""

    @wraps(draw)
    def wrapped() -> Picture:
        from matplotlib import rc_context

        with rc_context(_STYLE):
            return draw()

    return wrapped


def canvas(height: float) -> Figure:
    """An empty figure, ``height`` inches high. No pyplot."""
    from matplotlib.figure import Figure

    return Figure(figsize=(_WIDTH, height), layout="constrained")


def picture(figure: Figure, name: str, title: str, caption: str, alternative: str) -> Picture:
    """The finished figure, called inside :func:`styled`. It holds its title, for those who hear it; no date, no random
    identifier."""
    from matplotlib import rc_context

    made = {}
    with rc_context({"svg.hashsalt": name}):
        for kind in ("svg", "png", "pdf"):
            made[kind] = io.BytesIO()
            metadata = _METADATA[kind] | {"Title": title}
            figure.savefig(made[kind], format=kind, dpi=_RESOLUTION, metadata=metadata)
    svg = two_themes(made["svg"].getvalue().decode())
    return Picture(name, title, _unbroken(caption), alternative, svg, made["png"].getvalue(), made["pdf"].getvalue())


def save_figure(figure: Figure, name: str, title: str, path: Path) -> Path:
    """Write a figure as PNG, PDF or SVG, by the suffix; called inside :func:`styled_figure`.

    A file that is there is replaced when the new one is ready. It holds no date and no random identifier.

    :raises ValueError: another suffix.
    """
    from matplotlib import rc_context

    kind = checked_suffix(path)
    with draft(path) as unfinished, rc_context({"svg.hashsalt": name}):
        metadata = _METADATA[kind] | {"Title": title}
        figure.savefig(unfinished, format=kind, dpi=_RESOLUTION, metadata=metadata)
    return path


def styled_figure(draw: Callable[[], Path]) -> Path:
    """``draw`` in the report's style; matplotlib's settings are as before when it returns."""
    from matplotlib import rc_context

    with rc_context(_STYLE):
        return draw()


def checked_suffix(path: Path) -> str:
    """ "png", "pdf" or "svg", from the suffix.

    :raises ValueError: another suffix.
    """
    kind = path.suffix.lower().removeprefix(".")
    if kind not in _METADATA:
        raise ValueError(f"{path}: pictures are written as {', '.join(f'.{known}' for known in _METADATA)}")
    return kind


def _light(svg: str) -> str:
    """The SVG with its light colours for good: not every program reads variables."""
    for number, colour in enumerate(_ON_DARK):
        svg = svg.replace(f"var(--c{number})", colour)
    return re.sub(r"<style>svg\{--c0.*?</style>", "", svg, count=1)


def _unbroken(text: str) -> str:
    """The text with no line break next to a relation or inside 1/Γ."""
    return re.sub(r" ([=<>]) ", "\N{NO-BREAK SPACE}\\1\N{NO-BREAK SPACE}", text).replace("1/Γ", "1/\N{WORD JOINER}Γ")


def two_themes(svg: str) -> str:
    """The SVG with its colours as variables, which follow the reader's choice of light or dark."""
    names = {colour: f"--c{number}" for number, colour in enumerate(_ON_DARK)}
    for colour, name in names.items():
        svg = svg.replace(colour, f"var({name})")
    light = "".join(f"{name}:{colour};" for colour, name in names.items())
    dark = "".join(f"{names[colour]}:{shade};" for colour, shade in _ON_DARK.items())
    style = f"<style>svg{{{light}}}@media (prefers-color-scheme:dark){{svg{{{dark}}}}}</style>"
    return re.sub(r"(<svg\b[^>]*>)", lambda match: match[1] + style, svg[svg.index("<svg") :], count=1)
