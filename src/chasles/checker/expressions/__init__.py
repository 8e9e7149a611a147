"""The checker for questions on SymPy expressions: proofs and refutations, verdict, needs and witness together.

It imports SymPy's classes of expressions, as the sentences that it reads, and the checker's polynomials: nothing of the
prover, and no algebra of SymPy's.
"""
