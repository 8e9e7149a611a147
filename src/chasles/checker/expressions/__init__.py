"""The checker for questions on SymPy expressions: proofs and refutations, verdict, needs and witness together.

It imports SymPy's classes of expressions, as the sentences that it reads, and the checker's polynomials: nothing of the
prover. By SymPy values are put in, products of matrices and determinants are written out, and factors of cases found;
that sides are equal is shown by polynomials alone.
"""
