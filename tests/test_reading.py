"""Printed equations are read as words that print the same tokens again, and as what the chapter declares by hand."""

from __future__ import annotations

import re
import tomllib
from collections import Counter
from collections.abc import Callable
from dataclasses import fields
from fractions import Fraction
from functools import cache
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from chasles.reading.atoms import marks_of
from chasles.reading.equations import read_equations
from chasles.reading.page_notation import PageNotation, declared_in
from chasles.reading.pages import displayed
from chasles.reading.printed import PrintedEquation
from chasles.reading.reading import ReadEquation
from chasles.statements import Statement, load
from chasles.vocabulary import (
    LENGTH,
    MASS,
    At,
    Contract,
    Determinant,
    Group,
    Identity,
    Node,
    Number,
    Quotient,
    Rate,
    Scale,
    Sum,
    Symbol,
    Trace,
    Zero,
    latex,
    scalar,
    symbols_of,
    undotted,
)

from .sampling import sample

LAYOUT = {r"\left", r"\right", r"\quad", r"\,", r"\ ", r"\\", r"\mathbf", r"\boldsymbol", r"\overrightarrow", r"\text",
          r"\mathsf", r"\mathrm", r"\operatorname", "&", ",", "{", "}"}  # fmt: skip
MATRIX = re.compile(r"\\(begin|end)\{[bp]matrix\}")
MARK = re.compile(r"\\[a-zA-Z]+|\\.|[A-Za-z]|\d+|\S")
PRINTED: dict[str, str] = tomllib.loads((Path(__file__).parent / "printed.toml").read_text(encoding="utf-8"))
CHAPTER = load()


def tokens_of(text: str) -> tuple[str, ...]:
    """The text as tokens without layout: a matrix is what stands in square brackets."""
    text = MATRIX.sub(lambda found: " [ " if found[1] == "begin" else " ] ", text)
    return tuple(token for token in MARK.findall(text) if token not in LAYOUT)


def in_module(module: ModuleType) -> PageNotation:
    """The notation of a module as it is, letters that look alike kept apart."""
    return declared_in(module.__name__, vars(module).values())


NOTATION = in_module(import_module("chasles.derivations.notation"))


@cache
def of_the_book() -> dict[str, ReadEquation]:
    """What is read of each printed equation, by its number."""
    printed = [PrintedEquation(text, number=number) for number, text in PRINTED.items()]
    return {each.printed.number: each for each in read_equations(printed, NOTATION)}


def ungrouped(node: Node) -> Any:
    """Nested tuples: factors in order, however a product is grouped, without needless brackets, numbers as printed."""
    if isinstance(node, Group) and not node.frame:
        return ungrouped(node.of)
    if isinstance(node, Scale | Contract):
        parts = node.factors if isinstance(node, Contract) else (node.factor, node.term)
        flat: list[Any] = []
        for part in reversed(parts) if isinstance(node, Scale) and node.trailing else parts:
            inner = ungrouped(part)
            flat += inner[1:] if isinstance(inner, tuple) and inner[0] == "product" else [inner]
        return ("product", *flat)
    if isinstance(node, Symbol):
        return node
    if isinstance(node, Number) and node.value < 0:
        return "Negative", ungrouped(Number(-node.value))
    if isinstance(node, Number) and node.value.denominator != 1:
        parts = (Number(Fraction(part)) for part in (node.value.numerator, node.value.denominator))
        return ("Quotient", *map(ungrouped, parts))
    if isinstance(node, Quotient) and isinstance(node.numerator, Number) and isinstance(node.denominator, Number):
        return ("Quotient", *map(ungrouped, node.below))
    if isinstance(node, Rate) and isinstance(node.of, At):
        return ungrouped(At(Rate(node.of.of), node.of.argument))
    if isinstance(node, Zero | Number) and node in (Zero(1, 1), Number(0)):  # type: ignore[arg-type]
        return "0"
    if isinstance(node, Zero | Identity):
        return type(node).__name__, node.shape
    own = [repr(getattr(node, f.name)) for f in fields(node) if not isinstance(getattr(node, f.name), Node | tuple)]  # type: ignore[arg-type]
    return (type(node).__name__, *map(ungrouped, node.below), *own)


def sides_of(parts: Any) -> set[Any]:
    return {ungrouped(side) for part in parts for side in (part.left, part.right)}


def read(text: str) -> ReadEquation:
    return read_equations([PrintedEquation(text)], NOTATION)[0]


