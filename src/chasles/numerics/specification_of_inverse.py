"""What must a kernel compute that inverts a formula, branch by branch?"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from chasles.evaluation.matrices import Matrix
from chasles.numerics.enclosures import plain_context
from chasles.numerics.reference import Singular, evaluate
from chasles.numerics.specification import (
    ROUNDINGS,
    KernelInput,
    Specification,
    Values,
    expected_output,
    kernel_asked_by,
)
from chasles.problems.variables import angle_multiples
from chasles.statements import Branch, Inverse, Kernel, Statement
from chasles.statements.definitions import rules_behind
from chasles.statements.goals import AcceptedSides
from chasles.statements.posing import default_sides
from chasles.statements.statement import bare, is_rule
from chasles.vocabulary import Call, Negative, Node, Sum, plain

DIGITS_OF_INPUTS = 40
"""To how many digits inputs satisfy what a branch assumes, if they do: they are made with 50."""
MORE_DIGITS = 20
"""What the values of a branch are known to beyond the digits asked for: results are computed from them."""


def specification_of_inverse(
    name: str,
    sentence: Inverse,
    kernel: Kernel | None = None,
    results: Sequence[str] = (),
    roundings: int = ROUNDINGS,
    accepted: AcceptedSides = default_sides,
) -> Specification:
    """What an inverse's kernel must compute: what it gives, with the values of the first branch that applies.

    Off its hypotheses an inverse depends on how it is written, so its reference is taken at the exact point of which
    the inputs are the rounding. Raises TypeError if the inverse asks for no kernel.
    """
    kernel = kernel or kernel_asked_by(sentence, name)
    direct = dict(_rule(given, accepted) for given in sentence.given if is_rule(given))
    rules = {**rules_behind(sentence.given, accepted), **direct}
    names = results or kernel.results or map(plain, sentence.gives)

    def reference(values: Values, digits: int) -> tuple[Matrix, ...]:
        known = {**values, **_arguments(sentence, values, rules, digits + MORE_DIGITS)}
        return tuple(evaluate(part, known, rules, digits) for part in sentence.gives)

    return Specification(
        name,
        tuple(map(KernelInput, kernel.of)),
        tuple(map(expected_output, names, sentence.gives)),
        reference,
        sentence.assuming,
        rules,
        roundings=roundings,
        exact_inputs=True,
    )


def _rule(given: Statement, accepted: AcceptedSides) -> tuple[Node, Node]:
    left, right = accepted(given)
    return bare(left), right


def _applies(branch: Branch, values: Values, rules: Mapping[Node, Node]) -> bool:
    """Whether `where` is not zero and the hypotheses of the branch hold."""
    if evaluate(branch.where, values, rules)[0][0] == 0:
        return False
    sides = [(left, right) for hypothesis in branch.assuming for left, right in hypothesis.equations]
    differences = (evaluate(Sum((left, Negative(right))), values, rules, digits=1) for left, right in sides)
    return all(abs(x) < 10.0**-DIGITS_OF_INPUTS for difference in differences for row in difference for x in row)


def _arguments(sentence: Inverse, values: Values, rules: Mapping[Node, Node], digits: int) -> dict[Node, Any]:
    """The formula's arguments, by the first branch that applies or the largest; raises `Singular` if none does."""
    applying = [branch for branch in sentence.branches if _applies(branch, values, rules)]
    if sentence.largest:
        applying.sort(key=lambda branch: -evaluate(branch.where, values, rules)[0][0])
    branch = next(iter(applying), None)
    if branch is None:
        raise Singular(f"no branch of ({sentence.number}) applies here")
    known: dict[Node, Any] = {key: evaluate(value, values, rules, digits) for key, value in branch.values}
    entries = [entry for key in sentence.sign for row in known[key] for entry in row]
    if next((entry for entry in entries if entry), 1) < 0:
        known |= {key: [[-entry for entry in row] for row in known[key]] for key in sentence.sign}
    for key in list(known):
        if isinstance(key, Call) and key.function == "cos":
            (cosine,), (sine,) = known[key][0], known[Call("sin", key.argument)][0]
            ((angle, multiple),) = angle_multiples(key.argument, {}).items()
            turned = plain_context(digits).atan2(sine, cosine)
            known[angle] = turned * multiple.denominator / multiple.numerator
    return known
