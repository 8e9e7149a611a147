"""Words fit together exactly when their shapes and dimensions do, and say so when they do not."""

from __future__ import annotations

import copy
import pickle
from collections.abc import Callable
from dataclasses import FrozenInstanceError
from fractions import Fraction
from typing import Any

import mpmath
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from chasles.numerics.reference import Singular, evaluate
from chasles.vocabulary import (
    CPM,
    FORCE,
    FREQUENCY,
    LENGTH,
    MASS,
    MOMENT,
    NO_DIMENSION,
    TIME,
    VELOCITY,
    Block,
    Call,
    Cofactor,
    Contract,
    Dimension,
    Entry,
    Family,
    Identity,
    Index,
    Kronecker,
    Measure,
    Misfit,
    Negative,
    Node,
    Number,
    Scale,
    Sum,
    Symbol,
    Transpose,
    Zero,
    abbreviation,
    array,
    at,
    children,
    column,
    cos,
    cross,
    det,
    dot,
    inverse,
    matrix,
    members_of,
    norm,
    over,
    paren,
    printed,
    rate,
    rebuilt,
    replace,
    row,
    scalar,
    sin,
    square,
    symbols_of,
    tr,
    uniform,
    vect,
    vector,
    walk,
)

f = vector("f", "f", "a force", FORCE)
n = vector("n", "n", "a moment", MOMENT)
a, b = vector("a", "a", "a position", LENGTH), vector("b", "b", "another", LENGTH)
e = vector("e", "e", "a direction")
m = scalar("m", "m", "a mass", MASS)
phi = scalar("phi", r"\phi", "an angle")
Q = square("Q", "Q", "a rotation")
twist = array("t", "t", "a twist", column(e / scalar("T", "T", "", TIME), a / scalar("T", "T", "", TIME)))
i, j = Index("i"), Index("j")
one = Identity(3)

DIMENSIONS = st.sampled_from((NO_DIMENSION, LENGTH, MASS, TIME, FORCE, VELOCITY))
SIZES = st.integers(1, 3)
SHAPES = st.tuples(SIZES, SIZES)


def fits(write: Callable[[], Node]) -> bool:
    try:
        write()
    except Misfit:
        return False
    return True


@st.composite
def symbols(draw: st.DrawFn, name: str, shape: tuple[int, int] | None = None) -> Symbol:
    """A symbol of any shape, all of whose entries have one dimension."""
    rows, columns = shape or draw(SHAPES)
    return Symbol(name, name, uniform((rows, columns), draw(DIMENSIONS)))


@st.composite
def mixed(draw: st.DrawFn, name: str, shape: tuple[int, int]) -> Symbol:
    """A symbol whose entries have any dimensions; some are zeros by construction."""
    entries = st.one_of(st.none(), DIMENSIONS)
    rows, columns = shape
    return Symbol(name, name, Measure(tuple(tuple(draw(entries) for _ in range(columns)) for _ in range(rows))))


def the_dimension(symbol: Symbol) -> Dimension | None:
    return symbol.size.grid[0][0]


# Shapes and dimensions.


def test_a_sum_that_fits_is_measured_without_spelling_it(monkeypatch: pytest.MonkeyPatch) -> None:
    def spelled(self: Node) -> str:
        raise AssertionError("a term was spelled")

    with monkeypatch.context() as patched:
        patched.setattr(Node, "__str__", spelled)
        assert (CPM(a) + a @ e.T + CPM(a)).shape == (3, 3)
        with pytest.raises(AssertionError, match="a term was spelled"):
            a + f
    with pytest.raises(Misfit, match=r"cannot add CPM\(a\) \+ a e\^T \[m\] and f e\^T"):
        CPM(a) + a @ e.T + f @ e.T


@given(symbols("A"), symbols("B"))
def test_a_sum_fits_if_shapes_and_dimensions_agree(A: Symbol, B: Symbol) -> None:
    assert fits(lambda: A + B) == (A.size == B.size) == fits(lambda: A - B)
    if A.size == B.size:
        assert (A + B).measure == A.size


