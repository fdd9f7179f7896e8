"""All pages in a real browser: nothing on the console, mathematics set, figures there. Needs Chromium."""

import json
import re
import shutil
import subprocess

import pytest

from gspot_verified.report import write
from gspot_verified.report.site import new_results

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")

# Loads each page of the folder in a frame, one after the other, and writes what it finds into its own text.
HARNESS = """<!DOCTYPE html><meta charset="utf-8"><pre id="found"></pre><script>
const names = NAMES, found = {};
function luminance(c) {
  const parts = c.match(/[\\d.]+/g).slice(0, 3).map((x) => x / 255);
  const [r, g, b] = parts.map((x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}
function ground(element) {
  for (let e = element; e; e = e.parentElement) {
    const colour = getComputedStyle(e).backgroundColor;
    if (!/, 0\\)$/.test(colour) && colour !== "transparent") return colour;
  }
  return "rgb(255, 255, 255)";
}
function examine(frame) {
  const page = frame.contentDocument;
  let worst = 99;
  for (const element of page.querySelectorAll("main :is(p, li, td, th, a, span, dd, dt, h1, h2, h3)")) {
    if (!element.textContent.trim() || !element.checkVisibility()) continue;
    const [low, high] = [luminance(getComputedStyle(element).color), luminance(ground(element))].sort((a, b) => a - b);
    worst = Math.min(worst, (high + 0.05) / (low + 0.05));
  }
  const seen = page.querySelector("main").innerText.replace(/LaTeX[^\\n]*/g, "");
  return {
    raw: (seen.match(/\\\\(frac|alpha|beta|left|begin)/g) || []).length,
    math: page.querySelectorAll("math").length,
    formulas: page.querySelectorAll(".formula").length,
    images: [...page.images].map((image) => image.naturalWidth),
    rows: page.querySelectorAll("tr[data-outcome]:not([hidden])").length,
    wide: page.documentElement.scrollWidth > page.documentElement.clientWidth + 1,
    contrast: worst,
  };
}
(async () => {
  for (const name of names) {
    const frame = document.createElement("iframe");
    frame.width = WIDTH; frame.height = 900; frame.src = name;
    await new Promise((done) => { frame.onload = done; document.body.append(frame); });
    await new Promise((done) => setTimeout(done, 30));
    found[name] = examine(frame);
    if (name === "statements.html") {
      const words = frame.contentDocument.querySelector("input[name=words]");
      words.value = "dominance"; words.dispatchEvent(new Event("input", { bubbles: true }));
      found[name].searched = frame.contentDocument.querySelectorAll("tr[data-outcome]:not([hidden])").length;
    }
    frame.remove();
  }
  document.getElementById("found").textContent = JSON.stringify(found);
})();
</script>"""


def examined(folder, width):
    """What the browser found on every page, by its name, and what it wrote to the console."""
    names = sorted(path.name for path in folder.glob("*.html") if path.name != "harness.html")
    harness = HARNESS.replace("NAMES", json.dumps(names)).replace("WIDTH", str(width))
    (folder / "harness.html").write_text(harness, encoding="utf-8")
    options = [
        "--headless",
        "--no-sandbox",
        "--disable-gpu",
        "--allow-file-access-from-files",
        "--enable-logging=stderr",
    ]
    profile = folder.parent / "profile"
    command = [CHROMIUM, *options, f"--user-data-dir={profile}", "--virtual-time-budget=600000", "--dump-dom"]
    run = subprocess.run(
        [*command, (folder / "harness.html").as_uri()], capture_output=True, text=True, check=True, timeout=300
    )
    import html

    [text] = re.findall(r'<pre id="found">(.*?)</pre>', run.stdout, re.S)
    return json.loads(html.unescape(text)), [line for line in run.stderr.splitlines() if "CONSOLE" in line]


@pytest.fixture(scope="module")
def folder(pictures, certificates, hard, whole_ledger, tmp_path_factory):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(write, "computed", lambda *_: (pictures, certificates, hard))
        folder = tmp_path_factory.mktemp("browser") / "report"
        write.write_report(whole_ledger, folder)
        return folder


@pytest.mark.slow
@pytest.mark.skipif(CHROMIUM is None, reason="there is no Chromium here")
@pytest.mark.parametrize("width", [1000, 400])
def test_every_page(folder, width, pictures):
    found, console = examined(folder, width)
    assert console == []
    assert len(found) > 80
    for name, page in found.items():
        assert page["raw"] == 0 or name.startswith("code-"), name
        assert page["contrast"] >= 4.5, (name, page["contrast"])
        assert all(size > 0 for size in page["images"]), name
        assert not page["wide"], f"{name} is wider than its window"
    assert len(found["figures.html"]["images"]) == len(pictures)
    assert len(found["new.html"]["images"]) == len(new_results())
    assert len(found["index.html"]["images"]) == 1
    assert len(found["cost.html"]["images"]) == 10
    for section in ("section-4.html", "section-5.html", "appendix-a.html"):
        assert found[section]["math"] > 20
        assert found[section]["formulas"] > 20
    assert found["hard.html"]["math"] >= 2
    assert found["hard.html"]["formulas"] > 20
    assert found["statements.html"]["rows"] > 100
    assert 1 <= found["statements.html"]["searched"] < 10
