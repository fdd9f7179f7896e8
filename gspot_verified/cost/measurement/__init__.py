"""One run over all parts, as a file and as text."""
