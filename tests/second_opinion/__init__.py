"""An opinion on verdicts that shares nothing with the prover: explicit motions in 400 digits, rates as differences."""
