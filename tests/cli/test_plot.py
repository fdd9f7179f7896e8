"""The command ``plot``."""

from __future__ import annotations

from pathlib import Path

import pytest

from gspot_verified.cli import main
from gspot_verified.report import plot
from gspot_verified.report.figures.force_figure import force_picture


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = main(arguments)
    output, errors = capsys.readouterr()
    return code, output, errors


def test_a_figure_and_its_caption(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    place = tmp_path / "force.png"
    code, output, _ = run(capsys, "plot", "force", str(place))
    assert code == 0
    assert force_picture().caption in output
    assert place.read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ("atlas", "x.png"),
            "expected one of theta, b-hat, contact-force, phase-plane, force, side-map, threshold, got 'atlas'",
        ),
        (("force", "x.xyz"), "allowed: .png, .pdf, .svg"),
        (("force", "nowhere/x.png"), "there is no folder nowhere"),
    ],
)
def test_bad_input_is_refused_before_the_work(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, arguments: tuple[str, ...], message: str
) -> None:
    monkeypatch.setattr(plot, "_NAMES", dict.fromkeys(plot._NAMES, None))
    code, _, errors = run(capsys, "plot", *arguments)
    assert code == 64
    assert message in errors


@pytest.mark.parametrize("name", ["b-hat", "contact-force", "phase-plane"])
def test_figures_by_name(capsys: pytest.CaptureFixture[str], tmp_path: Path, name: str) -> None:
    code, output, _ = run(capsys, "plot", name, str(tmp_path / "x.pdf"))
    assert code == 0
    assert "Certified" in output or "float runs" in output
    assert (tmp_path / "x.pdf").read_bytes().startswith(b"%PDF")
