"""Programs of formulas in which the length of a vector is an angle: proved equal, right in numbers; no others are."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from chasles.decisions.session import Session
from chasles.lowering.arithmetic import decimals, run
from chasles.lowering.declaration import requested
from chasles.lowering.equivalence.requests import differences
from chasles.lowering.lower import program_of
from chasles.lowering.program import Op, Program
from chasles.lowering.request import Request
from chasles.numerics.reference import evaluate
from chasles.statements import Claim, Entry, Kernel, Section, nonzero
from chasles.vocabulary import (
    CPM,
    Identity,
    Node,
    cos,
    cross,
    dot,
    norm,
    rate,
    scalar,
    sin,
    symbols_of,
    vector,
)
from chasles.vocabulary.rotation_vectors import exp_of_vector, left_jacobian, right_jacobian

v, w, a = vector("v", "v", "a rotation vector"), vector("w", "w", "another"), vector("a", "a", "any vector")
phi = scalar("phi", r"\phi", "an angle")
n, m = norm(v), norm(w)
FORMULAS: dict[str, Node] = {
    "cosine alone": cos(n),
    "sine alone": sin(n) * a,
    "half": sin(n / 2) / n * v,
    "third": cos(n / 3) * v,
    "twice": cos(2 * n) * v + sin(n) * a,
    "three halves": sin(3 * n / 2) * cos(n / 2) * v,
    "with an angle": cos(n + phi) * v,
    "less half an angle": sin(n - phi / 2) * v,
    "two vectors": cos(n + m) * cross(v, w),
    "two apart": sin(n) * sin(m) * a,
    "length of a multiple": cos(norm(2 * v)) * v,
    "length of the opposite": sin(norm(-v)) / norm(-v) * v,
    "square of the length": n**2 * cos(n) * v,
    "cube of the length": (n - sin(n)) / n**3 * v,
    "exponential": exp_of_vector(v),
    "exponential, applied": exp_of_vector(v) @ a,
    "two exponentials": exp_of_vector(v) @ exp_of_vector(w),
    "left Jacobian": left_jacobian(v),
    "right Jacobian": right_jacobian(v) @ a,
    "Jacobians": left_jacobian(v) @ right_jacobian(v),
    "sum of squares": Identity(3) + sin(n) * CPM(v) + dot(v, v) * CPM(a),
    "rate": rate(exp_of_vector(v)) @ a,
    "rate of the length": rate(sin(n)) * v,
}


def asked(formula: Node) -> Request:
    moving = (
        "rate" in str(formula) or "dot" in str(formula) or formula in (FORMULAS["rate"], FORMULAS["rate of the length"])
    )
    of = [*symbols_of(formula), *([rate(v)] if moving else [])]
    angles = [nonzero(norm(vector)) for vector in (v, w) if vector in of]
    kernel = Kernel(of=tuple(of))
    claim = Claim("1", formula, formula, assuming=tuple(angles), kernel=kernel)
    return requested(Entry("formula", Section("1", "One"), claim), Session().decide, kernel)


@pytest.mark.parametrize("words", FORMULAS)
def test_the_program_is_the_formula(words: str) -> None:
    request = asked(FORMULAS[words])
    program = program_of(request)
    assert differences(request, program) == ()
    draw = np.random.default_rng(5)
    values = {node: draw.standard_normal(node.shape) for node in request.of}
    arithmetic = decimals(40)
    inputs = [[arithmetic.context.mpf(float(x)) for x in values[node].reshape(-1)] for node in request.of]
    found = [float(x) for entries in run(program, inputs, arithmetic) for x in entries]
    expected = np.array(evaluate(FORMULAS[words], values, digits=20), dtype=float).reshape(-1)
    assert found == pytest.approx(expected)


def changed(program: Program) -> list[Program]:
    """The program with one step changed: another function, another sign, another constant."""
    others = {Op.SINE: Op.COSINE, Op.COSINE: Op.SINE, Op.ADD: Op.SUBTRACT, Op.SUBTRACT: Op.ADD, Op.MULTIPLY: Op.ADD}
    found = []
    for place, step in enumerate(program.steps):
        new = replace(step, op=others[step.op]) if step.op in others else None
        if step.op is Op.CONSTANT and step.value not in (0, 1):
            new = replace(step, value=step.value + 1)
        if new is not None:
            found.append(replace(program, steps=(*program.steps[:place], new, *program.steps[place + 1 :])))
    return found


@pytest.mark.sampled(2)
@pytest.mark.parametrize("words", ["half", "with an angle", "two vectors", "exponential", "left Jacobian"])
def test_another_program_is_not(words: str) -> None:
    request = asked(FORMULAS[words])
    program = program_of(request)
    draw = np.random.default_rng(6)
    inputs = [[float(x) for x in draw.standard_normal(node.shape).reshape(-1)] for node in request.of]
    arithmetic = decimals(40)
    exact = [[arithmetic.context.mpf(x) for x in entries] for entries in inputs]
    right = run(program, exact, arithmetic)
    others = changed(program)
    assert len(others) >= 5
    for other in others:
        wrong = run(other, exact, arithmetic)
        apart = max(abs(x - y) for one, two in zip(right, wrong, strict=True) for x, y in zip(one, two, strict=True))
        if not apart < 1e-30:
            assert differences(request, other) != ()