@given(symbols("A"), symbols("B"), symbols("C"))
def test_a_product_fits_if_inner_sizes_agree(A: Symbol, B: Symbol, C: Symbol) -> None:
    expected = A.shape[1] == B.shape[0] and B.shape[1] == C.shape[0]
    assert fits(lambda: A @ B @ C) == expected
    if expected:
        dimensions = (the_dimension(A), the_dimension(B), the_dimension(C))
        product = NO_DIMENSION
        for dimension in dimensions:
            assert dimension is not None
            product = product * dimension
        assert (A @ B @ C).measure == uniform((A.shape[0], C.shape[1]), product) == (A @ (B @ C)).measure
        assert (C.T @ (A @ B).T).measure == (A @ B @ C).T.measure


@given(st.data(), SIZES, SIZES, SIZES)
def test_a_product_fits_if_no_entry_adds_two_dimensions(data: st.DataObject, p: int, q: int, r: int) -> None:
    A, B = data.draw(mixed("A", (p, q))), data.draw(mixed("B", (q, r)))
    found = [
        [
            {x * y for k in range(q) if (x := A.size.grid[u][k]) is not None and (y := B.size.grid[k][v]) is not None}
            for v in range(r)
        ]
        for u in range(p)
    ]
    expected = all(len(dimensions) <= 1 for line in found for dimensions in line)
    assert fits(lambda: A @ B) == expected
    if expected:
        grid = tuple(tuple(next(iter(dimensions), None) for dimensions in line) for line in found)
        assert (A @ B).measure == Measure(grid)
        assert (B.T @ A.T).measure == Measure(grid).transposed


@given(st.data(), SHAPES)
def test_a_zero_fits_every_dimension(data: st.DataObject, shape: tuple[int, int]) -> None:
    A, B = data.draw(mixed("A", shape)), data.draw(mixed("B", shape))
    pairs = [
        (x, y) for one, other in zip(A.size.grid, B.size.grid, strict=True) for x, y in zip(one, other, strict=True)
    ]
    assert fits(lambda: A + B) == all(x is None or y is None or x == y for x, y in pairs)
    assert (A + Zero(*shape)).measure == A.measure


@given(symbols("A"))
def test_transposing_twice_changes_no_measure(A: Symbol) -> None:
    assert A.T.T.measure == A.measure
    assert A.T.shape == A.shape[::-1]


@given(st.data(), st.lists(SIZES, min_size=1, max_size=3), st.lists(SIZES, min_size=1, max_size=3))
def test_blocks_fit_if_heights_and_widths_agree(data: st.DataObject, heights: list[int], widths: list[int]) -> None:
    shapes = {(u, v): (h, w) for u, h in enumerate(heights) for v, w in enumerate(widths)}
    if data.draw(st.booleans()):
        shapes[data.draw(st.sampled_from(sorted(shapes)))] = data.draw(SHAPES)
    blocks = [[data.draw(symbols(f"B{u}{v}", shapes[u, v])) for v in range(len(widths))] for u in range(len(heights))]
    level = all(block.shape[0] == line[0].shape[0] for line in blocks for block in line)
    flush = len({sum(block.shape[1] for block in line) for line in blocks}) == 1
    assert fits(lambda: Block(tuple(map(tuple, blocks)))) == (level and flush)
    if level and flush:
        whole = Block(tuple(map(tuple, blocks)))
        assert whole.shape == (sum(line[0].shape[0] for line in blocks), sum(block.shape[1] for block in blocks[0]))
        assert {d for line in whole.measure.grid for d in line} == {the_dimension(x) for line in blocks for x in line}  # type: ignore[union-attr]


