"""Expressions that people compile, by `chasles.compile` and by what one would use instead."""
