"""NUMBERS: kernels against 50-digit evaluations of the statements they come from. Nothing here decides what is true."""
