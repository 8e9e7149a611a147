"""PAGES: what a person reads in the terminal, and the records that a machine reads."""
