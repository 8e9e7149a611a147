"""What is said of matrices whose sizes are letters, checked: proofs in the free algebra, and points at numbers."""
