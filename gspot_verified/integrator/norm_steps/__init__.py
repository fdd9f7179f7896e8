"""Long steps whose error is bounded by logarithmic norms in bases that follow the flow."""
