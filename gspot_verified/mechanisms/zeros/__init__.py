"""All zeros of functions in a box, each proved unique."""
