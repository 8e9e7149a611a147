"""A problem as polynomials: its variables, its ring, its hypotheses, and what may be divided by."""
