"""The figures of the report, drawn from certified data."""
