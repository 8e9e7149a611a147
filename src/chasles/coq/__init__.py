"""Verdicts as theorems for Coq: statements for people to read, and proofs from the certificates."""
