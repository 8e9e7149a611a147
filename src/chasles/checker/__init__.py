"""Certificates and counterexamples checked again, by what imports nothing of the prover: declarations and integers."""
