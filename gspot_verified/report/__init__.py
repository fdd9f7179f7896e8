"""The report on the paper: one JSON file, one self-contained HTML page, figures."""

from gspot_verified.report.write import render_from_json, render_html, write_report

__all__ = ["render_from_json", "render_html", "write_report"]
