"""Polynomial rings, fractions over declared nonzero factors, Groebner bases, surds. Knows nothing of statements."""
