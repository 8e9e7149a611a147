"""The search for a repair on equations made up for it: each kind of slip, hopeless ones, and a prover that says no."""

from __future__ import annotations

from chasles.statements import Claim, Definition, unit
from chasles.vocabulary import (
    CPM,
    FREQUENCY,
    Identity,
    Zero,
    column,
    cos,
    cross,
    dot,
    norm,
    paren,
    row,
    scalar,
    sin,
    square,
    vector,
)

one, zero = Identity(3), Zero(3, 1)
x, y, z, e = (vector(name, name, "a vector") for name in "xyze")
w = vector("w", "w", "a spin", FREQUENCY)
k, phi, theta = (scalar(name, name, "a scalar") for name in ("k", "phi", "theta"))
M = square("M", "M", "a matrix")
turning = Definition("1", M, e @ e.T + cos(phi) * (one - e @ e.T) + sin(phi) * CPM(e), assuming=(unit(e),))
named = Definition("2", z, column(0, 0, 1))

SLIPS: list[tuple[str, Claim, str]] = [
    ("number", Claim("9", CPM(x) @ CPM(x), x @ x.T - 2 * dot(x, x) * one), "x x^T - x . x 1"),
    ("sign", Claim("9", cross(x, cross(y, z)), dot(x, z) * y + dot(x, y) * z), "(x . z) y - (x . y) z"),
    ("term", Claim("9", CPM(x) @ CPM(x), x @ x.T), "x x^T - (x . x) 1"),
    ("order", Claim("9", CPM(x) @ y, cross(y, x)), "x x y"),
    ("transpose", Claim("9", CPM(x) @ CPM(x), x.T @ x * one - paren(x.T @ x) * one), ""),
    ("function", Claim("9", M @ x, dot(e, x) * e + sin(phi) * (x - dot(e, x) * e) + sin(phi) * cross(e, x)), ""),
    ("letter", Claim("9", CPM(x) @ y, cross(x, z)), "x x y"),
    ("power", Claim("9", norm(x) ** 2, norm(x) ** 3), "|x|^2"),
    ("sign in a norm", Claim("9", norm(x + y) ** 2, norm(x - y) ** 2), ""),
    ("block", Claim("9", column(x, y), column(x, 2 * y)), "[x; y]"),
    ("blocks", Claim("9", row(x, cross(x, y)), row(x, cross(x, y))), ""),
]
