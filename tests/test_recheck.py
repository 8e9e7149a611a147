"""The check of what `prove` says: right verdicts pass, forged ones and those of a broken prover are rejected."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from copy import deepcopy
from dataclasses import replace
from fractions import Fraction
from itertools import product
from typing import Any

import pytest
import sympy as sp
from sympy import Abs, Eq, Matrix, atan, cos, eye, pi, sign, sin, sqrt, tan

from chasles.checker.expressions.reals import Reals
from chasles.checker.sparse import number
from chasles.from_sympy import given as given_equations
from chasles.from_sympy import reader as readers
from chasles.from_sympy import roots
from chasles.from_sympy.divisors import DivisorText
from chasles.from_sympy.given_equations import Equations, SideConditions
from chasles.prove import Rejected, prove, recheck
from chasles.verdict import Counterexample, Fails, Holds, HoldsUnder

a, b, c, x, y, z, t = sp.symbols("a b c x y z t")
p = sp.Symbol("p", positive=True)
k = sp.Symbol("k", negative=True)
f, g, theta = (sp.Function(name)(t) for name in ("f", "g", "theta"))
e = Matrix(sp.symbols("e1:4"))
e_t = Matrix([sp.Function(name)(t) for name in ("e1", "e2", "e3")])
R = Matrix(3, 3, sp.symbols("r1:4(1:4)"))
rotation = [R.T * R - eye(3), Eq(R.det(), 1)]
u, v = (Matrix(sp.symbols(f"{name}1:4")) for name in "uv")

PROVED: list[tuple[Any, Any, list[Any]]] = [
    (Abs(b + pi) ** 2, (b + pi) ** 2, []),
    (sqrt(pi) * sqrt(z), sqrt(pi * z), []),
    (sign(a) ** 2, 1, [Eq(cos(a), 0)]),
    (pi * x * cos(x), x * pi * cos(x), []),
    (sqrt(x) * sqrt(y), sqrt(x * y), []),
    (sqrt(x) * sqrt(y) * sqrt(x + 1), sqrt(x * y * (x + 1)), []),
    (Abs(x * y) / y, Abs(x) * sign(y), []),
    (sqrt(x**2 / y**2), Abs(x) / Abs(y), []),
    (sqrt(3 + 2 * sqrt(2)) * x, x + sqrt(2) * x, []),
    (sin(x + pi / 8) ** 2 + cos(x + pi / 8) ** 2, 1, []),
    (tan(x / 2), sin(x) / (1 + cos(x)), []),
    (1 / (sqrt(p) + 1), (sqrt(p) - 1) / (p - 1), []),
    (x / (1 + 1 / x), x**2 / (x + 1), []),
    (x, y, [Eq((x - y) ** 2, 0)]),
    (x * y, 1, [Eq(x, 1), Eq(y, x**2)]),
    (sin(a + b), sin(c), [Eq(a + b + c, pi)]),
    (R * u.cross(v), (R * u).cross(R * v), rotation),
    (e_t.dot(e_t.diff(t, 2)), -e_t.diff(t).dot(e_t.diff(t)), [Eq(e_t.dot(e_t), 1)]),
    (f.diff(t, 3), -f.diff(t), [Eq(f.diff(t), g), Eq(g.diff(t), -f)]),
    (f * f.diff(t), g * g.diff(t), [Eq(f, sqrt(g**2 + 1))]),
    (p, 1, [Eq(p**2, 1)]),
]  # fmt: skip
REFUTED: list[tuple[Any, Any, list[Any]]] = [
    (sqrt(x**2), x, []),
    (Abs(x + pi), x + pi, []),
    (sin(x), x, []),
    (x * cos(x), x * sin(x), []),
    (sqrt(x), y, [Eq(y**2, x)]),
    (1 / x, x, []),
    (Abs(k), k, []),
    (R * u.cross(v), (R * v).cross(R * u), rotation),
    (f.diff(t, 2), f, [Eq(f.diff(t), g), Eq(g.diff(t), -f)]),
    (e_t.dot(e_t.diff(t, 2)), 0, [Eq(e_t.dot(e_t), 1)]),
]

GRID = [*(sp.Rational(k, 2) for k in range(-5, 6)), -pi, pi]


def name(case: Any) -> str:
    return " ".join(str(case).split())[:50]


def proved(lhs: Any, rhs: Any, given: list[Any]) -> Holds | HoldsUnder:
    verdict = prove(lhs, rhs, given=given)
    assert isinstance(verdict, Holds | HoldsUnder), verdict
    return verdict


def rejected(verdict: Any, lhs: Any, rhs: Any, given: Any = ()) -> None:
    with pytest.raises(Rejected):
        recheck(verdict, lhs, rhs, given=given)


def follows(need: str, rest: tuple[str, ...]) -> bool:
    """Whether the need is satisfied at all points of a grid at which the rest is."""
    said = [
        (sp.sympify(e), {">=": sp.Ge, "!=": sp.Ne}[sign]) for e, sign, _ in (n.rsplit(" ", 2) for n in (*rest, need))
    ]
    names = sorted({name for e, _ in said for name in e.free_symbols}, key=str)
    points = (dict(zip(names, values, strict=True)) for values in product(GRID, repeat=len(names)))
    held = [[bool(relation(e.subs(point), 0)) for e, relation in said] for point in points]
    return any(held_here[-1] for held_here in held) and all(last for *others, last in held if all(others))


def accepted(verdict: Any, lhs: Any, rhs: Any, given: Any) -> bool:
    try:
        recheck(verdict, lhs, rhs, given=given)
    except Rejected:
        return False
    return True


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("lhs", "rhs", "given"), PROVED, ids=name)
def test_a_proof_is_accepted_and_no_other_claim_with_it(lhs: Any, rhs: Any, given: list[Any]) -> None:
    verdict = proved(lhs, rhs, given)
    recheck(verdict, lhs, rhs, given=given)
    more = sp.ones(*lhs.shape) if isinstance(lhs, sp.MatrixBase) else 1
    rejected(verdict, lhs, rhs + more, given)
    for place in range(len(given)) if (sign(a) ** 2, 1) != (lhs, rhs) else ():
        rejected(verdict, lhs, rhs, [*given[:place], *given[place + 1 :]])


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("lhs", "rhs", "given"), PROVED, ids=name)
def test_a_need_that_is_left_out_is_missed(lhs: Any, rhs: Any, given: list[Any]) -> None:
    verdict = proved(lhs, rhs, given)
    for place, need in enumerate(verdict.needs):
        less = (*verdict.needs[:place], *verdict.needs[place + 1 :])
        without = HoldsUnder(less, verdict.certificate, verdict.witness)
        if accepted(without, lhs, rhs, given):
            assert follows(need, less)
            continue
        if "cases" not in verdict.certificate:
            rejected(replace(verdict, needs=(*less, need.replace("x", "q"), "q != 0")), lhs, rhs, given)
    if verdict.needs:
        rejected(Holds(verdict.certificate, verdict.witness), lhs, rhs, given)


def altered(certificate: dict[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    """Certificates with one thing that is wrong."""

    def made(change: Callable[[dict[str, Any]], object]) -> dict[str, Any]:
        changed = deepcopy(dict(certificate))
        change(changed)
        return changed

    for variant in (99, -1, 2, "0", None, 1.5, True, []):
        yield f"variant {variant!r}", made(lambda d, value=variant: d.update(variant=value))
    yield "a part that says nothing", made(lambda d: d.update(unknown=1))
    for part in certificate:
        if part == "roots":
            # What a word is the root of may be said there once more.
            continue
        yield f"without {part}", made(lambda d, key=part: d.pop(key))
        for nonsense in (None, "nonsense", 3, {"a": "b"}, [["a"]]):
            yield f"{part}: {nonsense!r}", made(lambda d, key=part, value=nonsense: d.update({key: value}))
    for coordinate, value in certificate["witness"].items():
        if coordinate != "pi":
            yield f"{coordinate} left out", made(lambda d, key=coordinate: d["witness"].pop(key))
        for other in (f"{value} + 1", "nonsense", "1/0", "q"):
            yield f"{coordinate} = {other}", made(lambda d, key=coordinate, new=other: d["witness"].update({key: new}))
    for label, said in certificate.get("entries", {}).items():
        yield f"entry {label} left out", made(lambda d, key=label: d["entries"].pop(key))
        for fact, cofactor in said.get("cofactors", {}).items():
            cofactors = made(lambda d: None)
            for new in (f"{cofactor} + 1", f"2*{cofactor}" if cofactor[0] != "-" else "0", "0"):
                cofactors["entries"][label]["cofactors"][fact] = new
                yield f"cofactor {new} of {fact}", deepcopy(cofactors)
            for wrong in (f"{fact} d1", f"{fact} d40", "given 7 1,1", fact.replace(" 1,1", " 9,9 d1")):
                if wrong == fact:
                    continue
                entry = {key: text for key, text in said["cofactors"].items() if key != fact} | {wrong: cofactor}
                yield (
                    f"{wrong} for {fact}",
                    made(lambda d, key=label, new=entry: d["entries"][key].update(cofactors=new)),
                )
        for divisor, power in said.get("times", {}).items():
            for new in (power + 1, 0, -1, "1", True) if said.get("cofactors") else (0, -1, "1", True):
                if new is not True or power != 1:
                    yield (
                        f"power {new!r}",
                        made(lambda d, key=label, at=divisor, n=new: d["entries"][key]["times"].update({at: n})),
                    )
    for place in range(len(certificate.get("divisors", ()))):
        if any(str(place) in said.get("times", {}) for said in certificate.get("entries", {}).values()):
            yield "another divisor", made(lambda d, at=place: d["divisors"].__setitem__(at, f"{d['divisors'][at]} + 7"))
    for place, (word, kind, inside) in enumerate(certificate.get("words", ())):
        for other in ([word, "cube", inside], [word, kind, f"{inside} + 1"], [word, kind, "-3"]):
            yield f"word {other}", made(lambda d, at=place, new=other: d["words"].__setitem__(at, new))
    for place, (square, factors) in enumerate(certificate.get("roots", ())):
        for other in ([square, [*factors, "-1"]], [square, [*factors, "2"]], [f"{square} + 1", factors]):
            yield f"root {other}", made(lambda d, at=place, new=other: d["roots"].__setitem__(at, new))


@pytest.mark.sampled(7)
@pytest.mark.parametrize(("lhs", "rhs", "given"), PROVED, ids=name)
def test_an_altered_certificate_is_rejected(lhs: Any, rhs: Any, given: list[Any]) -> None:
    verdict = proved(lhs, rhs, given)
    for what, certificate in altered(dict(verdict.certificate)):
        try:
            recheck(replace(verdict, certificate=certificate), lhs, rhs, given=given)
        except Rejected:
            continue
        pytest.fail(f"accepted: {what}")


@pytest.mark.sampled(7)
@pytest.mark.parametrize(("lhs", "rhs", "given"), PROVED, ids=name)
def test_an_altered_witness_is_rejected(lhs: Any, rhs: Any, given: list[Any]) -> None:
    verdict = proved(lhs, rhs, given)
    for key, value in verdict.witness.items():
        for other in (value + 1, None, "1", 0.5):
            rejected(replace(verdict, witness={**verdict.witness, key: other}), lhs, rhs, given)


@pytest.mark.sampled(5)
@pytest.mark.parametrize(("lhs", "rhs", "given"), REFUTED, ids=name)
def test_a_counterexample_is_accepted_and_no_other(lhs: Any, rhs: Any, given: list[Any]) -> None:
    verdict = prove(lhs, rhs, given=given)
    assert isinstance(verdict, Fails), verdict
    recheck(verdict, lhs, rhs, given=given)
    found = verdict.counterexample
    rejected(verdict, lhs, lhs, given)
    for other in (
        replace(found, entry=(9, 9)),
        replace(found, left=f"{found.left} + 1"),
        replace(found, right="nonsense"),
        replace(found, at={}),
    ):
        rejected(Fails(other), lhs, rhs, given)


def test_what_is_given_holds_at_a_counterexample_with_its_rates() -> None:
    equation = Eq(theta.diff(t, 2), -theta)
    claim = theta.diff(t, 2) + theta + sin(theta), sin(theta)
    at = {"theta(t)": Fraction(0), "Derivative(theta(t), (t, 2))": Fraction(1)}
    at |= {"cos(theta(t))": Fraction(1), "sin(theta(t))": Fraction(0)}
    rejected(Fails(Counterexample(at, (1, 1), "1", "0")), *claim, given=[equation])
    third = {"f(t)": Fraction(1), "Derivative(f(t), t)": Fraction(1), "Derivative(f(t), (t, 2))": Fraction(5)}
    rejected(Fails(Counterexample(third, (1, 1), "5", "1")), f.diff(t, 2), f, given=[Eq(f.diff(t), f)])
    skipped = {"f(t)": Fraction(1), "Derivative(f(t), t)": Fraction(1), "Derivative(f(t), (t, 3))": Fraction(5)}
    rejected(Fails(Counterexample(skipped, (1, 1), "5", "1")), f.diff(t, 3), f, given=[Eq(f.diff(t), f)])


@pytest.fixture
def unchecked(monkeypatch: pytest.MonkeyPatch) -> None:
    """`prove` shows what was found without having it checked."""
    monkeypatch.setattr("chasles.from_sympy.methods._followed", lambda verdict, asked: verdict)


BROKEN_SIGNS = [(sqrt(x**2), x), (sqrt(x**2 * y**2), x * y), (sqrt((x + y) ** 2), x + y)]


@pytest.mark.usefixtures("unchecked")
@pytest.mark.parametrize(("lhs", "rhs"), BROKEN_SIGNS, ids=name)
def test_a_prover_that_takes_everything_for_nonnegative(lhs: Any, rhs: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(roots._Resolver, "_is_nonnegative", lambda *_: True)
    rejected(proved(lhs, rhs, []), lhs, rhs)


@pytest.mark.usefixtures("unchecked")
def test_a_prover_that_loses_a_domain(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(roots._Resolver, "_is_nonnegative", lambda *_: True)
    verdict = proved(sqrt(x) * sqrt(y), sqrt(x * y), [])
    assert not verdict.needs
    rejected(verdict, sqrt(x) * sqrt(y), sqrt(x * y))


@pytest.mark.usefixtures("unchecked")
def test_a_prover_with_the_wrong_sign_of_roots(monkeypatch: pytest.MonkeyPatch) -> None:
    right = roots._Resolver._square_free

    def negative(self: Any, context: Any, polynomial: Any) -> Any:
        return readers.multiplied([roots.Number(Fraction(-1)), right(self, context, polynomial)])

    monkeypatch.setattr(roots._Resolver, "_square_free", negative)
    square = (x**4 + 2 * x**2 * y**2 + y**4, -(x**2) - y**2)
    rejected(proved(sqrt(square[0]), square[1], []), sqrt(square[0]), square[1])
    rejected(proved(sqrt(square[0]) * y, square[1] * y, []), sqrt(square[0]) * y, square[1] * y)


@pytest.mark.usefixtures("unchecked")
def test_a_prover_that_takes_for_given_what_is_not(monkeypatch: pytest.MonkeyPatch) -> None:
    right = given_equations._state_triads

    def more(result: SideConditions) -> None:
        right(result)
        result.equations.append(Equations("x = y", [(x, y)], ("x = y",)))

    monkeypatch.setattr(given_equations, "_state_triads", more)
    rejected(proved(x, y, [Eq(z, 1)]), x, y, [Eq(z, 1)])


@pytest.mark.usefixtures("unchecked")
def test_a_prover_that_hides_a_divisor(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(readers, "divisor_of", lambda e, _: DivisorText(f"{e} != 0", evident=True))
    verdict = proved(1 / (x - 1) - 1 / (x + 1), 2 / (x**2 - 1), [])
    assert not verdict.needs
    rejected(verdict, 1 / (x - 1) - 1 / (x + 1), 2 / (x**2 - 1))


def test_a_broken_prover_says_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    assert prove(sqrt(x**2) * y, sp.Abs(x) * y).true
    monkeypatch.setattr(roots._Resolver, "_is_nonnegative", lambda *_: True)
    for lhs, rhs in BROKEN_SIGNS:
        assert not prove(lhs, rhs).true


def test_real_numbers_are_told_apart() -> None:
    reals = Reals()
    two, three = (reals.root(number(n)) for n in (2, 3))
    assert reals.vanishes(reals.root(number(3) + two * number(2)) - number(1) - two)
    assert reals.vanishes(reals.root(number(2) + two) * reals.root(number(2) - two) - two)
    assert reals.vanishes(reals.root(reals.pi * number(Fraction(1, 4))) * number(2) - reals.root(reals.pi))
    assert reals.sign(three - two - number(Fraction(3, 10))) == 1
    assert reals.sign(reals.pi - number(Fraction(355, 113))) == -1
    assert reals.sign(reals.arctangent(Fraction(1, 3)) - number(Fraction(32175, 100000))) == 1
    with pytest.raises(Rejected, match="negative"):
        reals.root(number(1) - two)


def test_a_logarithm_to_a_base_is_not_read_as_the_natural_one() -> None:
    rejected(Fails(Counterexample({}, (1, 1), "log(8)", "3")), sp.log(8, 2, evaluate=False), sp.Integer(3))


def test_what_cases_need_follows_from_what_all_need_or_holds_at_the_witness() -> None:
    real = sp.Symbol("x", real=True)
    asked = sp.acsc(real), (pi / 2 - sp.atan(sqrt(real**2 - 1))) * sqrt(real**2) / real
    verdict = prove(*asked)
    assert set(verdict.needs) == {"x != 0", "x**2 - 1 >= 0"}
    recheck(verdict, *asked)
    with pytest.raises(Rejected, match="not so at the witness"):
        recheck(replace(verdict, needs=(*verdict.needs, "x - 1 >= 0", "-x - 1 >= 0")), *asked)


def test_an_integer_is_no_irrational_number() -> None:
    """Where only enclosures tell what the sides are, what SymPy assumes of a symbol holds of its value, too."""
    n = sp.Symbol("n", integer=True)
    told = "sin(sqrt(2)*pi/2)**2*cos(sqrt(2)*pi/2)**2"
    rejected(Fails(Counterexample({"n": sqrt(2)}, (1, 1), told, "0")), (sin(pi * n / 2) * cos(pi * n / 2)) ** 2, 0)


def test_the_root_of_a_quotient_is_that_of_the_whole_quotient_at_a_point() -> None:
    time, scale = sp.symbols("t p")
    motion = sp.Function("f")(time)
    size = sqrt(motion**2 + 1 / scale**2)
    rate, right = sp.Derivative(size, time), motion * motion.diff(time) / size
    assert prove(rate, right).true
    at = {"p": Fraction(3), "f(t)": Fraction(1, 4), "Derivative(f(t), t)": Fraction(1)}
    with pytest.raises(Rejected):
        recheck(Fails(Counterexample(at=at, entry=(1, 1), left="9/5", right="3/5", goal="")), rate, right)
    wrong = motion * motion.diff(time) / sqrt(motion**2 * scale**2 + 1)
    recheck(prove(rate, wrong), rate, wrong)


def test_a_quotient_that_is_not_negative_says_nothing_of_its_numerator() -> None:
    x, p = sp.symbols("x p")
    cubed, product = sqrt(x) ** 3 / p, x * sqrt(x) / p
    verdict = prove(cubed, product)
    assert verdict.needs == ("p != 0", "x >= 0")
    with pytest.raises(Rejected):
        recheck(replace(verdict, needs=("p != 0", "x/p >= 0")), cubed, product)
    of_quotient = sqrt(x / p) ** 3, x / p * sqrt(x / p)
    recheck(replace(prove(*of_quotient), needs=("p != 0", "x/p >= 0")), *of_quotient)


@pytest.mark.parametrize(("lhs", "rhs"), [(sqrt(x) ** 2 * x, x**2), (Abs(x), sp.Max(x, -x)), (x / x, 1)], ids=name)
def test_a_proof_without_a_witness_is_rejected(lhs: Any, rhs: Any) -> None:
    with pytest.raises(Rejected, match="no witness"):
        recheck(replace(prove(lhs, rhs), witness=None), lhs, rhs)


@pytest.mark.parametrize(
    "text",
    ["factorial(10**9)", "gamma(10**9) - gamma(10**9)", "prime(10**9)", "chebyshevt(99999, x)", "integrate(x, x)",
     "solve(x)", "polygamma(10**6, 1)", "expand((x + 1)**999)"],
)  # fmt: skip
def test_a_certificate_does_not_set_sympy_to_work(text: str) -> None:
    """What is said to be a fact may speak of functions that are read, and of no others: SymPy would come to no end."""
    lhs, rhs = cos(pi / 7) - cos(2 * pi / 7) + cos(3 * pi / 7), sp.Rational(1, 2)
    verdict = prove(lhs, rhs)
    with pytest.raises(Rejected):
        recheck(replace(verdict, certificate={**verdict.certificate, "facts": [text]}), lhs, rhs)


N = sp.Symbol("N", integer=True, positive=True)
A, B = (sp.MatrixSymbol(letter, N, N) for letter in "AB")
OF_ALL_KINDS: list[tuple[Any, Any, list[Any]]] = [
    (p, 1, [p >= 1, p <= 1]),
    (Abs(x), sp.Max(x, -x), []),
    (A.T * B.T, (B * A).T, []),
    (A * B, B * A, []),
    (sqrt(x**2), x, []),
]
NO_VERDICT: tuple[Any, ...] = (None, 5, "nonsense", [7], (None,), 1.5)


@pytest.mark.parametrize(("lhs", "rhs", "given"), OF_ALL_KINDS, ids=name)
def test_what_is_no_verdict_is_rejected_and_fails_in_no_other_way(lhs: Any, rhs: Any, given: list[Any]) -> None:
    verdict = prove(lhs, rhs, given=given)
    recheck(verdict, lhs, rhs, given=given)
    for odd in NO_VERDICT:
        if isinstance(verdict, Fails):
            rejected(Fails(odd), lhs, rhs, given)
            for part in ("at", "entry", "left", "right"):
                rejected(Fails(replace(verdict.counterexample, **{part: odd})), lhs, rhs, given)
            continue
        assert isinstance(verdict, Holds | HoldsUnder)
        rejected(HoldsUnder(odd, verdict.certificate, verdict.witness), lhs, rhs, given)
        rejected(replace(verdict, certificate=odd), lhs, rhs, given)
        rejected(replace(verdict, witness=odd), lhs, rhs, given)
        for key in verdict.witness:
            rejected(replace(verdict, witness={**verdict.witness, key: odd}), lhs, rhs, given)


def test_an_angle_of_very_many_turns_is_no_witness() -> None:
    for lhs, rhs in ((tan(x / 2), sin(x) / (1 + cos(x))), (sin(x) ** 2 + cos(x) ** 2, sp.Integer(1))):
        verdict = proved(lhs, rhs, [])
        for many in (10**400, 10**4000, Fraction(1, 3) + 10**1000):
            rejected(replace(verdict, witness={"x": many}), lhs, rhs)


def test_an_angle_is_not_halved_without_end() -> None:
    asked = atan(p) + atan(1 / p), pi / 2
    verdict = proved(*asked, [])
    assert "turned" in verdict.certificate
    for times in (-1, 10**400, 10**9, "10", None):
        certificate = {**verdict.certificate, "turned": {"1,1": times}}
        rejected(replace(verdict, certificate=certificate), *asked)
