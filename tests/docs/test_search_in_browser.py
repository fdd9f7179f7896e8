"""The search of a site that is read from a disk, in a real browser. Needs Chromium."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import search_excerpts

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
CONF = f"""
import sys
sys.path.insert(0, {str(Path(search_excerpts.__file__).parent)!r})
extensions = ["search_excerpts"]
"""


@pytest.mark.slow
@pytest.mark.skipif(CHROMIUM is None, reason="there is no Chromium here")
def test_each_result_has_its_excerpt(tmp_path: Path) -> None:
    (tmp_path / "conf.py").write_text(CONF, encoding="utf-8")
    (tmp_path / "index.rst").write_text(
        "Ducks\n=====\n\n.. toctree::\n\n   more\n\nOne canard swims.\n", encoding="utf-8"
    )
    (tmp_path / "more.rst").write_text("More\n====\n\nA canard through the G-spot.\n", encoding="utf-8")
    site = tmp_path / "site"
    subprocess.run(
        [sys.executable, "-m", "sphinx", "-W", "-q", "-b", "html", str(tmp_path), str(site)], check=True, timeout=120
    )
    options = ["--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={tmp_path / 'profile'}"]
    address = (site / "search.html").as_uri() + "?q=canard"
    shown = subprocess.run(
        [str(CHROMIUM), *options, "--virtual-time-budget=20000", "--dump-dom", address],
        capture_output=True, text=True, check=True, timeout=120,
    ).stdout  # fmt: skip
    found = re.findall(r'<p class="context">(.*?)</p>', shown, re.DOTALL)
    words = {re.sub(r"<[^>]*>", "", one).strip() for one in found}
    assert len(words) == 2
    assert any("A canard through the G-spot." in one for one in words)
    assert any("One canard swims." in one for one in words)
