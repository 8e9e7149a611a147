"""Random motions in floating point: at them, what may be true is told apart from what is not; nothing is decided."""
