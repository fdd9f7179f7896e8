"""What simulators say of a state, beside what is proved of it. Floats: nothing is proved here."""