@given(symbols("s"), symbols("A"))
def test_only_a_scalar_scales_and_divides(s: Symbol, A: Symbol) -> None:
    assert fits(lambda: Scale(s, A)) == (s.shape == (1, 1)) == fits(lambda: A / s)
    if s.shape == (1, 1):
        unit, other = the_dimension(s), the_dimension(A)
        assert unit is not None
        assert other is not None
        assert (s * A).measure == (A * s).measure == uniform(A.shape, unit * other)
        assert (A / s).measure == over(A, s).measure == uniform(A.shape, other / unit)


@given(symbols("A"), st.integers(1, 4))
def test_a_power_fits_if_its_base_is_a_square(A: Symbol, exponent: int) -> None:
    assert fits(lambda: A**exponent) == (A.shape[0] == A.shape[1])
    if A.shape[0] == A.shape[1]:
        assert (A**exponent).measure == (A if exponent == 1 else Contract((A,) * exponent)).measure


@given(symbols("A"), symbols("B"))
def test_a_scalar_product_is_that_of_two_columns(A: Symbol, B: Symbol) -> None:
    assert fits(lambda: dot(A, B)) == (A.shape[1] == 1 and A.shape == B.shape)


@given(symbols("A"))
def test_what_asks_for_a_column_or_a_square(A: Symbol) -> None:
    rows, columns = A.shape
    assert fits(lambda: norm(A)) == (columns == 1)
    assert fits(lambda: CPM(A)) == fits(lambda: cross(A, A)) == (A.shape == (3, 1))
    assert fits(lambda: vect(A)) == (A.shape == (3, 3))
    assert fits(lambda: Cofactor(A)) == fits(lambda: det(A)) == (rows == columns)
    assert fits(lambda: tr(A)) == fits(lambda: inverse(A)) == (rows == columns)
    assert fits(lambda: cos(A)) == fits(lambda: sin(A)) == (A.size in (uniform((1, 1)), uniform((1, 1), None)))


# Units: an expression's value, in other units, is what its dimensions say.


@st.composite
def well_formed(draw: st.DrawFn, kind: str, dimension: Dimension, depth: int) -> Node:
    """A random expression of a scalar, vector or square matrix with the given dimension."""
    stem = f"{kind}_{dimension.length}_{dimension.mass}_{dimension.time}".replace("-", "m")
    size = {"scalar": (1, 1), "vector": (3, 1), "matrix": (3, 3)}[kind]
    leaf = Symbol(stem, stem, uniform(size, dimension))
    if depth == 0:
        return leaf
    other = draw(DIMENSIONS)

    def part(which: str, of: Dimension) -> Node:
        return draw(well_formed(which, of, depth - 1))

    ways: list[Callable[[], Node]] = [
        lambda: leaf,
        lambda: part(kind, dimension) - part(kind, dimension),
        lambda: part("scalar", other) * part(kind, dimension / other),
        lambda: part(kind, dimension * other) / Symbol("d", "d", uniform((1, 1), other)),
    ]
    ways += {
        "scalar": [
            lambda: dot(part("vector", other), part("vector", dimension / other)),
            lambda: norm(part("vector", dimension)),
            lambda: tr(part("matrix", dimension)),
            lambda: det(part("matrix", other)) * part("scalar", dimension / other**3),
            lambda: sin(part("scalar", NO_DIMENSION)) * part("scalar", dimension),
            lambda: (
                row(part("scalar", other), part("scalar", TIME))
                @ column(part("scalar", dimension / other), part("scalar", dimension / TIME))
            ),
        ],
        "vector": [
            lambda: part("matrix", other) @ part("vector", dimension / other),
            lambda: cross(part("vector", other), part("vector", dimension / other)),
            lambda: vect(part("matrix", dimension)),
            lambda: column(*(part("scalar", dimension) for _ in range(3))),
        ],
        "matrix": [
            lambda: CPM(part("vector", dimension)),
            lambda: part("vector", other) @ part("vector", dimension / other).T,
            lambda: part("matrix", other) @ part("matrix", dimension / other),
            lambda: inverse(part("matrix", NO_DIMENSION / dimension)),
            lambda: Cofactor(part("matrix", other)) * part("scalar", dimension / other**2),
        ],
    }[kind]
    return draw(st.sampled_from(ways))()


