"""Expressions rewritten in words: terms, products, places and rates. Knows the vocabulary alone."""
