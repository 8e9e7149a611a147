"""What the checker of certificates reads a declaration with; nothing here is the prover's."""
