"""What a few exercises compute with besides the book's equations: bodies and their moments, lines, quadrics, graphs."""
