"""The result of a derivation compared with the printed equation: equal, or different and where."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from dataclasses import replace as with_fields

from chasles.decisions.decision import HOW
from chasles.deriving.state import Equation, State, rules_behind
from chasles.rewriting.products import without_brackets
from chasles.rewriting.tidy import tidied
from chasles.statements import Goal, Statement
from chasles.statements.derivation import Compare
from chasles.verdict import Fails, Holds, IllFormed, Undecided, Verdict
from chasles.vocabulary import Contract, Identity, Inverse, Negative, Node, Sum, number, replace


@dataclass(frozen=True, slots=True)
class PrintComparison:
    """The form of the statement that is equal to what was found, if one is, and the verdict on the printed equation.

    `chosen` are the values of free symbols for which they agree; `found` is the equation with these.
    """

    statement: Statement
    found: Equation
    printed: Verdict
    form: str | None
    verdict: Verdict
    chosen: tuple[Equation, ...] = ()
    last: Verdict | None = None

    @property
    def words(self) -> str:
        """What came of it, in words."""
        for_what = f", for {', '.join(f'{s} = {v}' for s, v in self.chosen)}" if self.chosen else ""
        if self.form == "printed":
            return f"equal to the printed equation{for_what}"
        why = _why(self.printed)
        if self.form:
            return f"{why}; equal to the printed equation {HOW[self.form]}{for_what}"
        again = (
            "" if self.last is None or self.last is self.printed else f"; as read or corrected, it {_why(self.last)}"
        )
        return why + again


def _why(verdict: Verdict) -> str:
    match verdict:
        case Fails(found):
            row, column = found.entry
            where = f"differs from the printed equation in row {row}, column {column}"
            return f"{where}: found {found.left}, printed {found.right}"
        case IllFormed(reason):
            return f"the printed equation does not fit together: {reason}"
        case Undecided(reason):
            return f"not decided: {reason}"
        case _:
            return verdict.name


def compare(step: Compare, state: State) -> PrintComparison:
    """The comparison with the form that agrees, the printed one tried first."""
    statement = step.statement
    using = tuple(dict.fromkeys((*step.using, *(s for s in rules_behind_all(statement) if s is not statement))))
    printed: Verdict | None = None
    last: Verdict | None = None
    for form, (left, right) in _forms(statement, state):
        if left.fault or right.fault or (form == "printed" and statement.fault):
            printed = printed or IllFormed(statement.fault or left.fault or right.fault or "")
            continue
        sides = without_brackets(left), without_brackets(right)
        found, chosen, verdict = _one_form(step, state, sides, using)
        printed, last = printed or verdict, verdict
        if verdict.true:
            return PrintComparison(statement, found, printed, form, verdict, chosen)
    assert printed is not None
    return PrintComparison(
        statement, _nearest(state, without_brackets(statement.left)), printed, None, printed, (), last
    )


def _forms(statement: Statement, state: State) -> Iterator[tuple[str, Equation]]:
    """The printed equation, and the forms that may replace it."""
    for form in HOW:
        if form != "repair" and statement.form_exists(form):
            yield form, statement.form(form)
        elif form == "repair" and (correction := state.session.decide(statement).correction) is not None:
            yield from ((form, (found.left, found.right)) for found in correction.repairs)


def rules_behind_all(statement: Statement) -> Iterator[Statement]:
    """What the statement is given, as rules."""
    for given in statement.given:
        yield from rules_behind(given)


def _nearest(state: State, left: Node) -> Equation:
    """The equation reached that is one for the same left side, or else the first."""
    return next((found for found in state.equations if found[0] == left), state.equations[0])


def _one_form(
    step: Compare, state: State, sides: Equation, using: tuple[Statement, ...]
) -> tuple[Equation, tuple[Equation, ...], Verdict]:
    found = _nearest(state, sides[0])
    environment = state.environment(using)
    chosen: tuple[Equation, ...] = ()
    if step.free:
        problem = with_fields(environment, conditions=(Goal("", found[1], sides[1]),), unknowns=step.free)
        chosen = tuple((symbol, state.combination(symbol, (number(1),), problem)) for symbol in step.free)
        values: dict[Node, Node] = dict(chosen)
        found = found[0], tidied(replace(found[1], values))
    verdict: Verdict | None = None
    restricts = found[0] != sides[0] and not state.decide([("", *found)], environment).true
    for goals in _readings(found, sides, restricts):
        decided = state.decide(goals, environment)
        verdict = verdict or decided
        if decided.true:
            return found, chosen, decided
    return found, chosen, verdict or Holds({"entries": {}}, {})


def _readings(found: Equation, sides: Equation, restricts: bool) -> Iterator[list[tuple[str, Node, Node]]]:
    """Side by side, in either order; of what `restricts`, the difference of the sides, of either sign.

    Of two identities the differences are both zero, and would be equal whatever they say.
    """
    if isinstance(sides[0], Inverse) and found[0] != sides[0]:
        product = Contract((sides[1], sides[0].of))
        yield [
            ("the product with the matrix", found[0], product),
            ("the identity", found[1], Identity(product.shape[0])),
        ]
        return
    if found[0] == sides[0]:
        yield [("right side", found[1], sides[1])]
        return
    if found[0].shape != sides[0].shape:
        raise ValueError(f"what was found, {found[0]} = {found[1]}, has another shape than {sides[0]} = {sides[1]}")
    yield [("left side", found[0], sides[0]), ("right side", found[1], sides[1])]
    yield [("left side, for right", found[0], sides[1]), ("right side, for left", found[1], sides[0])]
    if restricts:
        difference, other = (Sum((left, Negative(right))) for left, right in (found, sides))
        yield [("difference of the sides", difference, other)]
        yield [("difference of the sides, the sign changed", Negative(difference), other)]
