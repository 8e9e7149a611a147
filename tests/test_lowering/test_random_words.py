"""Whatever expression is written, its program is proved equal to it, kept in structure or written in components."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st

from chasles.lowering.builder import Builder
from chasles.lowering.divisors import divisors_of
from chasles.lowering.equivalence.requests import differences
from chasles.lowering.expansion import Expansion
from chasles.lowering.lower import program_of
from chasles.lowering.passes.prune import pruned
from chasles.lowering.program import Argument, Program, Result
from chasles.lowering.refusal import LoweringError
from chasles.lowering.request import Output, composed
from chasles.lowering.rewriting import flipped
from chasles.prover.decide import decide_problem
from chasles.statements import Claim, nonzero, problem_of
from chasles.vocabulary import (
    CPM,
    Cofactor,
    Identity,
    Power,
    Rate,
    Transpose,
    Zero,
    column,
    cos,
    cross,
    det,
    dot,
    norm,
    number,
    over,
    paren,
    row,
    scalar,
    sin,
    square,
    tr,
    vect,
    vector,
)
from chasles.vocabulary.differentiation import NoRule, rate_of

from ..sampling import WHOLE

x, phi = scalar("x", "x", "number"), scalar("phi", r"\phi", "angle")
a, b = vector("a", "a", "vector"), vector("b", "b", "vector")
M, R = square("M", "M", "matrix"), square("R", "R", "matrix of a rule")
OF = (x, phi, a, b, M)
RULES = {R: a @ b.T + cos(phi) * CPM(a) + x * Identity(3)}
DIVISORS = st.sampled_from([1 + dot(a, a), 2 * norm(b), 1 - cos(phi), paren(x * x) ** 2, -x])


def scalars(depth):
    if depth == 0:
        return st.sampled_from([x, number(2), over(1, 3), cos(phi), sin(phi / 2), cos(phi - 2 * phi)])
    lower, vectors, matrices = scalars(depth - 1), columns(depth - 1), squares(depth - 1)
    return st.one_of(
        lower,
        st.builds(lambda s, t: s * t - t, lower, lower),
        st.builds(lambda s: Power(paren(s), 2), lower),
        st.builds(dot, vectors, vectors),
        st.builds(lambda u, m, v: paren(u).T @ m @ v, vectors, matrices, vectors),
        st.builds(lambda u: norm(u) ** 2, vectors),
        st.builds(tr, matrices),
        st.builds(det, st.sampled_from([M, R, CPM(a) + M])),
    )


def columns(depth):
    if depth == 0:
        return st.sampled_from([a, b, a - b, Zero(3, 1), column(1, 0, x)])
    lower, numbers, matrices = columns(depth - 1), scalars(depth - 1), squares(depth - 1)
    return st.one_of(
        lower,
        st.builds(cross, lower, lower),
        st.builds(lambda s, u: -(s * u), numbers, lower),
        st.builds(lambda u, s: u / s, lower, DIVISORS),
        st.builds(lambda m, u: m @ u, matrices, lower),
        st.builds(lambda m, u: (paren(u).T @ m).T, matrices, lower),
        st.builds(lambda m, n, u: paren(m + n @ m).T @ u, matrices, matrices, lower),
        st.builds(vect, matrices),
        st.builds(lambda m, u, s: row(m, s * u) @ column(u, s), matrices, lower, numbers),
    )


def squares(depth):
    if depth == 0:
        return st.sampled_from([M, R, Identity(3), Zero(3, 3), CPM(a), a @ b.T])
    lower, numbers, vectors = squares(depth - 1), scalars(depth - 1), columns(depth - 1)
    return st.one_of(
        lower,
        st.builds(lambda m, n: m - n, lower, lower),
        st.builds(lambda m, n: m @ n, lower, lower),
        st.builds(lambda s, m: s * m, numbers, lower),
        st.builds(lambda m, s: m / s, lower, DIVISORS),
        st.builds(lambda u, v: u @ paren(v).T, vectors, vectors),
        st.builds(CPM, vectors),
        st.builds(Transpose, lower),
        st.builds(lambda m: Power(paren(m), 2), lower),
        st.builds(Cofactor, lower),
        st.builds(lambda u, v, w: 2 * row(u, v, w), vectors, vectors, vectors),
    )


def asked(value):
    """The request for the value, with the arguments that it uses."""
    of = list(OF)
    while True:
        try:
            return composed("f", of, (Output("z", "", value),), rules=RULES)
        except LoweringError as error:
            unused = next(s for s in of if f"the argument {s.name}:" in str(error))
            of.remove(unused)
            if not of:
                return None


def in_components(request, dense):
    expansion = Expansion(Builder(), request, dense=dense)
    (output,) = request.outputs
    rows = expansion.rows(output.value)
    arguments = tuple(Argument(s.name, tuple(k for k in s.shape if k > 1), "") for s in request.of)
    entries = tuple(entry for line in rows for entry in line)
    return pruned(Program("f", arguments, expansion.builder.steps, (Result("z", (len(entries),), "", entries),)))


def holds(left, right):
    claim = Claim("1", left, right, assuming=tuple(map(nonzero, divisors_of(left, {}))))
    return decide_problem(problem_of(claim)).true


@settings(max_examples=150 if WHOLE else 50, deadline=None)
@given(st.one_of(scalars(2), columns(2), squares(2)))
def test_program_is_what_the_words_say(value):
    request = asked(value)
    if request is None:
        return
    assert differences(request, program_of(request)) == ()
    assert differences(request, in_components(request, dense=True)) == ()
    assert differences(request, in_components(request, dense=False)) == ()


@settings(max_examples=60 if WHOLE else 20, deadline=None)
@given(st.one_of(columns(2), squares(2)))
def test_a_transpose_carried_inwards_is_the_transpose(value):
    assert holds(flipped(value), Transpose(value))


@settings(max_examples=60 if WHOLE else 20, deadline=None)
@given(st.one_of(scalars(1), columns(1), squares(1)))
def test_the_rate_by_parts_is_the_rate(value):
    try:
        by_parts = rate_of(value)
    except NoRule:
        return
    assert holds(by_parts, Rate(value))
