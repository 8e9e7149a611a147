"""Questions on declared statements: hypotheses, definitions, conditions, their rates, and contradictions on purpose."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from random import Random

from chasles.statements import (
    Always,
    Claim,
    Condition,
    Definite,
    Definition,
    Hypothesis,
    Iff,
    Minimum,
    Statement,
    Theorem,
    definite,
    half_turn,
    nonzero,
    orthonormal,
    perpendicular,
    positive,
    rotation,
    symmetric,
    unit,
    unit_column,
)
from chasles.vocabulary import CPM, Misfit, Node, Symbol, cross, det, dot, norm, number, rate, tr

from .declared_words import NOTHING, ONE, named, random_vector, same, scaled, slipped, spun
from .hypotheses import meaning
from .statements import Asked

__all__ = ["FAMILIES", "question"]

a, b, c, e, f, u, v, w = (named("vector", name) for name in ("a", "b", "c", "e", "f", "u", "v", "w"))
Q, R, M, N = (named("square", name) for name in "QRMN")
m, k = (named("scalar", name) for name in "mk")
VECTORS: tuple[Node, ...] = (a, b, c, e, u)


@dataclass(frozen=True)
class Scene:
    """Hypotheses, what is given beside them, and names for rates."""

    assuming: tuple[Hypothesis, ...]
    given: tuple[Statement, ...] = ()
    rates: tuple[tuple[Node, Node], ...] = ()


def _rates_named(
    symbols: Sequence[Symbol], draw: Random, deep: bool
) -> tuple[list[Statement], list[tuple[Node, Node]]]:
    """Definitions of the rates of symbols, perhaps of the second ones too."""
    given: list[Statement] = []
    rates: list[tuple[Node, Node]] = []
    for place, symbol in enumerate(symbols):
        kind = {(1, 1): "scalar", (3, 1): "vector", (3, 3): "square"}[symbol.shape]
        first = named(kind, f"{symbol.name}1", 1)
        given.append(Definition(f"{place + 1}.1", rate(symbol), first))
        rates.append((symbol, first))
        if deep and draw.random() < 0.6:
            second = named(kind, f"{symbol.name}2", 2)
            whole = rate(first) if draw.random() < 0.5 else rate(rate(symbol))
            given.append(Definition(f"{place + 1}.2", whole, second))
            rates.append((first, second))
    return given, rates


def scene(draw: Random, moving: bool = True) -> Scene:
    """One or two hypotheses that can all hold, with some of the rates named."""
    ways: list[tuple[tuple[Symbol, ...], Callable[..., Hypothesis]]] = [
        ((e,), unit), ((Q,), rotation), ((M,), symmetric), ((u, v, w), orthonormal), ((a, b), perpendicular),
        ((N,), definite), ((R,), half_turn), ((m, c), unit_column),
    ]  # fmt: skip
    chosen = draw.sample(ways, draw.choice((1, 1, 2)))
    # Motions of several rotations take long to find.
    deep = sum(len(subjects) * subjects[0].shape[1] for subjects, _ in chosen) < 4 and draw.random() < 0.6
    given: list[Statement] = []
    rates: list[tuple[Node, Node]] = []
    if moving:
        for subjects, _ in chosen:
            if draw.random() < 0.8:
                more, names = _rates_named(subjects, draw, deep)
                given += more
                rates += names
    return Scene(tuple(make(*subjects) for subjects, make in chosen), tuple(given), tuple(rates))


def consequence(draw: Random) -> Asked:
    """A true one: what a hypothesis says, differentiated so often, times something, beside something else."""
    while True:
        found = scene(draw)
        rates = dict(found.rates)
        left, right = draw.choice(meaning(draw.choice(found.assuming)))
        try:
            for _ in range(draw.choice((0, 1, 1, 2))):
                left, right = spun(left, rates), spun(right, rates)
            if draw.random() < 0.35:
                claim = Claim("9", slipped(left, draw), right, given=found.given, assuming=found.assuming)
                return Asked(claim, "consequence")
            difference = scaled(left - right, draw, VECTORS) if draw.random() < 0.5 else left - right
            claim = Claim("9", difference, difference - difference, given=found.given, assuming=found.assuming)
            return Asked(claim, "consequence", True)
        except Misfit:
            continue


def identity(draw: Random) -> Asked:
    """An equation of vectors and matrices, the same in other words, or with a slip."""
    x, y = (random_vector(draw, VECTORS, 1) for _ in range(2))
    left, right, assuming = draw.choice((
        (cross(x, cross(y, a)), dot(x, a) * y - dot(x, y) * a, ()),
        (CPM(e) @ CPM(e) @ x, dot(e, x) * e - x, (unit(e),)),
        (Q @ cross(x, y), cross(Q @ x, Q @ y), (rotation(Q),)),
        (norm(cross(x, y)) ** 2, norm(x) ** 2 * norm(y) ** 2 - dot(x, y) ** 2, ()),
        (dot(M @ x, y), dot(x, M @ y), (symmetric(M),)),
        (dot(u, x) * u + dot(v, x) * v + dot(w, x) * w, x, (orthonormal(u, v, w),)),
        (R @ R @ x, x, (half_turn(R),)),
        (det(Q), number(1), (rotation(Q),)),
        (tr(x @ y.T), dot(x, y), ()),
        (m * x / m, x, (nonzero(m),)),
        (norm(m * x), m * norm(x), (positive(m),)),
        (dot(cross(a, b), x), -dot(cross(a, x), b), (perpendicular(a, b),)),
        (norm(a + b) ** 2, norm(a) ** 2 + norm(b) ** 2, (perpendicular(a, b),)),
        (norm(c) ** 2, 1 - m**2, (unit_column(m, c),)),
    ))  # fmt: skip
    if draw.random() < 0.3:
        assuming = ()
    for _ in range(draw.randint(0, 2)):
        left, right = same(left, draw), same(right, draw)
    if draw.random() < 0.3:
        right = slipped(right, draw)
    return Asked(Claim("9", left, right, assuming=assuming), "identity")


def by_definition(draw: Random) -> Asked:
    """Symbols that definitions and conditions determine, with hypotheses on them or on what they are made of."""
    x = random_vector(draw, (a, b, e), 1)
    way = draw.randrange(6)
    assuming: tuple[Hypothesis, ...] = (unit(e),)
    given: tuple[Statement, ...] = (Definition("1", c, x),)
    if way == 0:
        left, right = dot(c, cross(e, a)), dot(x, cross(e, a))
    elif way == 1:
        given = (Condition("1", 2 * c, x, on=(c,)),)
        left, right = c + c, x
    elif way == 2:
        given = (Condition("1", e, a, on=(a,)),)
        left, right = dot(a, a), number(draw.choice((1, 1, 2)))
    elif way == 3:
        given = (Condition("1", e, a, on=(a,)),)
        left, right = dot(a, rate(a)), draw.choice((0, 1, 1)) * dot(b, rate(a))
    elif way == 4:
        given = (Definition("1", c, x), Definition("2", rate(c), named("vector", "c1", 1)))
        left, right = rate(x), named("vector", "c1", 1) * draw.choice((1, 1, 2))
    else:
        given = (Definition("1", rate(e), cross(named("vector", "omega", 1), e)),)
        left, right = dot(e, rate(e)), draw.choice((0, 0, 1)) * dot(named("vector", "omega", 1), e)
    if draw.random() < 0.3:
        right = slipped(right, draw)
    return Asked(Claim("9", left, right, given=given, assuming=assuming), "definition")


def contradictory(draw: Random) -> Asked:
    """Hypotheses, definitions and conditions that nothing satisfies."""
    n = draw.choice((2, 3, -2))
    given, assuming = draw.choice((
        ((Definition("1", f, n * e),), (unit(e), unit(f))),
        ((Definition("1", m, number(-1)),), (positive(m),)),
        ((Definition("1", m, -k),), (positive(m), positive(k))),
        ((Definition("1", m, NOTHING),), (nonzero(m),)),
        ((Definition("1", f, e),), (unit(e), unit(f), perpendicular(e, f))),
        ((Definition("1", Q, -ONE),), (rotation(Q),)),
        ((Definition("1", Q, 2 * R),), (rotation(Q), rotation(R))),
        ((Definition("1", M, CPM(e)),), (symmetric(M), unit(e))),
        ((Definition("1", N, -ONE),), (definite(N),)),
        ((Definition("1", u, v),), (orthonormal(u, v, w),)),
        ((Definition("1", Q, ONE),), (half_turn(Q),)),
        ((Definition("1", rate(e), named("scalar", "k1", 1) * e),), (unit(e), nonzero(named("scalar", "k1", 1)))),
        ((Condition("1", f, n * e, on=(f,)),), (unit(e), unit(f))),
        ((Definition("1", w, cross(v, u)),), (orthonormal(u, v, w),)),
        ((Definition("1", m, dot(e, e) + 1), Definition("2", c, e)), (unit_column(m, c), unit(e))),
    ))  # fmt: skip
    subjects = [s for h in assuming for s in h.subjects if isinstance(s, Symbol)]
    some = draw.choice(subjects)
    left: Node = some if draw.random() < 0.4 else a
    right: Node = draw.choice((left, 2 * left, same(left, draw)))
    if draw.random() < 0.3:
        left, right = a, b
    claim = Claim("9", left, right, given=given, assuming=assuming)
    return Asked(claim, "contradictory", satisfiable=False)


def theorem(draw: Random) -> Asked:
    """What a theorem may say: equivalences, minima, sums of squares."""
    x = random_vector(draw, (a, b), 1)
    sign = draw.choice((1, 1, 1, -1, 2))
    forms, assuming = draw.choice((
        ((Iff(a, Q @ a, Q, Q.T),), (rotation(Q),)),
        ((Iff(a, m * a, m, 1 / m),), (nonzero(m),)),
        ((Iff(a, sign * m * a, m, 1 / m),), (nonzero(m),)),
        ((Iff(m, k, k / m, m / k),), (nonzero(m), nonzero(k))),
        ((Always(dot(e, e), number(1)), Always(cross(e, e), a - a)), (unit(e),)),
        ((Minimum(norm(c - x) ** 2, NOTHING, c, x, (sign * (c - x),)),), ()),
        ((Minimum(norm(c - m * e) ** 2, norm(c) ** 2 - dot(c, e) ** 2, m, dot(c, e), (m - sign * dot(c, e),)),),
         (unit(e),)),
        ((Definite(norm(a) ** 2 + sign * m**2, (norm(a) ** 2, m**2)),), ()),
    ))  # fmt: skip
    return Asked(Theorem("9", "says so", forms, assuming=assuming), "theorem")


Family = Callable[[Random], Asked]
FAMILIES: tuple[tuple[Family, int], ...] = (
    (consequence, 4), (identity, 3), (by_definition, 3), (contradictory, 2), (theorem, 1),
)  # fmt: skip


def question(draw: Random) -> Asked:
    """A statement of one of the families; what does not fit together is drawn anew."""
    families, weights = zip(*FAMILIES, strict=True)
    while True:
        try:
            return draw.choices(families, weights)[0](draw)  # type: ignore[no-any-return]
        except Misfit:
            continue