def values_in(units: Dimension, node: Node) -> dict[Node, Any]:
    """Numbers for the symbols, after a change of units: lengths are 2, masses 3, times 5 times as large a number."""
    values: dict[Node, Any] = {}
    for number, symbol in enumerate(sorted(symbols_of(node), key=lambda symbol: symbol.name)):
        flat = [(d, Fraction(7 + (number * 31 + 17 * k) % 23, 11)) for k, d in enumerate(sum(symbol.size.grid, ()))]
        values[symbol] = [x * factor(d, units) for d, x in flat]
    return values


def factor(dimension: Dimension | None, units: Dimension) -> Fraction:
    if dimension is None:
        return Fraction(0)
    lengths = Fraction(2) ** (dimension.length * units.length)
    return lengths * Fraction(3) ** (dimension.mass * units.mass) * Fraction(5) ** (dimension.time * units.time)


@given(st.sampled_from(("scalar", "vector", "matrix")), DIMENSIONS, st.data())
def test_the_measured_dimensions_say_how_a_value_changes_with_the_units(
    kind: str, dimension: Dimension, data: st.DataObject
) -> None:
    node = data.draw(well_formed(kind, dimension, 2))
    units = Dimension(1, 1, 1)
    try:
        before = evaluate(node, values_in(Dimension(), node))
        after = evaluate(node, values_in(units, node))
    except Singular:
        assume(False)
    assert node.measure is not None
    assert node.shape == (len(before), len(before[0]))
    size = max(abs(x) for line in after for x in line)
    for grid, line, other in zip(node.measure.grid, before, after, strict=True):
        for d, x, y in zip(grid, line, other, strict=True):
            scale = factor(d, units)
            assert abs(x * scale.numerator / mpmath.mpf(scale.denominator) - y) <= size * mpmath.mpf(10) ** -12


# What is said when words do not fit.


@pytest.mark.parametrize(
    ("write", "said"),
    [
        (lambda: f + n, ["f [kg m s^-2]", "n [kg m^2 s^-2]", "add"]),
        (lambda: a + e, ["a [m]", "e [no dimension]"]),
        (lambda: a + m, ["a (3 x 1)", "m (a scalar)"]),
        (lambda: a - b + 1, ["a + -b (3 x 1)", "1 (a scalar)"]),
        (lambda: Q @ a.T, ["multiply", "Q (3 x 3)", "a^T (1 x 3)"]),
        (lambda: a @ b.T @ column(a, b), ["b^T (1 x 3)", "[a; b] (6 x 1)"]),
        (lambda: row(a.T @ b, m) @ column(1, 1), ["[m^2]", "[kg]", "one entry"]),
        (lambda: Q * Q, ["Q is not a scalar", "A @ B"]),
        (lambda: a / Q, ["cannot divide a by Q"]),
        (lambda: a / Number(Fraction(0)), ["cannot divide a by zero"]),
        (lambda: a**2, ["a is 3 x 1", "square"]),
        (lambda: m**0, ["exponent of m is 0"]),
        (lambda: dot(Q, a), ["two columns", "Q is 3 x 3", "a is 3 x 1"]),
        (lambda: dot(a, column(a, b)), ["a is 3 x 1", "[a; b] is 6 x 1"]),
        (lambda: norm(twist), ["t has entries of different dimensions", "m s^-1"]),
        (lambda: norm(Q), ["Q is 3 x 3"]),
        (lambda: cross(a, Q), ["a vector (3 x 1)", "Q is 3 x 3"]),
        (lambda: CPM(phi), ["phi is 1 x 1"]),
        (lambda: cos(m), ["cos takes an angle in radians", "m is not one"]),
        (lambda: column(a, Q), ["rows of blocks differ in width", "a is 3 x 1", "Q is 3 x 3"]),
        (lambda: row(a, m), ["in one row of blocks", "a is 3 x 1", "m is a scalar"]),
        (column, ["at least one block"]),
        (lambda: vect(row(a, b)), ["an axial vector", "[a, b] is 3 x 2"]),
        (lambda: det(matrix((a.T @ a, 1), (1, 1))), ["do not go together", "[m^2]", "[no dimension]"]),
    ],
)
def test_an_error_names_both_sides(write: Callable[[], Node], said: list[str]) -> None:
    with pytest.raises(Misfit) as error:
        write()
    assert [words for words in said if words not in str(error.value)] == []


