"""The script of the site runs from top to bottom, and its cells show what they print and draw."""

from __future__ import annotations

from pathlib import Path

from script_notebook import cells, notebook_page, run

SCRIPT = Path(__file__).resolve().parents[2] / "docs" / "notebook.py"


def test_the_notebook_runs(tmp_path: Path) -> None:
    page = notebook_page(SCRIPT.read_text(encoding="utf-8"), tmp_path)
    assert "Θ(0, 7/3) = [" in page
    assert "Case III" in page
    for picture in tmp_path.iterdir():
        assert f"static/{picture.name}" in page


def test_cells() -> None:
    source = '"""x"""\n# %% [markdown]\n# # Title\n#\n# text\n\n# %%\na = 2\nprint(a)\na + 1\n'
    assert cells(source) == [(True, "# Title\n\ntext"), (False, "a = 2\nprint(a)\na + 1")]
    assert [output for _, _, output, _ in run(source)] == ["", "2\n3\n"]
