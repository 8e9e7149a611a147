"""Exact points that satisfy hypotheses: simple rational ones, and a search where angles and roots have to fit."""