def test_the_chapter_is_read():
    unread = {number: each.why for number, each in of_the_book().items() if each.status == "unread"}
    assert len(unread) <= 0.03 * len(PRINTED), unread


def test_what_is_read_is_what_is_declared():
    declared: dict[str, list[Statement]] = {}
    for entry in CHAPTER:
        if isinstance(entry.statement, Statement) and entry.number in PRINTED:
            declared.setdefault(entry.number, []).append(entry.statement)
    found = Counter(
        any(sides_of(reading.parts) == sides_of(parts) for reading in of_the_book()[number].readings)
        for number, parts in declared.items()
    )
    assert found[True] >= 0.88 * len(declared)


@pytest.mark.parametrize("number", ["3.2", "3.13", "3.50", "3.76d", "3.130", "3.143"])
def test_it_prints_the_tokens_of_the_page(number: str):
    (*parts,) = of_the_book()[number].readings[0].parts
    said = tokens_of(latex(parts[0].left)) + tokens_of(parts[0].sign)
    for part in parts:
        said += tokens_of(latex(part.right)) + (tokens_of(part.sign) if part is not parts[-1] else ())
    page = " ".join(marks_of(of_the_book()[number].printed.atoms))
    assert len(said) > 6
    assert said == tokens_of(page)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        (r"\mathbf{z} = \mathbf{p}", "does not say what"),
        (r"\mathbf{p} \boxplus \mathbf{a} = \mathbf{d}_A", "no word for \\boxplus"),
        (r"\mathbf{p} - \mathbf{a}", "no relation"),
        (r"\mathbf{p} = \mathbf{a} +", "missing at the end"),
        (r"\mathbf{p} \in \mathbb{R}^3", "\\in claims nothing"),
        (r"\mathbf{p} \times \mathbf{Q} = \mathbf{a}", "no word for \\times between 3 x 1 and 3 x 3"),
    ],
)
def test_what_cannot_be_read_says_why(text: str, why: str):
    found = read(text)
    assert found.status == "unread"
    assert why in found.why


@pytest.mark.parametrize(
    "text",
    [
        r"\mathbf{p} = \mathbf{Q}",
        r"\mathbf{e}\mathbf{e} = 1",
        r"\mathbf{Q} + \mathbf{e} = \mathbf{1}",
        r"\cos \mathbf{e} = 1",
    ],
)
def test_a_misprint_is_read_as_printed(text: str):
    found = read(text)
    assert found.status == "read"
    assert found.readings[0].parts[0].fault


ROTATIONS = load("chasles.rotations")
IN_ROTATIONS = in_module(import_module("chasles.rotations.notation"))


def test_the_second_chapter_is_read_back():
    statements = sample([entry.statement for entry in ROTATIONS if isinstance(entry.statement, Statement)], 4)
    texts = [PrintedEquation(f"{latex(each.left)} {each.sign} {latex(each.right)}") for each in statements]
    found = Counter()
    for statement, equation in zip(statements, read_equations(texts, IN_ROTATIONS), strict=True):
        same = sides_of([statement])
        found[any(sides_of(reading.parts) == same for reading in equation.readings) or equation.status] += 1
    assert found[True] >= 0.92 * len(statements)


@pytest.mark.parametrize(
    ("text", "rates"),
    [
        (r"\frac{d^2}{dt^2} \mathbf{x} = \ddot{\mathbf{x}}", 2),
        (r"\frac{d}{dt} \mathbf{x} = \dot{\mathbf{x}}", 1),
        (r"\frac{d\mathbf{x}}{dt} = \dot{\mathbf{x}}", 1),
        (r"\frac{\mathrm{d}^2\mathbf{x}}{\mathrm{d}t^2} = \ddot{\mathbf{x}}", 2),
        (r"\frac{d\mathbf{x}}{dd} = \dot{\mathbf{x}}", 0),
        (r"\frac{d\mathbf{x}}{ds} = \dot{\mathbf{x}}", 0),
    ],
)
def test_a_differential_is_no_product_with_a_letter_d(text: str, rates: int):
    (found,) = read_equations([PrintedEquation(text)], IN_ROTATIONS)
    if not rates:
        assert found.status == "unread"
        return
    (part,) = found.readings[0].parts
    assert undotted(part.left) == undotted(part.right)
    assert undotted(part.left)[1] == rates


@pytest.mark.parametrize("number", [1, 8])
def test_reading_does_not_grow_without_bound(number: int):
    text = r"\mathbf{p} \cdot \mathbf{p} = " + " + ".join(
        [r"p_1 \cos \alpha h a b \mathbf{v} \cdot \mathbf{p}"] * number
    )
    read_equations([PrintedEquation(text)], IN_ROTATIONS)


