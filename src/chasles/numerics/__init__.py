"""NUMBERS."""
