"""The script of the site runs from top to bottom, and its cells show what they print and draw; in Jupyter too."""

from __future__ import annotations

import base64
import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import nbformat
import pytest
from pages import NOTEBOOKS
from script_notebook import cells, notebook, notebook_page, run

from gspot_verified.report.pictures.canvas import Picture

SCRIPT = Path(__file__).resolve().parents[2] / "docs" / "notebook.py"
ARM = SCRIPT.with_name("notebook_arm.py")
FIGURE = re.compile(r"static/([\w-]+\.svg)")
SOURCE = '"""x"""\n# %% [markdown]\n# # Title\n#\n# text\n\n# %%\na = 2\nprint(a)\na + 1\n'


def test_the_notebook_runs(tmp_path: Path) -> None:
    page = notebook_page(SCRIPT.read_text(encoding="utf-8"), tmp_path)
    assert "Θ(0, 7/3) = [" in page
    assert "Case III" in page
    for picture in tmp_path.iterdir():
        assert f"static/{picture.name}" in page
    drawn = {picture.name for picture in tmp_path.iterdir()}
    kept = {picture.name for picture in (SCRIPT.parent / "static").glob("*.svg")}
    shown = {name for each in SCRIPT.parent.glob("*.md") for name in FIGURE.findall(each.read_text(encoding="utf-8"))}
    assert {name for name in shown if not name.startswith("gallery_")} <= drawn | kept
    assert {"mechanism.svg", "animation.svg"} <= shown & drawn


def test_cells() -> None:
    assert cells(SOURCE) == [(True, "# Title\n\ntext"), (False, "a = 2\nprint(a)\na + 1")]
    assert [output for _, _, output, _ in run(SOURCE)] == ["", "2\n3\n"]


@pytest.mark.parametrize("source", [SOURCE, *(script.read_text(encoding="utf-8") for script in (SCRIPT, ARM))])
def test_the_cells_are_a_notebook(source: str) -> None:
    made = nbformat.from_dict(notebook(source))
    nbformat.validate(made)
    assert [(cell.cell_type == "markdown", cell.source) for cell in made.cells] == cells(source)


EXECUTE = """
import sys, nbformat
from nbclient import NotebookClient

made = nbformat.read(sys.argv[1], 4)
NotebookClient(made, kernel_name="python3", timeout=300, startup_timeout=300).execute()
nbformat.write(made, sys.argv[1])
"""


def executed(source: str, place: Path) -> list[list[Any]]:
    """The outputs of each cell with code, from a kernel of this Python; what else is installed has no part in it."""
    path = place / "notebook.ipynb"
    path.write_text(json.dumps(notebook(source)), encoding="utf-8")
    own = ("JUPYTER_DATA_DIR", "JUPYTER_CONFIG_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR")
    environment = {**os.environ, **dict.fromkeys(own, str(place)), "JUPYTER_PREFER_ENV_PATH": "1"}
    command = [sys.executable, "-c", EXECUTE, str(path)]
    run = subprocess.run(command, env=environment, cwd=place, capture_output=True, text=True, check=False, timeout=600)
    assert run.returncode == 0, run.stderr
    return [cell.outputs for cell in nbformat.read(path, 4).cells if cell.cell_type == "code"]


@pytest.mark.slow
def test_the_notebook_runs_in_a_kernel(tmp_path: Path) -> None:
    source = SCRIPT.read_text(encoding="utf-8")
    outputs = executed(source, tmp_path)
    codes = [body for is_text, body in cells(source) if not is_text]
    shown = [output.data for found in outputs for output in found if output.output_type == "execute_result"]
    images = [data for data in shown if "image/svg+xml" in data]
    assert len(images) == sum(body.splitlines()[-1].startswith("plot(") for body in codes) == 5
    for data in images:
        assert data["image/svg+xml"].startswith("<svg")
        assert base64.b64decode(data["image/png"]).startswith(b"\x89PNG")
        assert len(data["text/plain"]) <= 400
        assert "text/html" not in data
    texts = [data["text/html"] for data in shown if "text/html" in data]
    assert len(texts) == 3
    assert "Case III" in texts[0]
    assert all(len(data["text/plain"]) <= 400 for data in shown)
    assert len(outputs) == len(codes) == 9
    assert all(len(found) == 1 for found in outputs)  # no warning, no error


def test_pictures_of_two_notebooks_have_names_of_their_own(tmp_path: Path) -> None:
    made = 'Picture("dot", "t", "c", "a", "<svg/>", b"")'
    source = f"# %%\nfrom {Picture.__module__} import Picture\n\n{made}\n"
    assert "static/arm_dot.svg" in notebook_page(source, tmp_path, "arm_")
    assert [picture.name for picture in tmp_path.iterdir()] == ["arm_dot.svg"]
    assert len(set(NOTEBOOKS.values())) == len(NOTEBOOKS)
    assert {f"{name}.py" for name in NOTEBOOKS} == {script.name for script in SCRIPT.parent.glob("notebook*.py")}


@pytest.mark.slow
def test_an_arm_from_sympy_in_a_kernel(tmp_path: Path) -> None:
    """From the equations to the picture of a certified run; nothing but what the cells show is printed."""
    outputs = executed(ARM.read_text(encoding="utf-8"), tmp_path)
    assert all(output.output_type == "execute_result" for found in outputs for output in found)
    shown = [output.data for found in outputs for output in found]
    texts = [data["text/html"] for data in shown if "text/html" in data]
    assert "exactly 4 G-spots" in texts[0]
    assert "0.681153" in texts[1]
    assert "side: impact without collision" in texts[2]
    assert "no other change of phase" in texts[3]
    assert len([data for data in shown if "image/svg+xml" in data]) == 2
