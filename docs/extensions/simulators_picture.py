"""The pictures of the page on simulators: slip against time, from the recorded runs.

``python docs/extensions/simulators_picture.py`` writes ``docs/static/simulators.svg``, of the rod, and
``simulators_arm.svg`` from ``docs/simulators.json``.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

DATA = Path(__file__).resolve().parents[1] / "simulators.json"
STATIC = Path(__file__).resolve().parents[1] / "static"
COLOURS = {
    "compliant contact": "#1f5fa8",
    "Moreau-Jean": "#7a3e9d",
    "MuJoCo": "#c0392b",
    "sap": "#d98324",
    "tamsi": "#8a6d1d",
    "lagged": "#2e7d4f",
}
LABELS = {"sap": "Drake, SAP", "tamsi": "Drake, TAMSI", "lagged": "Drake, lagged"}
WIDTH, HEIGHT, LEFT, TOP, GAP = 380, 300, 50, 34, 40
LONGEST, LEAST = 0.06, -0.6  # the range of time, and the lowest slip velocity


@dataclass(frozen=True)
class Panel:
    """The runs of one start: what they are called, the certified path, and its event; ``fastest``: the top of it."""

    title: str
    event: str
    time: float
    slip: list[list[float]]
    curves: list[dict[str, Any]]
    fastest: int


def colour(name: str) -> str:
    """That of the simulator in the name of a run."""
    return next(colour for word, colour in COLOURS.items() if word in name)


def line(points: list[list[float]], left: float, fastest: int, style: str) -> str:
    """A curve of (time, slip) in the panel that begins at ``left``."""
    places = [
        (left + WIDTH * t / LONGEST, TOP + HEIGHT * (fastest - max(LEAST, u)) / (fastest - LEAST))
        for t, u in points
        if t <= LONGEST and u <= fastest
    ]
    return f'<polyline fill="none" {style} points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in places)}"/>'


def panel(start: Panel, left: float) -> list[str]:
    """The runs of one start, the certified path, and the time of its event."""
    right, bottom, fastest = left + WIDTH, TOP + HEIGHT, start.fastest
    zero = TOP + HEIGHT * fastest / (fastest - LEAST)
    event = left + WIDTH * start.time / LONGEST
    parts = [
        f'<text x="{left}" y="{TOP - 12}">{start.title}</text>',
        f'<path d="M{left},{TOP}V{bottom}H{right}" fill="none" stroke="#222"/>',
        f'<line x1="{left}" y1="{zero:.1f}" x2="{right}" y2="{zero:.1f}" stroke="#bbb"/>',
        f'<line x1="{event:.1f}" y1="{TOP}" x2="{event:.1f}" y2="{bottom}" stroke="#222" stroke-dasharray="4 3"/>',
        f'<text x="{event + 4:.1f}" y="{bottom - 6}" font-size="12">{start.event}, certified</text>',
    ]
    for k in range(4):
        x = left + WIDTH * k / 3
        parts.append(f'<text x="{x:.0f}" y="{bottom + 16}" font-size="12" text-anchor="middle">{k * 0.02:.2f}</text>')
    for u in range(fastest + 1):
        y = TOP + HEIGHT * (fastest - u) / (fastest - LEAST)
        parts.append(f'<text x="{left - 8}" y="{y + 4:.1f}" font-size="12" text-anchor="end">{u}</text>')
    parts += [line(c["slip"], left, fastest, f'stroke="{colour(c["name"])}" stroke-width="1.6"') for c in start.curves]
    parts.append(line(start.slip, left, fastest, 'stroke="#222" stroke-width="3" stroke-dasharray="1 5"'))
    parts.append(f'<text x="{left + WIDTH / 2}" y="{bottom + 34}" text-anchor="middle">t in s</text>')
    return parts


def panels() -> dict[str, list[Panel]]:
    """Those of each picture, by the name of its file."""
    data = json.loads(DATA.read_text(encoding="utf-8"))
    rod = [
        Panel(
            f"θ̇ = {start['theta_dot']}: {start['certified_side']}",
            "G-spot",
            start["certified_time"],
            start["certified_slip"],
            start["curves"],
            fastest=3,
        )
        for start in data["starts"]
    ]
    arm = [
        Panel(
            f"shoulder_dot = {start['state']['shoulder_dot']}: {start['certified']['side'] or 'lift-off on the way'}",
            start["certified"]["end"],
            start["certified"]["time"],
            start["certified_slip"],
            start["curves"],
            fastest=2,
        )
        for start in data["command"]["starts"]
        if start["mechanism"] == "arm"
    ]
    return {"simulators.svg": rod, "simulators_arm.svg": arm}


def picture(name: str) -> str:
    """The whole picture."""
    total, bottom = LEFT + 2 * WIDTH + GAP + 20, TOP + HEIGHT
    parts = [part for i, start in enumerate(panels()[name]) for part in panel(start, LEFT + i * (WIDTH + GAP))]
    middle = TOP + HEIGHT / 2
    turned = f'x="14" y="{middle}" transform="rotate(-90 14 {middle})" text-anchor="middle"'
    parts.append(f"<text {turned}>slip in m/s</text>")
    for i, (word, shade) in enumerate(
        [("certified rigid slip", "#222"), *((LABELS.get(w, w), c) for w, c in COLOURS.items())]
    ):
        x, y = LEFT + (i % 4) * 210, bottom + 60 + 20 * (i // 4)
        dashes = ' stroke-dasharray="1 5"' if i == 0 else ""
        parts.append(f'<line x1="{x}" y1="{y}" x2="{x + 24}" y2="{y}" stroke="{shade}" stroke-width="3"{dashes}/>')
        parts.append(f'<text x="{x + 30}" y="{y + 4}" font-size="13">{word}</text>')
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {total} {bottom + 96}" font-family="sans-serif" '
        f'font-size="14" role="img"><title>Slip against time in simulators, two starts</title>\n'
        + "\n".join(parts)
        + "\n</svg>\n"
    )


if __name__ == "__main__":
    for name in panels():
        (STATIC / name).write_text(picture(name), encoding="utf-8")
