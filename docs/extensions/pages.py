"""What the site is built from besides the pages in this folder: proof pages, public names, an executed script."""

from __future__ import annotations

import importlib
import inspect
import json
import re
from pathlib import Path
from typing import Any, get_args

from docutils import nodes
from formula_language import language
from glossary_page import glossary_page
from script_notebook import notebook, notebook_page
from sphinx.transforms.post_transforms import SphinxPostTransform

import gspot_verified
import gspot_verified.testing
from gspot_verified.numbers.balls import ExactInput
from gspot_verified.report.parts.formulas import formula, typeset

ROOT = Path(__file__).resolve().parents[2]
GROUPS = {
    "Your mechanism": ("mechanisms", "expansion"),
    "The function Θ": ("theta_function",),
    "Signs, zeros, sides": ("signs", "certificates"),
    "The compliant model": ("compliant", "integrator", "leading_order", "scenes"),
    "The paper, what accuracy costs, hard cases": ("paper", "cost", "hard_cases"),
    "Balls, intervals, verdicts, work, figures and reports": ("numbers", "work", "report"),
}
_TYPESET = (
    "proofs/",
    "certified",
    "rigour",
    "index",
    "ten_minutes",
    "your_equations",
    "expansions",
    "theta_and_signs",
    "compliant",
    "scenes",
    "theory",
    "units",
    "glossary",
)
GALLERY = re.compile(r"static/gallery_(\w+)\.svg")
"""A picture on the page of the gallery: of the mechanism in this file, at the place that it names."""
NOTEBOOKS = {"notebook": "", "notebook_arm": "arm_"}
"""Scripts that are run, and what their pictures' names begin with."""
MADE = ("glossary.md", *(f"{name}.md" for name in NOTEBOOKS))
"""Pages of this folder that are written when the site is built."""
_TYPES = {
    re.compile(r"[~\w.]*\bAnnotated\[((?:[^\[\]]|\[[^\[\]]*\])*?), (?:<[^>]*>|\w+)\]"): r"\1",
    re.compile(r"TypeAliasForwardRef\('(\w+)'\)"): r"\1",
    re.compile(r"= <(?:[^<>]|<[^<>]*>)*>"): "= ...",
}
_NO_FORMULAS = ("proofs/certificate", "proofs/check")


def write_pages(app: Any) -> None:
    """Copy the proof pages, list the public names and the terms, draw the gallery, run the scripts."""
    made = Path(app.srcdir)
    proofs = made / "proofs"
    proofs.mkdir(exist_ok=True)
    for page in sorted((ROOT / "proofs").glob("*.md")):
        _write(proofs / ("index.md" if page.stem == "README" else page.name), _proof_page(page))
    _write(made / "reference.rst", reference())
    _write(made / "glossary.md", glossary_page())
    _write(made / "formula_language.txt", language())
    for name in GALLERY.findall((made / "gallery.md").read_text(encoding="utf-8")):
        shown = gspot_verified.plot("mechanism", mechanism=gspot_verified.load(name))
        _write(made / "static" / f"gallery_{name}.svg", shown.svg)
    for name, prefix in NOTEBOOKS.items():
        script = (made / f"{name}.py").read_text(encoding="utf-8")
        _write(made / f"{name}.md", notebook_page(script, made / "static", prefix))
        _write(made / "static" / f"{name}.ipynb", json.dumps(notebook(script), ensure_ascii=False, indent=1) + "\n")


def _write(place: Path, text: str) -> None:
    if not place.exists() or place.read_text(encoding="utf-8") != text:
        place.write_text(text, encoding="utf-8")


def _proof_page(page: Path) -> str:
    """The page as it is; links to the list of pages go to the site's list, links to other files lose their target."""
    text = page.read_text(encoding="utf-8").replace("(README.md)", "(index.md)")
    text = re.sub(r"\[([^\]]*)\]\((?![\w./-]*\.md(?:#[\w-]*)?\))(?!https?:)[^)]*\)", r"\1", text)
    if page.stem == "README":
        names = sorted(other.stem for other in page.parent.glob("*.md") if other.stem != "README")
        text += "\n```{toctree}\n:hidden:\n:maxdepth: 1\n\n" + "\n".join(names) + "\n```\n"
    return text


