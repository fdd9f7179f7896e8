"""The report on the user's own mechanism: one page, its data, its certificates."""
