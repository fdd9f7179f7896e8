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
            "expected one of theta, b-hat, contact-force, phase-plane, mechanism, force, side-map, threshold, "
            "got 'atlas'",
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


@pytest.mark.parametrize("name", ["b-hat", "contact-force", "phase-plane", "mechanism"])
def test_figures_by_name(capsys: pytest.CaptureFixture[str], tmp_path: Path, name: str) -> None:
    code, output, _ = run(capsys, "plot", name, str(tmp_path / "x.pdf"))
    assert code == 0
    assert "Certified" in output or "it proves nothing" in output or "they prove nothing" in output
    assert (tmp_path / "x.pdf").read_bytes().startswith(b"%PDF")


def test_a_mechanism_at_a_spot_or_a_state(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    place = str(tmp_path / "x.svg")
    code, output, _ = run(capsys, "plot", "mechanism", place, "--mechanism", "genot_brogliato_rod", "--spot", "1")
    assert (code, output.splitlines()[0]) == (0, "Falling rod of Génot and Brogliato at G-spot 1")
    state = "X=0,theta=theta_ref-1/10,X_dot=2,theta_dot=1/2"
    code, output, _ = run(capsys, "plot", "mechanism", place, "--mechanism", "rod", "--from", state)
    assert (code, output.splitlines()[0]) == (0, "Falling rod at the given state")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--mechanism", "model"), "model system: no picture: nothing says how its bodies look; add a table [drawing]"),
        (("--mechanism", "rod", "--spot", "1", "--from", "X=0"), "give state or spot, not both"),
        (
            ("--mechanism", "rod", "--beta", "2"),
            "--beta: the figure mechanism takes --mechanism, --set, --spot, --from",
        ),
    ],
)
def test_what_a_picture_of_a_mechanism_refuses(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, arguments: tuple[str, ...], message: str
) -> None:
    code, _, errors = run(capsys, "plot", "mechanism", str(tmp_path / "x.svg"), *arguments)
    assert code == 64
    assert message in errors
    assert not (tmp_path / "x.svg").exists()