@pytest.mark.parametrize("nearby", [0, 1])
def test_a_letter_means_what_it_means_nearby(nearby: int):
    meanings = [scalar("l", "l", "length", LENGTH), scalar("l", "l", "mass", MASS)]
    module = ModuleType("nearby")
    module.__dict__.update(a=meanings[0], b=meanings[1], m=scalar("m", "m", "", MASS), d=scalar("d", "d", "", LENGTH))
    texts = [r"l = d", "l^2 + l^2 = 2 l^2", "l = m"]
    texts = texts if nearby == 0 else [texts[2], texts[1]]
    found = read_equations([PrintedEquation(text) for text in texts[:2]], in_module(module))
    assert [each.status for each in found] == ["read", "ambiguous"]
    assert meanings[nearby] in symbols_of(found[1].readings[0].parts[0].left)


@pytest.mark.parametrize(
    ("text", "same"),
    [
        (r"\text{tr}(\mathbf{1}) = 3", lambda left: left == Trace(Identity(3))),
        (r"\det(\mathbf{1}) = 1", lambda left: left == Determinant(Identity(3))),
        (r"\text{tr}(\mathbf{O}) = 0", lambda left: left.of.shape == (3, 3)),
        (r"(\mathbf{p} + \mathbf{a}) + \mathbf{b} = \mathbf{d}_A", lambda left: isinstance(left.terms[0], Sum)),
        (r"\mathbf{b}(t)^T \mathbf{p} = 0", lambda left: isinstance(left.factors[0].of, At)),
    ],
)
def test_what_is_small_in_print_is_read_as_it_is(text: str, same: Callable[[Any], bool]):
    found = read(text)
    assert same(found.readings[0].parts[0].left)


def test_each_meaning_of_a_letter_is_kept_where_a_size_is_open():
    found = read(r"\mathbf{I}_C = m (\|\mathbf{r}\|^2 \mathbf{1} - \mathbf{r}\mathbf{r}^T)")
    assert len({each.parts[0].right for each in found.readings}) == 2


def test_in_an_integral_a_letter_means_what_runs_over_the_body():
    (reading,) = of_the_book()["3.130"].readings
    meanings = {symbol.letter: symbol.meaning for symbol in symbols_of(reading.parts[0].right)}
    assert meanings[r"\mathbf{r}"] == "position of P from the center of mass"


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        (
            "\\begin{aligned}\n\\mathbf{p} &= \\mathbf{a} \\\\\n&= \\mathbf{b} \\\\\n\n&= \\mathbf{c}\\end{aligned}",
            [3, 4, 6],
        ),
        ("\\mathbf{p} = \\mathbf{a}, \\quad\n\\mathbf{p}\n= \\mathbf{b}", [2, 3]),
    ],
)
def test_each_part_has_its_line(text: str, lines: list[int]):
    (found,) = read_equations([PrintedEquation(text, line=2)], NOTATION)
    assert [part.line for part in found.readings[0].parts] == lines


def test_rows_with_numbers_of_their_own_have_their_lines():
    page = (
        "\\begin{align}\n\\mathbf{p} &= \\mathbf{a} \\\\\n&= \\mathbf{b} \\\\\n\\mathbf{p} &= \\mathbf{c}\n\\end{align}"
    )
    found = read_equations(displayed(page, "tex"), NOTATION)
    assert [(each.printed.line, each.readings[0].parts[0].line) for each in found] == [(2, 2), (3, 3), (4, 4)]


@pytest.mark.parametrize(
    ("text", "why"),
    [
        (r"\mathbf{p} == \mathbf{a}", "= is not expected here"),
        (r"\mathbf{p}, \mathbf{a}) = \mathbf{b}", ") is not expected here"),
        (r"\mathbf{p} = \frac{\mathbf{a} + }{2}", "missing at the end"),
        (r"\mathbf{p} = {}_ + \mathbf{a}", ""),
        (r"\mathbf{p} = \begin{bmatrix} I & \mathbf{z} \\ \mathbf{1} & \mathbf{Q} \end{bmatrix}", ""),
    ],
)
def test_what_is_broken_is_told_in_a_line(text: str, why: str):
    (found,) = read_equations(displayed(text, "equation"), NOTATION)
    assert found.status == "unread"
    assert why in found.why or found.printed.fault
