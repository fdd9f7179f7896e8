"""The report on the paper: one JSON file, a folder of linked pages, figures, certificates; errata as a supplement."""

from gspot_verified.report.write import render_report, write_report, write_supplement

__all__ = ["render_report", "write_report", "write_supplement"]
