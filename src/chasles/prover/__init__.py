"""The decision: division by what is known gives a certificate; a remainder, the search for a counterexample."""
