"""An inverse with branches as a choice: which comparisons a machine makes to know that a branch applies."""

from __future__ import annotations

from collections.abc import Iterator

from chasles.lowering.cases import Case, Choice, Comparison, vanishes
from chasles.lowering.refusal import LoweringError
from chasles.lowering.rewriting import Angle
from chasles.proof.variables import angle_multiples
from chasles.statements import Branch, Hypothesis, Inverse
from chasles.vocabulary import Call, Node, Symbol, Trace, plain, uniform
from chasles.vocabulary.nodes import lifted

__all__ = ["choice_of"]


def choice_of(inverse: Inverse) -> tuple[Choice, dict[Symbol, Angle]]:
    """The branches as cases, in their order; an angle by the cosine and sine that the branches give.

    Raises `LoweringError` for branches that give values to different symbols, and for an assumption that no comparison
    of numbers can confirm.
    """
    keys = tuple(dict(inverse.branches[0].values))
    for branch in inverse.branches:
        if tuple(dict(branch.values)) != keys:
            raise LoweringError(f"({inverse.number}): the branches must give values to the same symbols, in one order")
    symbols = {key: _symbol(inverse, key) for key in keys}
    cases = [Case(tuple(_comparisons(branch)), tuple(value for _, value in branch.values)) for branch in inverse.branches]
    angles = {}
    for key in keys:
        if isinstance(key, Call) and key.function == "cos":
            sine = Call("sin", key.argument)
            if sine not in symbols:
                raise LoweringError(f"({inverse.number}): the branches give {plain(key)} without {plain(sine)}")
            ((angle, multiple),) = angle_multiples(key.argument, {}).items()
            angles[angle] = Angle(symbols[key], symbols[sine], 1 / multiple)
    return Choice(tuple(symbols.values()), tuple(cases)), angles


def _symbol(inverse: Inverse, key: Node) -> Symbol:
    """The symbol that holds a branch's value; one of its own for the cosine or sine of an angle."""
    match key:
        case Symbol():
            return key
        case Call("cos" | "sin", argument) if len(angle_multiples(argument, {})) == 1:
            return Symbol(f"{plain(key)}, as found", "", uniform((1, 1)), plain(key))
        case _:
            raise LoweringError(
                f"({inverse.number}): a branch gives a value to {plain(key)}; it must be a symbol, or the cosine or sine "
                "of a multiple of one"
            )


def _comparisons(branch: Branch) -> Iterator[Comparison]:
    yield vanishes(branch.where, holds=False)
    for hypothesis in branch.assuming:
        yield _confirmed(branch, hypothesis)


def _confirmed(branch: Branch, hypothesis: Hypothesis) -> Comparison:
    """The comparison by which a hypothesis is confirmed, once the branches before have been left out."""
    match hypothesis.kind, hypothesis.subjects:
        case "nonzero", (scalar,):
            return vanishes(scalar, holds=False)
        case "positive", (scalar,):
            return Comparison("less", lifted(0), scalar)
        case "half_turn", (rotation,):
            # A rotation without an axial vector is a half-turn, of trace -1, or the identity, of trace 3.
            return Comparison("less", Trace(rotation), lifted(0))
        case _:
            raise LoweringError(
                f"the branch '{branch.says}' assumes that {hypothesis.text}, which no comparison of numbers confirms: "
                "say where the branch applies by what is not zero there"
            )
