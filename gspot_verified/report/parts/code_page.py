"""The source of a module of the ledger as a page with numbered lines, each function with an address."""

from __future__ import annotations

import re
from functools import lru_cache
from importlib import resources

_LEDGER = re.compile(r"gspot_verified/paper/((?:\w+/)?)(\w+)\.py")


def code_address(path: str, function: str = "") -> str:
    """Where the page of a module is, and a function on it.

    >>> code_address("gspot_verified/paper/section_3/section_3.py", "_sides")
    'code-section_3.html#function-_sides'
    """
    match = _LEDGER.fullmatch(path)
    name = match[2] if match else "unknown"
    return f"code-{name}.html" + (f"#function-{function}" if function else "")


@lru_cache(maxsize=100)
def code_page(path: str) -> str:
    """The highlighted source as HTML; "" for what is no module of the ledger here."""
    from pygments import highlight
    from pygments.formatters import HtmlFormatter
    from pygments.lexers import PythonLexer

    match = _LEDGER.fullmatch(path)
    place = resources.files("gspot_verified.paper").joinpath(f"{match[1]}{match[2]}.py") if match else None
    if place is None or not place.is_file():
        return ""
    shown: str = highlight(place.read_text(encoding="utf-8"), PythonLexer(), HtmlFormatter(nowrap=True))
    lines = []
    for number, line in enumerate(shown.splitlines(), 1):
        name = re.match(
            r'<span class="k">def</span>\s*(?:<span class="w"> </span>)?<span class="nf">(\w+)</span>', line
        )
        address = f' id="function-{name[1]}"' if name else ""
        lines.append(f'<span class="line"{address}><i>{number}</i>{line}</span>')
    return "\n".join(lines)
