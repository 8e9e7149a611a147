"""Inputs that are apt to break a kernel, thrown at every build of it, and each result decided right or wrong."""
