"""Parts of pages: formulas, tables, charts and source as HTML."""
