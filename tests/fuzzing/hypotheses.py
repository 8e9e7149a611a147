"""What named hypotheses mean, by their names: equations, where to look for them, and what is no equation."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random
from typing import Any

import numpy as np

from chasles import vocabulary as w
from chasles.statements import Hypothesis

from .node_values import Words, entries_of
from .series import Undefined, mpf

__all__ = ["Pair", "beginning", "in_domain", "meaning"]

Pair = tuple[w.Node, w.Node]


def meaning(h: Hypothesis) -> list[Pair]:
    """A named hypothesis as equations, by what its name says."""
    one, zero, identity = w.number(1), w.number(0), w.Identity(3)
    match h.kind, h.subjects:
        case "unit", (e,):
            return [(w.dot(e, e), one)]
        case "unit column", parts:
            return [(w.Sum(tuple(w.Dot(p, p) for p in parts)), one)]
        case "perpendicular", (a, b):
            return [(w.dot(a, b), zero)]
        case "symmetric" | "definite", (m,):
            return [(m, m.T)]
        case "rotation", (q,):
            return [(q.T @ q, identity)]
        case "orthonormal", triad:
            return [(w.dot(a, b), w.number(int(a == b))) for a in triad for b in triad]
        case "half_turn", (q,):
            return [(q, q.T), (q.T @ q, identity), (w.tr(q), w.number(-1))]
    return []


def beginning(
    hypotheses: Sequence[Hypothesis], symbols: Sequence[w.Symbol], draw: Random
) -> dict[tuple[w.Symbol, int, int], float]:
    """Where to begin: rotations near rotations, positive scalars positive, definite matrices definite."""
    found = {(s, i, j): draw.uniform(-2, 2) for s in symbols for i, j in entries_of(s)}
    for h in hypotheses:
        subjects = [s for s in h.subjects if isinstance(s, w.Symbol)]
        if h.kind == "positive" and subjects:
            found[subjects[0], 0, 0] = abs(found[subjects[0], 0, 0]) + 0.1
        elif h.kind in ("rotation", "orthonormal", "half_turn", "definite"):
            matrix = _special(h.kind, draw)
            for i in range(3):
                for j in range(3):
                    found[(subjects[j], i, 0) if h.kind == "orthonormal" else (subjects[0], i, j)] = matrix[i, j]
    return found


def _special(kind: str, draw: Random) -> Any:
    any_matrix = np.array([[draw.uniform(-1, 1) for _ in range(3)] for _ in range(3)])
    if kind == "definite":
        return any_matrix @ any_matrix.T + 0.3 * np.eye(3)
    turn, _ = np.linalg.qr(any_matrix)
    turn = turn * np.linalg.det(turn)
    return turn @ np.diag([1.0, -1.0, -1.0]) @ turn.T if kind == "half_turn" else turn


def in_domain(hypotheses: Sequence[Hypothesis], words: Words) -> bool:
    """Whether what is no equation holds too: what is positive, does not vanish, turns, or is definite."""
    small = mpf(10) ** -30
    for h in hypotheses:
        try:
            match h.kind:
                case "positive":
                    if not words.scalar(h.subjects[0]) > small:
                        return False
                case "nonzero":
                    if abs(words.scalar(h.subjects[0])) < small:
                        return False
                case "rotation":
                    if not words.scalar(w.det(h.subjects[0])) > 0:
                        return False
                case "orthonormal":
                    if not words.scalar(w.dot(w.cross(*h.subjects[:2]), h.subjects[2])) > 0:
                        return False
                case "definite":
                    m = [[x[0] for x in row] for row in words(h.subjects[0])]
                    minors = (m[0][0], m[0][0] * m[1][1] - m[0][1] * m[1][0], words.scalar(w.det(h.subjects[0])))
                    if not min(minors) > small:
                        return False
        except Undefined:
            return False
    return True