@pytest.mark.parametrize("number", [2.0, "2", None, True])
def test_what_is_not_exact_is_refused(number: Any) -> None:
    for write in (lambda: a * number, lambda: number + a, lambda: a / number, lambda: column(a, number)):
        with pytest.raises(TypeError):
            write()


@pytest.mark.parametrize("exponent", [2.0, Fraction(1, 3), True, phi])
def test_an_exponent_is_a_whole_number(exponent: Any) -> None:
    with pytest.raises(TypeError, match="whole number"):
        phi**exponent


# Dimensions of arrays that mix them.


def test_a_twist_has_an_angular_velocity_above_a_velocity() -> None:
    assert twist.size.grid == ((FREQUENCY,),) * 3 + ((VELOCITY,),) * 3


def test_an_inverse_has_the_inverse_dimensions_zeros_too() -> None:
    transfer = matrix((one, Zero(3, 3)), (CPM(a - b), one))
    back = inverse(transfer)
    assert back.measure is not None
    assert (back @ transfer).measure == (transfer @ back).measure
    assert {d for line in back.measure.grid[3:] for d in line[:3]} == {LENGTH}
    assert det(transfer).measure == uniform((1, 1))
    assert not fits(lambda: inverse(transfer) + Block(((one, Zero(3, 3)), (m * one, one))))


def test_a_determinant_is_measured_along_any_full_diagonal() -> None:
    swapped = matrix((Zero(3, 3), one * m), (one, Zero(3, 3)))
    assert det(swapped).measure == uniform((1, 1), MASS**3)
    assert det(row(a, b, a)).measure == uniform((1, 1), LENGTH**3)


def test_a_rate_is_per_second() -> None:
    assert rate(rate(a)).measure == uniform((3, 1), LENGTH / TIME**2)
    assert rate(phi).measure == uniform((1, 1), FREQUENCY)


def test_units_are_named() -> None:
    assert [str(d) for d in (NO_DIMENSION, LENGTH, FORCE, MOMENT)] == ["no dimension", "m", "kg m s^-2", "kg m^2 s^-2"]


# `printed`.


def test_printed_records_what_does_not_fit() -> None:
    wrong = printed(lambda: a + (m + 1) * e)
    assert wrong.measure is None
    assert wrong.fault == "cannot add m [kg] and 1 [no dimension]"
    assert (wrong @ e.T).fault == wrong.fault
    with pytest.raises(Misfit, match="cannot add m"):
        _ = wrong.shape


def test_printed_is_over_when_it_returns_or_raises() -> None:
    printed(lambda: a + e)
    with pytest.raises(ZeroDivisionError):
        printed(lambda: 1 / 0)  # type: ignore[arg-type, return-value]
    with pytest.raises(Misfit):
        a + e


@given(symbols("A"), symbols("B"))
def test_printed_never_raises_a_misfit_and_records_just_those(A: Symbol, B: Symbol) -> None:
    for write in (lambda: A + B, lambda: A @ B, lambda: Block(((A, B),)), lambda: dot(A, B), lambda: A / B):
        assert (printed(write).fault is None) == fits(write)


# Nodes as values.


def test_equality_is_equality_of_spelling() -> None:
    assert a + b == a + b
    assert a + b != b + a
    assert 2 * a == Scale(Number(Fraction(2)), a) != a + a
    assert over(phi, 2) != phi / 2
    assert paren(a) != a
    assert a != "a"
    assert vector("a", "a", "another meaning", LENGTH) != a


