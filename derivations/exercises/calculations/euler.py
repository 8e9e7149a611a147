"""Euler angles of Exercise 3.10: the symbols of its derivation by name, and where the determinant vanishes."""

from __future__ import annotations

from typing import Any

import sympy as sp

from chasles.exercises.picture import Graph
from chasles.statements import Definition
from chasles.statements.derivation import Derivation, Substitute
from chasles.vocabulary import Call, Negative, Node, Symbol, plain, symbols_of


def definitions_of(road: Derivation) -> tuple[Definition, tuple[Definition, ...]]:
    """The rotation by the angles, and the axes by their components."""
    first = next(step for step in road.steps if isinstance(step, Substitute) and step.statements)
    (rotation,) = first.statements
    assert isinstance(rotation, Definition)
    return rotation, tuple(axis for axis in first.using if isinstance(axis, Definition))


def symbols_by_name(*nodes: Node) -> dict[str, Symbol]:
    """The symbols that occur."""
    return {symbol.name: symbol for node in nodes for symbol in symbols_of(node)}


def symbolic(name: str) -> Any:
    """A symbol for a number that is not given."""
    return sp.Symbol(name, real=True)


def conditioning(determinant: Node) -> Graph:
    """|det W| and the condition number of W over the second angle, in degrees.

    The second axis is normal to the others; W^T W has the eigenvalues 1 and 1 +- g, g the cosine between these, and
    g^2 + (det W)^2 = 1: the ratio of the largest and the smallest singular value is (1 + |g|) / |det W|.
    """
    degrees = sp.Symbol("theta_2", real=True)
    turn = sp.pi * degrees / 180
    size, cosine = abs(sp.sin(turn)), abs(sp.cos(turn))
    if "cos" in singular_set(determinant):
        size, cosine = cosine, size
    curves = (("|det W|", size), ("condition number of W", (1 + cosine) / size))
    return Graph("second angle in degrees", degrees, (0, 360), curves, most=8)


def singular_set(determinant: Node) -> str:
    """Where plus or minus the sine or the cosine of an angle vanishes, in words; raises TypeError for another node."""
    match determinant:
        case Negative(term):
            return singular_set(term)
        case Call("sin", angle):
            return f"sin({plain(angle)}) = 0: {plain(angle)} = n*pi for an integer n"
        case Call("cos", angle):
            return f"cos({plain(angle)}) = 0: {plain(angle)} = pi/2 + n*pi for an integer n"
        case _:
            raise TypeError(f"{plain(determinant)} is neither a sine nor a cosine")
