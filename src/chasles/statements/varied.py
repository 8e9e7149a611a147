"""What a theorem varies must occur explicitly: the symbol over which a minimum is taken, or that a witness replaces.

A rule may hide the symbol, as the displacement of P hides p. Before a form puts a value in the symbol's place, such
rules are applied; and whatever is to be the same for all values of the symbol is refused if it depends on it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import fields
from dataclasses import replace as with_fields
from functools import lru_cache
from typing import Any

from chasles.statements.forms import Exists, Form, Minimum, Unique
from chasles.statements.hypotheses import Hypothesis
from chasles.vocabulary import Node, Symbol, replace

Rules = Mapping[Node, Node]


@lru_cache(maxsize=8192)
def opened_parts(node: Node) -> tuple[Node, ...]:
    """The node and all below it, abbreviations opened, each once."""
    seen: dict[Node, None] = {}
    waiting = [node]
    while waiting:
        node = waiting.pop()
        if node not in seen:
            seen[node] = None
            waiting += node.below[::-1]
            waiting += [node.stands_for] if isinstance(node, Symbol) and node.stands_for is not None else []
    return tuple(seen)


def varied_symbol(form: Form) -> tuple[Symbol, Node | None] | None:
    """The symbol that the form varies, and the value that it puts in its place if there is one."""
    match form:
        case Minimum(over=symbol, at=value) | Exists(symbol=symbol, witness=value):
            return symbol, value
        case Unique(symbol=symbol):
            return symbol, None
        case _:
            return None


def visible(form: Form, rules: Rules, restricted: tuple[Node, ...]) -> Form:
    """The form with every rule applied that hides the symbol it varies; `restricted` are the sides of conditions.

    Raises TypeError if a rule or a condition fixes the symbol, or if what must not depend on the symbol does.
    """
    varied = varied_symbol(form)
    if varied is None:
        return form
    symbol, value = varied
    hiding = _hiding(rules, symbol)
    if symbol in rules or any(_mentions(side, {symbol, *hiding}) for side in restricted):
        raise TypeError(f"a theorem that varies {symbol} cannot be given what determines {symbol}")

    def shown(part: Any) -> Any:
        if isinstance(part, tuple):
            return tuple(map(shown, part))
        for _ in hiding:
            part = replace(part, hiding)
        return part

    parts: Any = form
    form = with_fields(parts, **{each.name: shown(getattr(form, each.name)) for each in fields(parts)})
    fixed = {"the value put in its place": value, "the least value": form.value if isinstance(form, Minimum) else None}
    for what, part in fixed.items():
        if part is not None and _mentions(part, {symbol, *hiding}):
            raise TypeError(f"a theorem varies {symbol}, and {what}, {part}, depends on {symbol}")
    return form


def demands(form: Form, hypotheses: tuple[Hypothesis, ...]) -> Iterator[tuple[str, Node, Node]]:
    """What the hypotheses on the varied symbol ask of the value put in its place.

    Raises TypeError for a hypothesis that is no equation.
    """
    varied = varied_symbol(form)
    if varied is None:
        return
    symbol, value = varied
    if value is None:
        return
    here: dict[Node, Node] = {symbol: value}
    for hypothesis in hypotheses:
        if not any(_mentions(subject, {symbol}) for subject in hypothesis.subjects):
            continue
        if hypothesis.nonvanishing:
            raise TypeError(
                f"a theorem varies {symbol}, of which {hypothesis.text} is assumed: state it of another symbol"
            )
        for left, right in hypothesis.equations:
            yield f"the value put in its place satisfies {hypothesis.text}", replace(left, here), replace(right, here)


def _hiding(rules: Rules, symbol: Symbol) -> dict[Node, Node]:
    """The rules whose right sides depend on the symbol, directly or through other rules."""
    hiding: dict[Node, Node] = {}
    for _ in rules:
        hiding |= {left: right for left, right in rules.items() if _mentions(right, {symbol, *hiding})}
    return hiding


def _mentions(node: Node, targets: set[Node]) -> bool:
    return any(part in targets for part in opened_parts(node))
