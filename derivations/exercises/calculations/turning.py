"""A body that turns at unit rate about one of its principal axes: its moment of inertia in fixed axes, to be drawn."""

from __future__ import annotations

from typing import Any

import sympy as sp

from chasles.exercises.picture import Graph

_degrees = sp.Symbol("degrees", real=True)
_angle = sp.pi * _degrees / 180
_spin = sp.Matrix([[0, -1, 0], [1, 0, 0], [0, 0, 0]])
_turn = sp.Matrix([[sp.cos(_angle), -sp.sin(_angle), 0], [sp.sin(_angle), sp.cos(_angle), 0], [0, 0, 1]])
_inertia = _turn * sp.diag(1, 3, 3) * _turn.T
_rate = _spin * _inertia - _inertia * _spin


def graph_of_rate() -> Graph:
    """I_xx, its slope, and the same entry of Omega I - I Omega, over a turn; the principal moments are 1, 3 and 3."""
    slope = sp.diff(_inertia[0, 0], _degrees) * 180 / sp.pi
    curves = (("I_xx", _inertia[0, 0]), ("d I_xx / dt", slope), ("(Omega I - I Omega)_xx", _rate[0, 0]))
    return _over_a_turn(*curves)


def graph_of_difference() -> Graph:
    """For the fixed vector x = (1, 2, 0), x . (dI/dt) x and 2 x . Omega I x, over a turn."""
    x = sp.Matrix([1, 2, 0])
    matrices = (("x . (dI/dt) x", _rate), ("2 x . Omega I x", 2 * _spin * _inertia))
    return _over_a_turn(*((name, (x.T * matrix * x)[0, 0]) for name, matrix in matrices))


def _over_a_turn(*curves: tuple[str, Any]) -> Graph:
    return Graph("angle of a body that turns at unit rate about Z, in degrees", _degrees, (0, 360), curves, least=None)
