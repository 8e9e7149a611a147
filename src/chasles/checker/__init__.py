"""Certificates and counterexamples checked again, by what shares nothing with the prover: declarations and integers."""
