"""Sums and products up to a letter, by induction: a claim at the least number, and at the next if it holds at one."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import reduce
from typing import Any

import sympy

from chasles.checker.expressions.asked import listed
from chasles.checker.expressions.proof import check_proof
from chasles.checker.expressions.quantities import with_values
from chasles.checker.expressions.readings import is_integral
from chasles.checker.expressions.unevaluated import require_running
from chasles.checker.expressions.visible import is_running, kinds_of, signs_of
from chasles.checker.sparse import Rejected, well_formed
from chasles.verdict import Counterexample, HoldsUnder

LONG = (sympy.Sum, sympy.Product)
MOST_MORE = 8
"""By fewer terms than these a sum may grow where its letter grows by one."""
Question = tuple[Any, Any, Any, Any]
"""Both sides, the list of what is given, the list of what does not vanish."""


def scalar_question(lhs: Any, rhs: Any, given: Any, nonzero: Any) -> Question:
    """A question on scalars with its conditions in lists; raises `Rejected` for others."""
    sides = [sympy.sympify(side) for side in (lhs, rhs)]
    if not all(isinstance(side, sympy.Expr) for side in sides):
        raise Rejected("only of scalars something is shown by induction")
    for part in sorted(sympy.Tuple(*sides).atoms(*LONG), key=str):
        require_running(part)
    return (*sides, *([item for _, item in listed(*each)] for each in ((given, "given"), (nonzero, "nonzero"))))


def letters_of(question: Question) -> list[Any]:
    """The integers up to which a question adds or multiplies, of which nothing is known but maybe a sign, by name."""
    parts = sympy.Tuple(*question[:2]).atoms(*LONG)
    letters = {letter for part in parts for letter in part.limits[0][-1].free_symbols if letter.is_integer}
    letters -= {each for item in (*_binding(question), *question[3]) for each in item.free_symbols}
    return sorted((letter for letter in letters if is_running(letter, (sympy.S.One,))), key=str)


def _binding(question: Question) -> list[Any]:
    """What is given, without equations for symbols of which nothing else is said."""
    left, right, given, nonzero = question
    said = [symbol for e in (left, right, *given, *nonzero) for symbol in e.free_symbols]
    return [e for e in given if not isinstance(e, sympy.Eq) or said.count(e.lhs) != 1 or e.rhs.has(e.lhs)]


def least_of(letter: Any) -> int:
    """The least number that a letter may be, by its assumptions; one if they leave it open."""
    return 0 if letter.is_nonnegative and not letter.is_positive else 1


def steps(question: Question, letter: Any, name: str) -> tuple[int, Question, Question]:
    """The least value of a letter, the question there, and the question at the next number, given that it holds at one.

    In the latter, the sums and products up to the letter are new symbols, called by a name and a number; a product of
    positive integers is more by one. Raises `Rejected` where nothing says from where the letter counts, or terms depend
    on it.
    """
    left, right, given, nonzero = *question[:2], _binding(question), question[3]
    if letter.is_positive is not True and letter.is_nonnegative is not True:
        raise Rejected(f"nothing says from where {letter} counts: it is neither positive nor nonnegative")
    if left.has(sympy.I) or right.has(sympy.I):
        raise Rejected("sums and products are read as real numbers")
    least = sympy.Integer(least_of(letter))
    parts = [part for part in sympy.Tuple(left, right).atoms(*LONG) if part.has(letter)]
    now, then = dict[Any, Any](), dict[Any, Any]()
    for count, part in enumerate(sorted(parts, key=str)):
        ((index, low, high), *others) = part.limits
        more = sympy.expand(high.xreplace({letter: letter + 1}) - high)
        if others or more not in range(1, MOST_MORE) or part.function.has(letter) or low.has(letter):
            raise Rejected(f"{part} does not grow by a few terms where {letter} grows by one")
        upwards = isinstance(part, sympy.Product) and -1 not in signs_of(1 + with_values(high - low, {letter: least}))
        known = kinds_of(signs_of(part.function)) if upwards else {}
        more_than = int("positive" in known and is_integral(part.function))
        symbol = sympy.Symbol(f"{name}_{count + 1}", real=True, **({"nonnegative": True} if more_than else known))
        now[part] = symbol + more_than
        terms = (part.function.xreplace({index: high + k}) for k in range(1, int(more) + 1))
        then[symbol] = (sympy.Add if isinstance(part, sympy.Sum) else sympy.Mul)(now[part], *terms) - more_than
    if {str(symbol) for symbol in then} & {str(s) for e in (left, right, *given) for s in e.free_symbols}:
        raise Rejected(f"the symbols {name}_1 and so on are not new")
    hypothesis = sympy.Eq(with_values(left, now), with_values(right, now), evaluate=False)
    after = (reduce(with_values, (now, {letter: letter + 1}, then), side) for side in (left, right))
    first = (with_values(side, {letter: least}) for side in (left, right))
    return int(least), (*first, given, nonzero), (*after, [*given, hypothesis], nonzero)


def check_induction(verdict: Any, *asked: Any) -> None:
    """Both parts of a proof by induction prove their questions, and the verdict says what they need.

    Raises `Rejected` if not.
    """
    with well_formed("certificate"):
        question, said = scalar_question(*asked), verdict.certificate["induction"]
        letter = next((each for each in letters_of(question) if str(each) == said["on"]), None)
        if letter is None or verdict.certificate.keys() != {"induction"}:
            raise Rejected(f"nothing is added or multiplied up to {said['on']}")
        least, *questions = steps(question, letter, said["name"])
        parts = [HoldsUnder(tuple(part["needs"]), part["proof"], part["witness"]) for part in said["parts"]]
        for part, each in zip(parts, questions, strict=True):
            check_proof(part, *each)
        needs, witness = joined(parts, questions, letter, least)
        stated = {f"{e.lhs} = {e.rhs}" for e in question[2] if isinstance(e, sympy.Equality)}
        if not needs <= {*verdict.needs} <= needs | stated or verdict.witness != witness:
            raise Rejected("the verdict needs something else than the parts of the proof do")


def joined(
    parts: Sequence[HoldsUnder], questions: Sequence[Question], letter: Any, least: int
) -> tuple[set[str], Mapping[str, Any]]:
    """What both parts of a proof by induction need, which holds for all numbers, and where that is so."""
    hypothesis = questions[1][2][-1]
    base, step = set(parts[0].needs), set(parts[1].needs) - {f"{hypothesis.lhs} = {hypothesis.rhs}"}
    if not (base <= step or step <= base):
        raise Rejected("nothing shows that the first step and the others need nothing that excludes each other")
    known = {str(s) for e in (*questions[0][:2], *questions[0][2]) for s in e.free_symbols} - {str(letter)}
    for name in {str(letter), *(str(s) for s in hypothesis.free_symbols if str(s) not in known)}:
        if any(re.search(rf"(?<!\w){re.escape(name)}(?!\w)", text) for text in base | step):
            raise Rejected(f"what is needed depends on {name}")
    witness = {name: value for name, value in parts[base <= step].witness.items() if name in known}
    return base | step, {**witness, str(letter): least}


def at_numbers(found: Counterexample, *asked: Any) -> tuple[Any, ...]:
    """The rest of a point, and the question with its values of the letters up to which it adds or multiplies.

    Raises `Rejected` for a value that a letter cannot have.
    """
    if not any(isinstance(side, sympy.Expr) and side.has(*LONG) for side in asked[:2]):
        return found, *asked
    left, right, given, nonzero = question = scalar_question(*asked)
    at = [each for each in letters_of(question) if str(each) in found.at]
    letters = {each: sympy.sympify(found.at[str(each)], strict=True) for each in at}
    for letter, value in letters.items():
        if not value.is_Integer or (letter.is_positive and value < 1) or (letter.is_nonnegative and value < 0):
            raise Rejected(f"{letter} is not {value}")
    rest = {name: value for name, value in found.at.items() if name not in map(str, letters)}
    sides, given = ([with_values(e, letters) for e in said] for said in ((left, right), given))
    return replace(found, at=rest), *sides, given, nonzero
