"""The documentation site: ``make docs`` writes it to ``build/docs``; it needs no network, to build or to read."""

import sys
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parents[1]), str(Path(__file__).parent / "extensions")]

from gspot_verified import __version__

project = "gspot_verified"
version = release = __version__
extensions = ["myst_parser", "sphinx.ext.autodoc", "pages", "search_excerpts"]
exclude_patterns = ["extensions"]
html_theme = "furo"
html_title = f"gspot_verified {__version__}"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
highlight_language = "none"
myst_heading_anchors = 3
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
autodoc_type_aliases = {name: name for name in ("ExactInput", "Exact", "StateInput")}
python_use_unqualified_type_names = True
python_maximum_signature_line_length = 72
autodoc_member_order = "bysource"
add_module_names = False
nitpicky = False
suppress_warnings = ["myst.xref_missing", "ref.python"]
