"""Whether what is found would be found of letters of the other kind that they may be, where the kinds are proposed.

What holds of scalars alone may fail of matrices and operators, whose products have an order; what fails of vectors may
hold of scalars, whose products are printed with a cross, too, or of symmetric matrices.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace as with_fields
from functools import reduce

from chasles import vocabulary as w
from chasles.pages.consequences import Consequences
from chasles.pages.premises import PosedEquation
from chasles.pages.quantities import Quantity, quantity, symbols_in
from chasles.reading.spellings import multiplied
from chasles.repairs.repair import Repair
from chasles.statements import Claim, Condition, Hypothesis, Statement
from chasles.vocabulary.functions import FunctionOf
from chasles.vocabulary.tree import rebuilt

SHAPES = {"matrix": (3, 3), "scalar": (1, 1)}
"""The other kinds that a letter may be, and the shape in which they are tried."""
ANALYTIC = ("exp", "sin", "cos", "tan", "sinh", "cosh", "tanh")
Kinds = Mapping[w.Symbol, w.Symbol]
ASSUMED = Hypothesis("posed", (), free=True)


def doubt_of_truth(claim: Claim, consequences: Consequences) -> str:
    """Of which kind letters must be for a proved claim, where it does not follow of matrices; empty for no doubt."""
    kinds = {symbol: other for symbol, other in _in_doubt(claim).items() if symbol.is_scalar}
    return _told(kinds) if kinds and _follows(claim, kinds, consequences) is False else ""


def doubt_of_falsity(claim: Claim, instead: Repair | None, consequences: Consequences) -> str:
    """The same for a claim that fails: where it follows of other kinds, or what is true instead does not."""
    meant = with_fields(claim, left=instead.left, right=instead.right) if instead else claim
    found = _in_doubt(claim)
    for is_same in (False, True):
        kinds = {symbol: other for symbol, other in found.items() if (other.shape == symbol.shape) is is_same}
        is_meant = instead is None or not kinds or _follows(meant, kinds, consequences) is not False
        if kinds and not (is_meant and not _follows(claim, kinds, consequences)):
            return _told(kinds)
    return ""


def doubt_of_reals(claim: Claim) -> str:
    """What is found of a claim on a page with an imaginary unit only if its numbers are real; empty for no doubt.

    Sums, products, quotients and analytic functions have no such doubt: a polynomial that vanishes at all real numbers
    is zero.
    """
    parts = (part for side in _sides(claim) for part in w.walk(side))
    is_analytic = all(not isinstance(part, w.Norm) and getattr(part, "function", "exp") in ANALYTIC for part in parts)
    return "" if is_analytic else "all numbers are real"


def imaginary_unit(sides: Iterable[w.Node]) -> w.Symbol | None:
    """The letter for the imaginary unit among those of the sides."""
    units = (symbol for symbol in symbols_in(sides) if symbol.meaning.startswith("imaginary unit"))
    return min(units, key=lambda symbol: symbol.name, default=None)


def _told(kinds: Kinds) -> str:
    names = ", ".join(map(str, kinds))
    if all(symbol.shape == other.shape for symbol, other in kinds.items()):
        return f"{names} {'are' if len(kinds) > 1 else 'is'} not symmetric"
    kind = "scalar" if next(iter(kinds)).is_scalar else "vector"
    return f"{names} {f'are {kind}s' if len(kinds) > 1 else f'is a {kind}'}"


def _sides(claim: Claim) -> tuple[w.Node, ...]:
    """The sides of a claim and of its premises."""
    sides = (*claim.printed, *(side for each in claim.given for side in each.printed))
    return sides + tuple(side for each in claim.assuming for side in each.sides)


def _in_doubt(claim: Claim) -> dict[w.Symbol, w.Symbol]:
    """The letters of a claim and its premises that may be of another kind, and as what."""
    found: dict[w.Symbol, w.Symbol] = {}
    for symbol in sorted(symbols_in(_sides(claim)), key=lambda symbol: symbol.name):
        other = symbol.meaning.partition(" or ")[2]
        if other in (*SHAPES, "symmetric"):
            size = w.uniform(SHAPES[other], w.NO_DIMENSION) if other in SHAPES else symbol.size
            found[symbol] = with_fields(symbol, size=size, meaning=other)
    return found


def _follows(claim: Claim, kinds: Kinds, consequences: Consequences) -> bool | None:
    """Whether a claim may follow from its premises with letters of these kinds; None where they do not fit in it.

    Of functions of matrices nothing is known, hence nothing follows.
    """
    try:
        rules, kinds = _rules_of(claim, kinds)
        given = [each for each in claim.given if isinstance(each, Condition)]
        pairs = [each.printed for each in given]
        pairs += [pair for each in claim.assuming if each.free for pair in each.equations]
        posed = [PosedEquation(ASSUMED, *_same_shape(*pair, kinds), True) for pair in pairs]
        return consequences.may_follow(*_same_shape(*claim.printed, kinds), rules, posed)
    except _OfMatrices:
        return False
    except (w.Misfit, TypeError, ValueError):
        return None


class _OfMatrices(Exception):
    """An exponential or a logarithm of a matrix."""


def _rules_of(claim: Claim, kinds: Kinds) -> tuple[dict[Quantity, Statement], Kinds]:
    """The rules among the premises, and the kinds with those of the letters that they say something of."""
    rules = {key: each for each in claim.given if not isinstance(each, Condition) and (key := quantity(each.left))}
    changed, kinds = True, dict(kinds)
    while changed:
        changed = False
        for (symbol, _), rule in rules.items():
            size = _of(rule.right, kinds).measure
            if symbol not in kinds and size is not None and size.shape != symbol.shape:
                kinds[symbol], changed = with_fields(symbol, size=size), True
    made: dict[Quantity, Statement] = {}
    for (symbol, order), rule in rules.items():
        left, right = _same_shape(rule.left, rule.right, kinds)
        made[kinds.get(symbol, symbol), order] = with_fields(rule, left=left, right=right)
    return made, kinds


def _same_shape(left: w.Node, right: w.Node, kinds: Kinds) -> tuple[w.Node, w.Node]:
    one, other = _as_large((_of(left, kinds), _of(right, kinds)))
    return one, other


def _as_large(terms: tuple[w.Node, ...]) -> tuple[w.Node, ...]:
    """The terms with scalars among matrices as multiples of the identity."""
    sizes = {term.shape[0] for term in terms if not term.is_scalar and term.shape[0] == term.shape[1]}
    if len(sizes) != 1 or all(not term.is_scalar for term in terms):
        return terms
    (size,) = sizes
    return tuple(w.Scale(term, w.Identity(int(size))) if term.is_scalar else term for term in terms)


def _of(node: w.Node, kinds: Kinds) -> w.Node:
    """The expression with letters of other kinds, its products in the order of print; raises `Misfit` where none is."""
    if isinstance(node, w.Symbol):
        return kinds.get(node, node) if node.stands_for is None else _of(node.stands_for, kinds)
    parts = tuple(_of(part, kinds) for part in node.below)
    if parts == node.below:
        return node
    match node:
        case w.Scale(trailing=trailing):
            return multiplied(*(parts[::-1] if trailing else parts))
        case w.Contract():
            return reduce(multiplied, parts)
        case w.Cross() | w.Dot() if all(part.is_scalar for part in parts):
            return multiplied(*parts)
        case w.Quotient() if not parts[1].is_scalar:
            return multiplied(parts[0], w.Inverse(parts[1]))
        case w.Transpose() if parts[0].is_scalar:
            return parts[0]
        case FunctionOf("exp" | "log") if not parts[0].is_scalar:
            raise _OfMatrices
        case w.Sum():
            return w.Sum(_as_large(parts))
    return rebuilt(node, parts)
