"""Pages that a person reads, in the terminal, as HTML, as LaTeX and in notebooks, and records that a program reads."""