def reference() -> str:
    """The public names under their parts of the package, each with its docstring."""
    front = "Every name here is ``from gspot_verified import name``, but for the tests at the end."
    lines = ["API reference", "=============", "", front, ""]
    exact = ", ".join(f"``{kind.__name__}``" for kind in get_args(ExactInput))
    texts = 'a text such as ``"7/3"`` or ``"0.1"``, which is 1/10'
    lines += [f"In the types, ``ExactInput`` is one of {exact} ({texts}), and ``StateInput`` gives"]
    lines += ["one of these for each name. ``arb``, ``fmpq`` and ``fmpz`` are python-flint's.", ""]
    left = {name: home.removeprefix("gspot_verified.") for name, home in gspot_verified.__homes__.items()}
    for title, parts in GROUPS.items():
        lines += [title, "-" * len(title), ""]
        for name, home in sorted(left.items(), key=lambda item: item[0].lower()):
            if home.split(".")[0] in parts:
                lines += _entry(name, home)
        left = {name: home for name, home in left.items() if home.split(".")[0] not in parts}
    if left:
        raise ValueError(f"docs: no group of the reference has {', '.join(left)}")
    title = "Tests of your own system"
    lines += [title, "-" * len(title), "", "These are ``from gspot_verified.testing import name``.", ""]
    for name in sorted(gspot_verified.testing.__all__):
        lines += _entry(name, getattr(gspot_verified.testing, name).__module__.removeprefix("gspot_verified."))
    return "\n".join(lines)


def _entry(name: str, home: str) -> list[str]:
    value = getattr(importlib.import_module(f"gspot_verified.{home}"), name)
    kind = "exception" if inspect.isclass(value) and issubclass(value, Exception) else "class"
    kind = kind if inspect.isclass(value) else "function"
    options = ["   :members:"] if kind == "class" else []
    return [f".. auto{kind}:: gspot_verified.{home}.{name}", *options, ""]


def plain_signature(
    _app: Any, _what: str, _name: str, _object: Any, _options: Any, signature: str | None, returned: str | None
) -> tuple[str | None, str | None]:
    """Types as a reader writes them: without how a value is shown, or the addresses of functions."""
    return _plain_types(signature), _plain_types(returned)


def _plain_types(text: str | None) -> str | None:
    if text is not None:
        for pattern, words in _TYPES.items():
            text = pattern.sub(words, text)
    return text


def plain_docstring(_app: Any, _what: str, _name: str, _object: Any, _options: Any, lines: list[str]) -> None:
    """Stars and bars of mathematics (xi*, |s|) are no markup."""
    doctest, literal = False, False
    for number, line in enumerate(lines):
        doctest = bool(line.strip()) and (doctest or line.lstrip().startswith(">>>"))
        literal = literal and (not line.strip() or line.startswith(" "))
        if not doctest and not literal:
            parts = re.split(r"(``.*?``|:\w+:`.*?`)", line)
            parts[::2] = [re.sub(r"([*|])", r"\\\1", part) for part in parts[::2]]
            lines[number] = "".join(parts)
        literal = literal or line.rstrip().endswith("::")


class Formulas(SphinxPostTransform):
    """Text of the pages that hold mathematics, typeset."""

    default_priority = 900
    formats = ("html",)

    def run(self, **_: Any) -> None:
        """Replace text by typeset text, and blocks of formulas by displays."""
        name = self.env.docname
        if not name.startswith(_TYPESET):
            return
        for block in list(self.document.findall(nodes.literal_block)):
            if block.get("language", "none") in ("none", "default") and not name.startswith(_NO_FORMULAS):
                lines = "\n".join(formula(line) for line in block.astext().splitlines())
                block.replace_self(nodes.raw("", f'<div class="display">{lines}</div>', format="html"))
        for text in list(self.document.findall(nodes.Text)):
            parent = text.parent
            if isinstance(parent, nodes.literal | nodes.literal_block | nodes.raw | nodes.title | nodes.comment):
                continue
            shown = typeset(text.astext())
            if "<" in shown:
                parent.replace(text, nodes.raw("", shown, format="html"))


def setup(app: Any) -> dict[str, Any]:
    """Sphinx's hook."""
    app.connect("builder-inited", write_pages)
    app.connect("autodoc-process-signature", plain_signature)
    app.connect("autodoc-process-docstring", plain_docstring)
    app.add_post_transform(Formulas)
    return {"version": "1", "parallel_read_safe": True}
