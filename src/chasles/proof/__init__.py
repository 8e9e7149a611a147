"""TRUTH: an exact decision for every statement, with a certificate that can be checked again, or a counterexample."""
