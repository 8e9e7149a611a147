"""Exact numbers and geometry: fields with roots and angles, lines, bodies, principal axes."""
