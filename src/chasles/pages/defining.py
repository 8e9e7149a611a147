"""What an equation of a page may define, and what its definition is."""

from __future__ import annotations

from collections.abc import Iterable

from chasles.pages.facts import divisors
from chasles.pages.notes import is_defining
from chasles.pages.premises import Premises, chosen_rules, free_quantities, rule_for
from chasles.pages.quantities import Quantity, quantities, quantity, symbols_in
from chasles.statements import Claim, Definition


def meant_by(claim: Claim, premises: Premises, of: Quantity | None = None) -> tuple[Quantity, bool] | None:
    """What an equation may define, and whether on its right side; None for a claim. A person may say `of` what."""
    for side, other, turned in ((*claim.printed, False), (*claim.printed[::-1], True)):
        key = quantity(side)
        rules = chosen_rules((other,), premises.defined())
        if key is None or any(s == key[0] and k >= key[1] for s, k in free_quantities((other,), rules)):
            continue
        if of == key:
            return key, turned
        if of is None and ((is_defining(claim) and not turned) or _is_free(key, premises)):
            return key, turned
    return None


def said_to_be(claim: Claim) -> tuple[Quantity, bool] | None:
    """The symbol that an open equation says to be something else, and whether on its right side."""
    for side, other, turned in ((*claim.printed, False), (*claim.printed[::-1], True)):
        key = quantity(side)
        if key is not None and not any(each[0] == key[0] and each[1] >= key[1] for each in quantities(other)):
            return key, turned
    return None


def is_new(claim: Claim, key: Quantity, premises: Premises) -> bool:
    """Whether nothing needs to be decided before a symbol is taken to be defined."""
    is_spoken = any(symbol == key[0] for symbol, _ in premises.spoken)
    return rule_for(key, premises.defined()) is None and (is_defining(claim) or not is_spoken)


def is_said_ahead(claim: Claim, key: Quantity, ahead: Iterable[Claim], premises: Premises) -> bool:
    """Whether what follows says what a symbol on the right is, or says by it what several others of the claim are.

    So it is in A p = b, where b = c - d; and in v = u + w, where u = (v . e) e and w = v - u.
    """
    new = symbols_in(claim.printed) - {symbol for symbol, _ in premises.spoken} - {key[0]}
    found = ((each, meant_by(each, premises)) for each in ahead if not each.fault)
    said = {meant[0]: each for each, meant in found if meant and not meant[1]}
    parts = [q for q, each in said.items() if q[0] in new and any(key in quantities(side) for side in each.printed)]
    return (key in said and quantity(claim.right) == key) or len(parts) > 1


def _is_free(key: Quantity, premises: Premises) -> bool:
    """Whether the page has only used a symbol so far, and said nothing of it, or of a rate of it."""
    symbol, order = key
    said = {s for s, _ in premises.definitions} | {s for s, _ in premises.proved}
    posed = {q for each in premises.posed for side in (each.left, each.right) for q in quantities(side)}
    return symbol not in said and not any(s == symbol and k >= order for s, k in posed)


def definition_of(claim: Claim, turned: bool) -> Definition:
    """What is said of the symbol on the left side, or on the right one if it is turned."""
    left, right = (claim.right, claim.left) if turned else claim.printed
    return Definition(claim.number, left, right, part=claim.part, sign=claim.sign, assuming=divisors((right,)))
