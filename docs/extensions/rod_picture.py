"""The picture of README.md: the rod on the table, and where its G-spots are.

``python docs/extensions/rod_picture.py`` writes ``docs/static/rod.svg``. The four dots are the G-spots that the library
proves; the thin curves are slip in floats, with time measured by dt = p ds, which is smooth at p = 0. They show, they
prove nothing.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

from gspot_verified import find_g_spots, load

PLACE = Path(__file__).resolve().parents[1] / "static" / "rod.svg"
MU, GRAVITY, ANGLE = 73 / 36, 3 / 5, math.asin(3 / 5)  # as in the shipped file falling_rod.toml, m = l = 1
STARTS = [(0.30, 0.90), (0.30, 1.12), (0.34, 0.70), (0.42, 0.50), (0.50, 0.35)]
LEFT, RIGHT, BOTTOM, TOP = 0.25, 1.55, -1.55, 1.75  # the range of theta and of its velocity that is drawn

Point = tuple[float, float]


def p(theta: float) -> float:
    """What a contact force 1 gives in normal acceleration, with its friction: C - mu B."""
    return 1 + 3 * math.cos(theta) ** 2 - 3 * MU * math.sin(theta) * math.cos(theta)


def b(theta: float, velocity: float) -> float:
    """The normal acceleration without a contact force."""
    return -GRAVITY + math.sin(theta) * velocity**2


def rates(theta: float, velocity: float) -> Point:
    """Slip with the force -b/p, times p."""
    turn = 3 * (MU * math.sin(theta) - math.cos(theta))
    return p(theta) * velocity, -b(theta, velocity) * turn


def slip(start: Point, step: float = 0.02, steps: int = 400) -> list[Point]:
    """The slip from a state, up to lift-off or next to the G-spot."""
    path = [start]
    for _ in range(steps):
        x, y = path[-1]
        if b(x, y) > 0 or p(x) < 0.02:
            break
        k1 = rates(x, y)
        k2 = rates(x + step / 2 * k1[0], y + step / 2 * k1[1])
        k3 = rates(x + step / 2 * k2[0], y + step / 2 * k2[1])
        k4 = rates(x + step * k3[0], y + step * k3[1])
        change = [step / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]) for i in (0, 1)]
        path.append((x + change[0], y + change[1]))
    return path


def g_spots() -> list[Point]:
    """(theta, its velocity) at the midpoints of the proved boxes."""
    found = []
    for spot in find_g_spots(load("rod")).spots:
        state = dict(zip(spot.mechanism.state, spot.system.point, strict=True))
        found.append((ANGLE + _number(state["theta"]), _number(state["theta_dot"])))
    return sorted(found)


def _number(value: object) -> float:
    return float(value.mid()) if hasattr(value, "mid") else float(value)  # type: ignore[arg-type]


def picture() -> str:
    """The whole picture as SVG."""
    parts = [*_frame(), *_rod(), *_plane()]
    return "\n".join(parts) + "\n</svg>\n"


def _frame() -> Iterator[str]:
    yield '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 900 400" font-family="sans-serif" font-size="14">'
    yield '<title>A rod that slides on a table, and its G-spots</title><rect width="900" height="400" fill="#fff"/>'
    yield '<defs><marker id="tip" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="6" markerHeight="6" orient="auto">'
    yield '<path d="M0 0 10 5 0 10z"/></marker></defs>'


def _arrow(x: float, y: float, dx: float, dy: float) -> str:
    return (
        f'<line x1="{x:.1f}" y1="{y:.1f}" x2="{x + dx:.1f}" y2="{y + dy:.1f}" stroke="#222" stroke-width="2" '
        'marker-end="url(#tip)"/>'
    )


def _text(x: float, y: float, text: str, anchor: str = "start", colour: str = "#222") -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{colour}">{text}</text>'


def _rod() -> Iterator[str]:
    table, tip, scale = 275.0, 245.0, 120.0
    centre = tip - scale * math.cos(ANGLE), table - scale * math.sin(ANGLE)
    end = 2 * centre[0] - tip, 2 * centre[1] - table
    yield _text(20, 30, "a rod slides on a rough table")
    yield f'<rect x="20" y="{table}" width="350" height="12" fill="#ccc"/>'
    ends = f'x1="{end[0]:.1f}" y1="{end[1]:.1f}" x2="{tip}" y2="{table}"'
    yield f'<line {ends} stroke="#1f5fa8" stroke-width="9" stroke-linecap="round"/>'
    yield f'<circle cx="{centre[0]:.1f}" cy="{centre[1]:.1f}" r="4" fill="#fff"/>'
    yield _arrow(tip, table, 0, -95) + _text(tip + 8, table - 85, "contact force λ")
    yield _arrow(tip, table, -120, 0) + _text(tip - 125, table - 8, "friction μλ", "end")
    yield _arrow(tip + 15, table + 32, 75, 0) + _text(tip + 10, table + 37, "slip", "end")
    arc = f"M{tip - 48} {table}A48 48 0 0 1 {tip - 48 * math.cos(ANGLE):.1f} {table - 48 * math.sin(ANGLE):.1f}"
    yield f'<path d="{arc}" fill="none" stroke="#222"/>'
    yield _text(tip - 66, table - 14, "θ")


def _at(theta: float, velocity: float) -> Point:
    return 440 + 440 * (theta - LEFT) / (RIGHT - LEFT), 350 - 300 * (velocity - BOTTOM) / (TOP - BOTTOM)


def _curve(points: list[Point], style: str) -> str:
    inside = [_at(*point) for point in points if BOTTOM <= point[1] <= TOP and LEFT <= point[0] <= RIGHT]
    return '<polyline fill="none" ' + style + ' points="' + " ".join(f"{x:.1f},{y:.1f}" for x, y in inside) + '"/>'


def _box(left: float, top: float, right: float, bottom: float, style: str) -> str:
    return f'<rect x="{left:.1f}" y="{top:.1f}" width="{right - left:.1f}" height="{bottom - top:.1f}" {style}/>'


def _plane() -> Iterator[str]:
    spots = g_spots()
    first, last = spots[0][0], spots[-1][0]
    (left, top), (right, bottom) = _at(first, TOP), _at(last, BOTTOM)
    (x, y), (x_end, y_end) = _at(LEFT, TOP), _at(RIGHT, BOTTOM)
    yield _text(x, 30, "its states in contact: angle θ and its velocity")
    yield _box(left, top, right, bottom, 'fill="#f6d9d5"') + _box(x, y, x_end, y_end, 'fill="none" stroke="#888"')
    angles = [LEFT + (RIGHT - LEFT) * i / 60 for i in range(61)]
    for sign in (1, -1):
        line = [(angle, sign * math.sqrt(GRAVITY / math.sin(angle))) for angle in angles]
        yield _curve(line, 'stroke="#1f5fa8" stroke-width="2" stroke-dasharray="6 4"')
    for start in STARTS:
        yield _curve(slip(start), 'stroke="#666" marker-end="url(#tip)"')
    for spot in spots:
        dot = _at(*spot)
        chosen = abs(spot[0] - ANGLE) < 1e-9 and spot[1] > 0
        look = 'r="7" fill="#c0392b"' if chosen else 'r="4" fill="#222"'
        yield f'<circle cx="{dot[0]:.1f}" cy="{dot[1]:.1f}" {look}/>'
    spot_x, spot_y = _at(ANGLE, 1)
    yield _text(spot_x + 14, spot_y - 26, "G-spot: p = 0 and b = 0", colour="#c0392b")
    middle = (left + right) / 2
    yield _text(middle, _at(0, 0.12)[1], "p &lt; 0, b &lt; 0:", "middle")
    yield _text(middle, _at(0, -0.08)[1], "no contact force fits", "middle")
    yield _text(x + 8, _at(0, -0.08)[1], "p &gt; 0, b &lt; 0:")
    yield _text(x + 8, _at(0, -0.28)[1], "it slides")
    yield _text(middle, y + 18, "p &lt; 0, b &gt; 0: two answers fit", "middle")
    yield _text(x + 70, y + 18, "it lifts off", "middle")
    yield _text(right + 6, bottom - 8, "p &gt; 0")
    yield _text((x + x_end) / 2, y_end + 22, "θ", "middle") + _text(x - 12, (y + y_end) / 2, "θ̇", "end")
    yield _text(x_end, y_end + 40, "dashed: b = 0; edges of the red band: p = 0", "end")


def main() -> None:
    """Write the picture."""
    PLACE.write_text(picture(), encoding="utf-8")


if __name__ == "__main__":
    main()
