"""The value of an expression over any arithmetic: fractions of polynomials, residues, exact numbers, intervals."""
