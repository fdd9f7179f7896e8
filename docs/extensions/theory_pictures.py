"""The pictures of the page on the theory: a mechanism, its contact, the compliant contact, the (p, b) plane by Case.

``python docs/extensions/theory_pictures.py`` writes ``docs/static/theory_*.svg``. In the planes the α's are constant,
as in the paper's eqs. Gspot1 and Gspot2, so db/dp = (α_2 p + α_3 b)/(α_1 p): rigid slip is b = k p + c p^β exactly,
with k = α_2/(α_1 − α_3) and β = α_3/α_1.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

STATIC = Path(__file__).resolve().parents[1] / "static"
INK, BODY, SURFACE, FORCE, LINE, SPOT = "#222", "#dbe7f3", "#ccc", "#1f5fa8", "#2e7d4f", "#c0392b"
FRICTION = 0.6  # μ of the drawing
ALPHAS = {"I": (-1.0, -1.0, -0.5), "II": (-1.0, 1.0, -0.5), "III": (-1.0, -1.0, -2.5)}
STARTS = {
    "I": [(1, -0.25), (1, -0.7), (1, -1.15)],
    "II": [(1, -0.5), (1, -1.4), (0.55, -1.45)],
    "III": [(1, -0.12), (1, -0.4), (1, -1.0), (1, -1.4)],
}
"""(p, b) where the drawn trajectories begin, all in slip."""
P_RANGE, B_RANGE = (-0.62, 1.08), (-1.55, 0.75)
SIZE = 300  # of a plane
_STEPS = 80

Point = tuple[float, float]


def arrow(begin: Point, end: Point, colour: str = INK, width: float = 2) -> str:
    """A straight arrow."""
    return (
        f'<line x1="{begin[0]:.1f}" y1="{begin[1]:.1f}" x2="{end[0]:.1f}" y2="{end[1]:.1f}" stroke="{colour}" '
        f'stroke-width="{width}" marker-end="url(#tip)"/>'
    )


def text(place: Point, words: str, anchor: str = "start", colour: str = INK) -> str:
    """Words that begin, end or have their middle at the place; ``λ_N`` has its index lowered."""
    for name in ("λ_N", "λ_T", "k_1", "k_2"):
        small = f'<tspan dy="4" font-size="10">{name[-1]}</tspan><tspan dy="-4">&#8203;</tspan>'
        words = words.replace(name, name[0] + small)
    return f'<text x="{place[0]:.1f}" y="{place[1]:.1f}" text-anchor="{anchor}" fill="{colour}">{words}</text>'


def frame(width: int, height: int, title: str) -> str:
    """The beginning of a picture."""
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
        f'font-family="sans-serif" font-size="14"><title>{title}</title><rect width="{width}" height="{height}" '
        'fill="#fff"/><defs><marker id="tip" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="6" markerHeight="6" '
        'orient="auto"><path d="M0 0 10 5 0 10z" fill="context-stroke"/></marker></defs>'
    )


def forces(contact: Point, normal: float) -> dict[str, tuple[Point, Point]]:
    """The arrows of the contact forces on the mechanism in positive slip: λ_T = −μ λ_N."""
    x, y = contact
    return {"λ_N": (contact, (x, y - normal)), "λ_T": (contact, (x - FRICTION * normal, y))}


def mechanism() -> str:
    """A body that slips on a surface, its contact point, normal, tangent, velocities and forces."""
    contact = (250.0, 250.0)
    (x, y), arrows = contact, forces(contact, 120)
    parts = [frame(460, 330, "A mechanism that slips on a surface: its contact point and the contact forces")]
    parts.append(f'<rect x="20" y="{y}" width="420" height="14" fill="{SURFACE}"/>')
    shape = f"M{x} {y}C{x - 90} {y - 70} {x - 225} {y - 120} {x - 190} {y - 200}"
    shape += f"C{x - 160} {y - 255} {x - 40} {y - 200} {x} {y}z"
    parts.append(f'<path d="{shape}" fill="{BODY}" stroke="{INK}"/>')
    parts.append(text((70, 90), "the mechanism:") + text((70, 108), "state ξ = (q, q̇)"))
    parts.append(arrow(contact, (x + 175, y), "#888", 1.2) + text((x + 175, y - 8), "tangent, x", "end", "#555"))
    parts.append(arrow(contact, (x, y - 205), "#888", 1.2) + text((x + 8, y - 195), "normal, y", colour="#555"))
    parts += [arrow(*line, FORCE, 3) for line in arrows.values()]
    parts.append(text((x + 8, arrows["λ_N"][1][1] + 12), "λ_N ≥ 0", colour=FORCE))
    parts.append(text((arrows["λ_T"][1][0] - 4, y - 8), "λ_T = −μ λ_N", "end", FORCE))
    parts.append(arrow((x + 30, y + 36), (x + 110, y + 36)) + text((x + 116, y + 41), "slip, u &gt; 0"))
    parts.append(
        f'<circle cx="{x}" cy="{y}" r="4.5" fill="{INK}"/>'
        + text((x - 6, y + 36), "contact point: y = 0, v = 0", "end")
    )
    parts.append(text((20, y + 66), "x, y: place of the contact point; u, v: its velocity"))
    return "\n".join([*parts, "</svg>\n"])


def _spring(x: float, top: float, bottom: float) -> str:
    """A zigzag between two heights."""
    ends, turns = (bottom - top) * 0.15, 6
    step = (bottom - top - 2 * ends) / turns
    path = f"M{x} {top}v{ends:.1f}" + "".join(
        f"L{x + (9 if i % 2 == 0 else -9)} {top + ends + step * (i + 0.5):.1f}" for i in range(turns)
    )
    return f'<path d="{path}L{x} {bottom - ends:.1f}V{bottom}" fill="none" stroke="{INK}" stroke-width="1.6"/>'


def contact() -> str:
    """The compliant contact: spring k_1 and damper c side by side up to z, spring k_2 from z to the contact point."""
    ground, plate, tip, x = 235.0, 145.0, 60.0, 170.0
    parts = [frame(460, 270, "The compliant contact: two springs and a damper")]
    parts.append(f'<rect x="60" y="{ground}" width="220" height="14" fill="{SURFACE}"/>')
    parts.append(_spring(x - 50, plate, ground) + text((x - 66, (plate + ground) / 2 + 5), "k_1", "end"))
    middle = (plate + ground) / 2
    cup = f"M{x + 50} {ground}V{middle + 14}M{x + 36} {middle - 16}V{middle + 14}H{x + 64}V{middle - 16}"
    cup += f"M{x + 50} {plate}V{middle}M{x + 39} {middle}H{x + 61}"
    parts.append(f'<path d="{cup}" fill="none" stroke="{INK}" stroke-width="1.6"/>')
    parts.append(text((x + 74, middle + 5), "c"))
    parts.append(f'<path d="M{x - 65} {plate}H{x + 65}" stroke="{INK}" stroke-width="3"/>')
    parts.append(_spring(x, tip, plate) + text((x - 16, (tip + plate) / 2 + 5), "k_2", "end"))
    parts.append(f'<path d="M{x - 30} 20Q{x} {2 * tip - 20} {x + 30} 20z" fill="{BODY}" stroke="{INK}"/>')
    parts.append(
        f'<circle cx="{x}" cy="{tip}" r="4.5" fill="{INK}"/>' + text((x + 14, tip + 5), "contact point, height y")
    )
    parts.append(text((x + 75, plate + 5), "surface, height z"))
    parts.append(
        text((x + 125, middle - 4), "λ_N = k_2 (z − y)") + text((x + 125, middle + 16), "while y &lt; z, else 0")
    )
    parts.append(text((x + 125, middle + 44), "c ż = −k_1 z − λ_N"))
    return "\n".join([*parts, "</svg>\n"])


def slope(case: str) -> float:
    """k: b/p on the distinguished trajectory, minus its contact force."""
    first, second, third = ALPHAS[case]
    return second / (first - third)


def slip(case: str, start: Point) -> list[Point]:
    """Rigid slip from a state, to the G-spot or to lift-off (b = 0, p > 0)."""
    (p_start, b_start), k = start, slope(case)
    beta = ALPHAS[case][2] / ALPHAS[case][0]
    c = (b_start - k * p_start) / p_start**beta
    end = 0.0
    if k < 0 < c:  # b = 0 at p^(β−1) = −k/c
        zero = (-k / c) ** (1 / (beta - 1))
        end = zero if zero < p_start else 0.0
    places = [end + (p_start - end) * (1 - i / _STEPS) ** 2 for i in range(_STEPS + 1)]
    return [(p, k * p + c * p**beta if p else 0.0) for p in places]


def at(point: Point) -> Point:
    """Where (p, b) is in the picture."""
    (p_low, p_high), (b_low, b_high) = P_RANGE, B_RANGE
    return SIZE * (point[0] - p_low) / (p_high - p_low), SIZE * (b_high - point[1]) / (b_high - b_low)


def _curve(points: list[Point], style: str) -> str:
    return "<polyline " + style + ' points="' + " ".join(f"{x:.1f},{y:.1f}" for x, y in map(at, points)) + '"/>'


def plane(case: str) -> str:
    """The (p, b) plane of one Case."""
    return "\n".join([frame(SIZE, SIZE, f"The (p, b) plane in Case {case}"), *_plane(case), "</svg>\n"])


def _plane(case: str) -> Iterator[str]:
    left, right = (at((p, 0))[0] for p in P_RANGE)
    bottom, top = (at((0, b))[1] for b in B_RANGE)
    x, y = at((0, 0))
    yield f'<rect x="0" y="{y:.1f}" width="{x:.1f}" height="{bottom - y:.1f}" fill="#f6d9d5"/>'
    yield f'<rect x="0" y="0" width="{x:.1f}" height="{y:.1f}" fill="#fbf0d9"/>'
    yield f'<rect x="{x:.1f}" y="{y:.1f}" width="{SIZE - x:.1f}" height="{bottom - y:.1f}" fill="#e8f2ea"/>'
    yield arrow((left, y), (right - 2, y)) + text((right - 4, y - 7), "p", "end")
    yield arrow((x, bottom), (x, top + 2)) + text((x + 7, top + 14), "b")
    k = slope(case)
    reach = min(P_RANGE[1], B_RANGE[0] / k if k < 0 else B_RANGE[1] / k) * 0.97
    style = f'fill="none" stroke="{LINE}" stroke-width="2.5" stroke-dasharray="7 4"'
    yield _curve([(reach, k * reach), (0, 0)], style)
    for start in STARTS[case]:
        path = slip(case, start)
        half = len(path) // 3
        thin = f'fill="none" stroke="{INK}" stroke-width="1.3"'
        yield _curve(path[: half + 1], f'{thin} marker-end="url(#tip)"') + _curve(path[half:], thin)
        if path[-1][0] > 0:
            end = at(path[-1])
            yield f'<circle cx="{end[0]:.1f}" cy="{end[1]:.1f}" r="3.5" fill="#fff" stroke="{INK}" stroke-width="1.5"/>'
    yield f'<circle cx="{x:.1f}" cy="{y:.1f}" r="6" fill="{SPOT}"/>' + text((x - 9, y + 19), "G-spot", "end", SPOT)
    yield text((right - 6, top + 16), f"Case {case}", "end")
    yield text((right - 6, y - 30), "lifts off", "end", "#555") + text((right - 6, bottom - 8), "slip", "end", "#555")
    yield text((6, bottom - 26), "no force", colour="#555") + text((6, bottom - 8), "fits", colour="#555")
    yield text((6, top + 16), "two answers", colour="#555") + text((6, top + 34), "fit", colour="#555")


def pictures() -> dict[str, str]:
    """All pictures by the names of their files."""
    planes = {f"theory_case_{case}.svg": plane(case) for case in ALPHAS}
    return {"theory_mechanism.svg": mechanism(), "theory_contact.svg": contact(), **planes}


def main() -> None:
    """Write the pictures."""
    for name, picture in pictures().items():
        (STATIC / name).write_text(picture, encoding="utf-8")


if __name__ == "__main__":
    main()
