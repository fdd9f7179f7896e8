"""The G-spots of a mechanism, and what each of them is."""
