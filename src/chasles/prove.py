"""The prover for SymPy users: is an equation between SymPy expressions true?"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from functools import partial
from math import inf
from time import monotonic
from typing import Any

import sympy
from sympy.polys.polyerrors import BasePolynomialError

from chasles.algebra.work_limit import OutOfTime, within
from chasles.checker.any_size.of_sympy import check_at_any_size, has_letters_for_sizes
from chasles.checker.sparse import Rejected, well_formed
from chasles.from_sympy.any_size import verdict_at_any_size
from chasles.from_sympy.bounded_symbols import COMPARED, Said
from chasles.from_sympy.calls import Calls
from chasles.from_sympy.complex_symbols import expressions_in
from chasles.from_sympy.components import claimed, is_implication, relation_of, without_implication
from chasles.from_sympy.exponents import require_moderate
from chasles.from_sympy.handed_in import as_said, possible_verdict, readings_of, require_no_imaginary, require_possible
from chasles.from_sympy.induction import counts
from chasles.from_sympy.inequalities import definitions
from chasles.from_sympy.methods import WAYS, check
from chasles.from_sympy.monotone import plainer
from chasles.from_sympy.opening import excerpt
from chasles.from_sympy.sufficient import of_values, where_it_rises, with_name, without_inverse
from chasles.problems.variables import Untreatable
from chasles.verdict import Contradictory, Fails, Holds, HoldsUnder, Undecided, Verdict
from chasles.vocabulary import Misfit

__all__ = ["Rejected", "Untreatable", "prove", "recheck"]

FAILURES = (
    ArithmeticError, AttributeError, LookupError, NotImplementedError, TypeError, ValueError, BasePolynomialError,
)  # fmt: skip
"""What SymPy raises where it does not treat an expression."""
EFFORT = 1e7
"""The work that a question may take, in products of terms."""


def prove(
    lhs: Any, rhs: Any = None, given: Any = (), nonzero: Any = (), budget: float = inf, exact: bool = False
) -> Verdict:
    """The verdict on `lhs == rhs`, for all real values of the symbols that satisfy the side conditions.

    Symbols that are `complex=True` have all complex values, and the verdict speaks of their parts `re_z` and `im_z`.
    Where a conjugate or a part is taken of others, the verdict says that they are real. Square roots are the
    nonnegative ones and are meant where they are real, fractions where no divisor vanishes. Functions that are not
    known may have any values, also at expressions, as f(x - c*t) and its derivatives, and they have integrals.

    Args:
        lhs: a SymPy scalar or matrix, whose sizes may be letters, as in MatrixSymbol("A", n, n); a vector, dyadic or
            quaternion of SymPy's, a list or an array, which are read by their components, those of both sides in one
            frame; or alone, an equation, an inequality, or what joins some by And, Or, Not, Implies, Equivalent, ITE.
        rhs: one of the same shape.
        given: equations that hold, as `Eq(a, b)` or as expressions or matrices that are zero, one or a list of them,
            or the values of symbols as `{x: 1}`; between functions of time they hold at all times. Inequalities, and
            what joins some, may be among them; of `a > b` the verdict speaks as a = b + d_1, with a positive symbol
            d_1, of `a < x < b` as x = (a + b d_1)/(1 + d_1), of `a <= x <= b` as
            x = a + (b - a) (1 + d_1)^2/(2 + 2 d_1^2) with any d_1, and of an angle between two multiples of pi by its
            tangent, sine or direction.
        nonzero: scalars that do not vanish. Divisors need not be named: the verdict's `needs` lists them.
        budget: seconds after which the verdict is `Undecided`. Without it only the work is limited, so that the verdict
            does not depend on the machine.
        exact: whether a floating-point number is read as the decimal number that it is written as, 0.1 as 1/10; else
            it is refused.

    Returns:
        `Holds` or `HoldsUnder(needs)`, with a certificate that `recheck` checks; `Fails`, with an exact counterexample;
        `Contradictory`, if nothing satisfies the side conditions; `IllFormed`, if the shapes differ; or `Undecided`.
        The first three have a method `coq` that writes a theorem for Coq.

    Raises:
        Untreatable: a ValueError that names what is not treated.
    """
    given, nonzero = (tuple(each) if isinstance(each, Iterator) else each for each in (given, nonzero))
    verdict: Verdict | Untreatable
    end = monotonic() + budget
    try:
        verdict = _proved(lhs, rhs, given, nonzero, budget, exact)
    except Untreatable as error:
        verdict = error
    for way in _other_ways(lhs, rhs, given) if isinstance(verdict, Contradictory | Undecided | Untreatable) else ():
        with suppress(Untreatable):
            other = _proved(lhs, rhs, given, nonzero, max(end - monotonic(), 0), exact, **way)
            if isinstance(other, Holds | HoldsUnder) or (isinstance(other, Fails) and not _only_proves(way)):
                return other
    if isinstance(verdict, Untreatable):
        raise verdict
    return verdict


def _other_ways(lhs: Any, rhs: Any, given: Any) -> Iterator[Mapping[str, Any]]:
    """How else a claim is read: an implication as a whole, for its premise may not hold; a relation by others."""
    if is_implication(lhs, rhs, given):
        yield {"whole": True}
    with suppress(RecursionError, Rejected, *FAILURES):
        claim, given = without_implication(relation_of(lhs, rhs), given)
        if isinstance(claim, COMPARED) and any(map(counts, claim.atoms(sympy.Pow, sympy.factorial))):
            yield {"counted": True}
        for said in (plainer, with_name, where_it_rises, without_inverse) if rhs is None else (without_inverse,):
            with suppress(RecursionError, Rejected, *FAILURES):
                if said(claim) is not claim:
                    yield {"other": said}
        for sufficient in of_values(claim, given):
            yield {"other": partial(_instead, sufficient)}


def _instead(sufficient: Any, _claim: Any) -> Any:
    return sufficient


def _only_proves(way: Mapping[str, Any]) -> bool:
    """Whether a claim that is read so follows from what is read, and not the other way round."""
    return way.get("other") not in (None, plainer)


def _proved(
    lhs: Any, rhs: Any, given: Any, nonzero: Any, budget: float, exact: bool, counted: bool = False, **way: Any
) -> Verdict:
    """The verdict on a claim as it is read in one way; powers are products where they may be `counted`."""
    try:
        require_moderate(expressions_in([lhs, rhs, given, nonzero]))
        said = as_said(exact, lhs, rhs, given, nonzero, **way)
        of_any_size = has_letters_for_sizes(expressions_in(said))
        calls = Calls(said)
        with within(seconds=budget):
            readings = zip(WAYS[:1] * 3 if counted else WAYS, readings_of(calls.said, counted), strict=False)
            ways = [(verdict_at_any_size, said)] if of_any_size else readings
            verdict, asked = _first_decided(ways, calls)
    except RecursionError as error:
        raise Untreatable("it is nested too deeply, or SymPy does not come to an end with it") from error
    except FAILURES as error:
        if not isinstance(error, Misfit) and not _raised_in_sympy(error):
            raise
        what = excerpt(lhs) if rhs is None else f"{excerpt(lhs)} = {excerpt(rhs)}"
        said_by = f": {error}" if str(error) else ""
        raise Untreatable(f"{what} is not treated, {type(error).__name__}{said_by}") from error
    if not isinstance(verdict, Holds | HoldsUnder | Fails):
        return verdict
    poles = sorted(f"{e} != 0" for e in set(expressions_in(asked[3])) - set(expressions_in(said)))
    used = [text for text in (*definitions(said, asked), *calls.defined) if text not in verdict.needs]
    used += [text for text in poles if text in verdict.unused]
    if used and not isinstance(verdict, Fails):
        unused = tuple(text for text in verdict.unused if text not in used)
        verdict = HoldsUnder((*used, *verdict.needs), verdict.certificate, verdict.witness, unused)
    lhs, rhs = (relation_of(lhs, rhs), None) if "other" in way else (lhs, rhs)
    return replace(verdict, asked=(*said, claimed(lhs, rhs, given, **way)))


def _first_decided(ways: Iterable[tuple[Callable[..., Verdict], Said]], calls: Calls) -> tuple[Verdict, Said]:
    """The first reading that is decided, and the verdict; or what is said of the first one."""
    left: list[tuple[Verdict | Untreatable, Said]] = []
    for decide, asked in ways:
        try:
            with within(EFFORT):
                verdict = possible_verdict(decide, asked, calls)
        except OutOfTime as error:
            left.append((Undecided(str(error)), asked))
        except Rejected as error:
            left.append((Undecided(f"it is not read by the checker: {error}"), asked))
        except Untreatable as error:
            left.append((error, asked))
        else:
            if not isinstance(verdict, Undecided):
                return verdict, asked
            left.append((verdict, asked))
    if not left:
        raise Untreatable("nothing is a product up to an integer")
    found, asked = left[0]
    if isinstance(found, Untreatable):
        raise found
    return found, asked


def _raised_in_sympy(error: BaseException) -> bool:
    """Whether SymPy does not treat what it was handed, such as a function of no argument."""
    trace = error.__traceback__
    while trace is not None and trace.tb_next is not None:
        trace = trace.tb_next
    return trace is not None and str(trace.tb_frame.f_globals.get("__name__")).startswith("sympy.")


def recheck(
    verdict: Verdict, lhs: Any, rhs: Any = None, given: Any = (), nonzero: Any = (), exact: bool = False
) -> None:
    """The verdict of `prove` on this question is right: nothing of the prover is used.

    A certificate proves what was asked from the verdict's `needs`, which the witness satisfies; a counterexample
    satisfies what is given, and the two sides differ there. Raises `Rejected` with the reason if not.
    """
    given, nonzero = (tuple(each) if isinstance(each, Iterator) else each for each in (given, nonzero))
    ways: list[Mapping[str, Any]] = [{}, *_other_ways(lhs, rhs, given)]
    reasons: list[Exception] = []
    for way in ways:
        if isinstance(verdict, Fails) and _only_proves(way):
            continue
        try:
            return _recheck(verdict, exact, lhs, rhs, given, nonzero, **way)
        except (Untreatable, Rejected) as reason:
            reasons.append(reason)
    raise Rejected(str(reasons[0])) from None


def _recheck(verdict: Verdict, exact: bool, *asked: Any, counted: bool = False, **way: Any) -> None:
    said = as_said(exact, *asked, **way)
    if has_letters_for_sizes(expressions_in(said)):
        with well_formed("verdict"):
            check_at_any_size(verdict, *said)
        return
    calls = Calls(said)
    if not isinstance(verdict, Holds | HoldsUnder | Fails):
        raise TypeError(f"the verdict is {verdict.name}: only what holds or fails can be checked")
    reasons = []
    for read in readings_of(calls.said, counted):
        try:
            with well_formed("verdict"):
                require_no_imaginary(calls.said, read)
                _check_reading(verdict, [*definitions(said, read), *calls.defined], read)
                require_possible(verdict, calls)
            return
        except Rejected as reason:
            reasons.append(reason)
    raise reasons[0] if reasons else Rejected("nothing is a product up to an integer")


def _check_reading(verdict: Holds | HoldsUnder | Fails, equations: Iterable[str], asked: Said) -> None:
    for text in equations:
        if not isinstance(verdict, Fails) and text not in verdict.needs:
            raise Rejected(f"the verdict is on {text}, and does not say so")
    check(verdict, asked)
