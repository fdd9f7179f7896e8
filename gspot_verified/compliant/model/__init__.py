"""The model in its normal form, its states, and free flight."""