def test_an_author_s_order_is_kept() -> None:
    assert (a + b - a).terms == (a, b, Negative(a))
    assert (a + (b - a)).terms == (a, b - a)  # type: ignore[comparison-overlap]
    assert (1 + phi).terms == (Number(Fraction(1)), phi)
    assert (1 - phi).terms == (Number(Fraction(1)), Negative(phi))
    assert -phi * m == Negative(phi * m)
    assert -Q @ a == Negative(Q @ a)
    assert -phi / 2 == Negative(phi / 2)
    assert a * m == Scale(m, a, trailing=True)
    assert Q @ Q @ a == Contract((Q, Q, a))


def test_a_node_has_no_truth_value() -> None:
    with pytest.raises(TypeError, match=r"no truth value; `==` compares spelling"):
        bool(a)
    with pytest.raises(TypeError, match="no truth value"):
        assert not a + b


def test_nodes_are_hashable_and_frozen() -> None:
    assert len({a + b, a + b, b + a}) == 2
    assert hash(a + b) == hash(a + b)
    with pytest.raises(FrozenInstanceError):
        a.name = "b"  # type: ignore[misc]
    with pytest.raises(FrozenInstanceError):
        (a + b).terms = ()  # type: ignore[misc]


@pytest.mark.parametrize(
    "node", [a, a + b, Q @ (a - b) / 2, printed(lambda: a + e), abbreviation("E", "E", CPM(e), "")]
)
def test_copies_and_pickles_are_equal_and_measured(node: Node) -> None:
    for twin in (copy.copy(node), copy.deepcopy(node), pickle.loads(pickle.dumps(node))):
        assert twin == node
        assert hash(twin) == hash(node)
        assert (twin.measure, twin.fault) == (node.measure, node.fault)


# Walking and replacing.


def test_parts_are_walked_in_reading_order() -> None:
    node = Q @ (a - b) + cross(e, a)
    assert symbols_of(node) == (Q, a, b, e)
    assert [part for part in walk(node) if isinstance(part, Symbol)] == [Q, a, b, e, a]
    assert all(rebuilt(part, children(part)) == part for part in walk(node))


def test_replacing_measures_anew_and_opens_abbreviations() -> None:
    E = abbreviation("E", "E", CPM(e), "")
    assert replace(Q @ a, {a: b}) == Q @ b
    assert replace(E @ a, {a: b}) == E @ b
    assert replace(E @ a, {e: b}) == CPM(b) @ a
    assert replace(rate(a) + rate(b), {rate(a): rate(b)}) == rate(b) + rate(b)
    with pytest.raises(Misfit):
        replace(a + b, {a: e})


def test_an_abbreviation_of_a_constant_is_constant() -> None:
    fixed = vector("a_0", "a_0", "", LENGTH, constant=True)
    assert abbreviation("A", "A", CPM(fixed), "").constant
    assert not abbreviation("A", "A", CPM(a), "").constant


def test_an_equation_with_indices_means_all_its_instances() -> None:
    e_1, e_2, e_3 = (vector(f"e_{k}", f"e_{k}", "") for k in (1, 2, 3))
    e_of = Family(r"\mathbf{e}", (e_1, e_2, e_3))
    instances = members_of(dot(e_of[i], e_of[j]), Kronecker(i, j))
    assert len(instances) == 9
    assert instances[1] == (dot(e_1, e_2), Number(Fraction(0)))
    assert instances[4] == (dot(e_2, e_2), Number(Fraction(1)))
    assert members_of(a, b) == [(a, b)]
    entries = [evaluate(left, {Q: range(9)})[0][0] for left, _ in members_of(Entry(Q, i, j, "q"), Kronecker(i, j))]
    assert entries == list(range(9))


def test_fields_of_time_and_functions_keep_the_measure() -> None:
    assert at(a).measure == paren(a).measure == a.measure
    assert Transpose(a).measure == a.T.measure
    assert Call("sin", phi) == sin(phi)
    assert Sum((a,)).measure == a.measure
