"""Where slip from a whole box of states ends."""
