"""Exact numbers for exercises: fields with roots and angles, eigenvalues, principal axes. No question is decided here.

Numbers are computed with in three ways, each where the others are too slow or too narrow: towers of square roots
(`tower`), whose signs follow from their terms; the same over rational functions of numbers that no root expresses
(`grounds`); and fields with one primitive element (`fields`), for roots of any small degree, as of eigenvalues.
"""
