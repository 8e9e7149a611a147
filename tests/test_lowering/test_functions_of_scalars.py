"""Kernels of statements with functions of scalars, with pi, and with angles that are products."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import mpmath
import pytest

from chasles.coq.kernels import claim_of_kernel
from chasles.decisions.session import Session
from chasles.lowering.arithmetic import Decimals, evaluated
from chasles.lowering.declaration import requested
from chasles.lowering.equivalence.requests import differences
from chasles.lowering.lower import program_of
from chasles.lowering.program import Op, Program
from chasles.lowering.request import Request
from chasles.numerics.reference import evaluate
from chasles.statements import Definition, Kernel
from chasles.vocabulary import PI, Node, cos, dot, norm, scalar, sin, symbols_of, vector
from chasles.vocabulary.functions import (
    arccos,
    arccosh,
    arcsin,
    arcsinh,
    arctan,
    arctanh,
    atan2,
    cosh,
    exp,
    log,
    maximum,
    minimum,
    sinh,
    sqrt,
    tanh,
)

x, y, z, result = (scalar(name, name, "a number") for name in ("x", "y", "z", "f"))
u, v = (vector(name, name, "a vector") for name in "uv")
EXPRESSIONS: list[Node] = [
    sqrt((x**4 + y**4) / (x**2 + y**2)),
    PI * sqrt((x**4 * u.x**2 + y**4) / (x**2 + y**2 * u.y**2)),
    arccos(dot(u, v) / (norm(u) * norm(v))) + arcsin(x / 5),
    atan2(y, x) + PI / 2 - arctan(z),
    cos(norm(v) * x) * exp(-(x * y)) + sin(norm(v) * x / 2),
    cos(x + PI / 2) + cos(2 * PI * x / 3) + sin(x * y) - cos(x * y / 2),
    maximum(x, y, z) - minimum(x, y, z) * abs(z),
    log(x) / sqrt(y) + sqrt(sqrt(x) + y) * sqrt(x),
    tanh(x) + sinh(y) * cosh(z) + exp(x) ** 2,
    cos(arccos(x / 4)) + sqrt(norm(v) ** 2 + x**2),
    2 * PI * sqrt(x**3 / y) + 4 * PI / 3,
    (x**2 + 1) ** Fraction(3, 2) * arcsinh(y) + arctanh(x / 4) * arccosh(2 * y) / y ** Fraction(1, 2),
]


def made(expression: Node) -> tuple[Request, Program]:
    """The request for an expression as a function of its symbols, and its program."""
    kernel = Kernel(of=tuple(s for s in symbols_of(expression) if s != PI), name="function")
    request = requested(Definition("1", result, expression, kernel=kernel), Session().decide)
    return request, program_of(request)


@pytest.mark.parametrize("expression", EXPRESSIONS, ids=str)
def test_a_program_with_functions_is_proved_and_has_the_values_of_the_words(expression: Node) -> None:
    request, program = made(expression)
    assert not differences(request, program)
    assert claim_of_kernel("1", request, program)[0].why_not.startswith("it has functions")
    context = mpmath.mp.clone()
    context.dps = 30
    entries = [Fraction(7, 5), Fraction(9, 7), Fraction(-11, 13)]
    at = {
        node: [[entries[(i + k) % 2 if k < 2 else 2]] for i in range(node.shape[0])]
        for k, node in enumerate(request.of)
    }
    (number,) = program.results[0].entries
    found = evaluated(program.steps, Decimals(context), lambda k, i: at[request.of[k]][i][0] + context.mpf(0))[number]
    assert abs(found - context.mpf(str(evaluate(expression, at, {}, 30)[0][0]))) < context.mpf(10) ** -25


@pytest.mark.parametrize("expression", EXPRESSIONS, ids=str)
def test_another_function_is_not_taken_for_it(expression: Node) -> None:
    """The careless program takes another function, or the same of other numbers; scales may be what they like."""
    request, program = made(expression)
    other = {
        "exp": "cosh",
        "fabs": "exp",
        "log": "exp",
        "tanh": "sinh",
        "asinh": "sinh",
        "acosh": "asinh",
        "atanh": "tanh",
        "sinh": "cosh",
        "cosh": "sinh",
    }
    turned = {Op.SINE: Op.COSINE, Op.COSINE: Op.SINE}
    for number, step in enumerate(program.steps):
        wrong = replace(step, op=turned.get(step.op, step.op), function=other.get(step.function, ""))
        if step.op is Op.ARCTANGENT2 or (step.op is Op.SELECT and "max" in str(expression)):
            wrong = replace(step, operands=(*step.operands[:-2], *step.operands[:-3:-1]))
        if wrong != step and number != 0:
            steps = (*program.steps[:number], wrong, *program.steps[number + 1 :])
            assert differences(request, replace(program, steps=steps))
