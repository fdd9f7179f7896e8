"""The report on the paper: one JSON file, a folder of linked pages, figures, certificates."""

from gspot_verified.report.write import render_report, write_report

__all__ = ["render_report", "write_report"]
