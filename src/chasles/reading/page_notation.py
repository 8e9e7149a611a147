"""What the letters of a page are, and how its words are spelled."""

from __future__ import annotations

import inspect
import re
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, fields, is_dataclass, replace
from typing import Any, cast, get_type_hints

from chasles.reading.fits import made
from chasles.reading.glyphs import Glyph, letter_in
from chasles.reading.letter_table import LetterTable
from chasles.reading.spellings import Make, Spellings, exponential, multiplied
from chasles.vocabulary import (
    PI,
    Call,
    Cross,
    Determinant,
    Dot,
    Identity,
    Integral,
    Inverse,
    Misfit,
    Node,
    Norm,
    Number,
    Power,
    Quotient,
    Rate,
    Scale,
    Symbol,
    Trace,
    Transpose,
    Zero,
)
from chasles.vocabulary.families import Family, Index
from chasles.vocabulary.functions import PRINTED, FunctionOf, atan2
from chasles.vocabulary.nodes import node_fields
from chasles.vocabulary.notation import BOOK, Notation
from chasles.vocabulary.quaternions import QuaternionConjugate
from chasles.vocabulary.spelling import FUNCTIONS, RATIOS
from chasles.vocabulary.typesetting import COMMANDS

CONVENTIONS = ("scalar_last", "linear_first")


@dataclass
class PageNotation:
    """Letters, spellings, families of letters, and the `forms` in which words are printed.

    `home` is the module that stands for the page. If it is `proposed`, what the letters are is not known for sure.
    `assuming` is what holds on all of the page, in LaTeX; `notes` are what is said of single equations; `checks` raise
    where something that is declared cannot be read. `functions` are the letters that the page has with arguments,
    `alone` the signs of differences that it has as letters, `numbering` those that are indices; `matched` says which
    entries of a file some letter has matched, `names` which letter has a name. Of one equation so many nodes are
    printed again, at `most_work`.
    """

    letters: LetterTable = field(default_factory=LetterTable)
    spellings: Spellings = field(default_factory=Spellings)
    families: dict[Glyph, Family] = field(default_factory=dict)
    indices: dict[str, Index] = field(default_factory=dict)
    forms: Notation = BOOK
    sizes: set[int] = field(default_factory=lambda: {1, 3})
    integral: Make | None = None
    quaternions: bool = False
    home: str = ""
    proposed: bool = False
    assuming: tuple[str, ...] = ()
    notes: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    sections: dict[str, LetterTable] = field(default_factory=dict)
    checks: list[Callable[[], Node]] = field(default_factory=list)
    functions: Mapping[Glyph, bool] = field(default_factory=dict)
    alone: frozenset[str] = frozenset()
    numbering: frozenset[str] = frozenset()
    matched: dict[str, bool] = field(default_factory=dict)
    names: dict[str, Symbol] = field(default_factory=dict)
    most_work: int = 50_000

    def within(self, section: str | None) -> PageNotation:
        """The notation with the letters that mean something else in a section."""
        name = next((name for name in self.sections if section and f"{section} ".startswith(f"{name} ")), None)
        return self if name is None else replace(self, letters=self.sections[name].before(self.letters))

    @property
    def unmatched(self) -> tuple[str, ...]:
        """The entries that a person has written and that no letter has matched so far."""
        return tuple(entry for entry, is_matched in self.matched.items() if not (is_matched or self.proposed))

    def declare(self, node: Node, text: str) -> None:
        """Let the letter stand for the node."""
        self.letters.declare(node, text)
        for extent in node.shape:
            if isinstance(extent, int):
                self.sizes.add(extent)


def repeated_rate(order: int) -> Make:
    """What takes the rate so many times."""

    def make(of: Node) -> Node:
        for _ in range(order):
            of = Rate(of)
        return of

    return make


def _inverse_quaternion(of: Node) -> Node:
    """The inverse of a quaternion: its conjugate over its squared norm, which is 1 for a unit quaternion."""
    conjugate = QuaternionConjugate(of)
    is_unit = isinstance(of, Symbol) and of.meaning.startswith("unit quaternion")
    return conjugate if is_unit else Quotient(conjugate, Power(Norm(of), 2))


def _determinant(of: Node) -> Node:
    """What bars around a matrix say; around a scalar they say something else."""
    if of.is_scalar:
        raise Misfit(f"{of} is no matrix")
    return Determinant(of)


def _number_times(left: Node, right: Node) -> Node:
    """A number, or a scalar and another, multiplied with the sign that vectors have."""
    if not (isinstance(left, Number) or left.is_scalar is right.is_scalar is True):
        raise Misfit(f"{left} is no number")
    return Scale(left, right)


def usual_spellings(notation: PageNotation) -> None:
    """The spellings that every text uses."""
    spellings = notation.spellings
    for kind, name in FUNCTIONS.items():
        spellings.add(rf"\operatorname{{{name}}}(#)", kind)
    for name, form in PRINTED.items():
        one = name not in ("max", "min")
        make: Make = lambda *of, name=name: FunctionOf(name, of)  # noqa: E731
        if name != "atan2":
            spellings.add(form if "#" in form else f"{form}(#)", make if not one else lambda of, *, make=make: make(of))
    for name in ("sin", "cos"):
        spellings.add(rf"\{name}(#)", lambda of, *, name=name: Call(name, of))
    spellings.add(r"\exp(#)", exponential)
    spellings.add(r"\operatorname{Exp}(#)", exponential)
    spellings.add(r"\log(#)", lambda of: FunctionOf("log", (of,)))
    for form, name in {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "arctg": "arctan"}.items():
        spellings.add(rf"\operatorname{{{form}}}(#)", lambda of, *, name=name: FunctionOf(name, (of,)))
    for name in (r"\arctan", *(rf"\operatorname{{{each}}}" for each in ("atan2", "arctan2", "atan", "arctg"))):
        spellings.add(f"{name}(#, #)", atan2)
    for name in RATIOS:
        command = name if name in COMMANDS else f"operatorname{{{name}}}"
        spellings.add(rf"\{command}(#)", lambda of, *, name=name: _quotient(name, of))
    spellings.add(r"\det(#)", Determinant)
    for name in ("Tr", "trace", "Trace"):
        spellings.add(rf"\operatorname{{{name}}}(#)", Trace)
    spellings.add(r"\operatorname{sgn}(#)", lambda of: FunctionOf("sign", (of,)))
    spellings.add(r"\|#\|", Norm)
    spellings.add(r"\|#\|_2", Norm)
    spellings.add("|#|", Norm)
    spellings.add("|#|", _determinant)
    for order in range(1, 4):
        spellings.add(rf"\{'d' * order}ot{{#}}", repeated_rate(order))
    for script, of in {"T": Transpose, r"\top": Transpose, "-1": Inverse, "-T": lambda of: Transpose(Inverse(of)),
                       r"-\top": lambda of: Transpose(Inverse(of))}.items():  # fmt: skip
        spellings.add(f"#^{{{script}}}", of)
    spellings.add("#^{-1}", _inverse_quaternion)
    spellings.add(r"# \cdot #", Dot)
    spellings.add(r"\langle #, #\rangle", Dot)
    spellings.add(r"# \cdot #", multiplied)
    spellings.add("# * #", multiplied)
    spellings.add(r"# \times #", Cross)
    spellings.add(r"# \times #", _number_times)
    for _, word in known_words():
        called = getattr(word, "function", None)
        if isinstance(called, str) and len(node_fields(cast(Any, word))) == 1:
            stem, _, mark = called.partition("_")
            spellings.add(rf"\operatorname{{{stem}}}_{{{mark}}}(#)" if mark else rf"\operatorname{{{stem}}}(#)", word)
    notation.declare(PI, PI.letter)


def declared_in(module: str, values: Iterable[Any]) -> PageNotation:
    """The notation of what a Python module, by its name, declares, in the forms that it or its chapter prints."""
    notation = PageNotation()
    around = module
    while around and notation.forms is BOOK:
        found = getattr(sys.modules.get(around), "NOTATION", None)
        notation.forms = found if isinstance(found, Notation) else BOOK
        around = around.rpartition(".")[0]
    nodes = list({id(value): value for value in values}.values())
    makers = _makers(nodes)
    for word, form in notation.forms.all_forms.items():
        make = makers.get(word) or (lambda *of, word=word: word(*of) if callable(word) else Call(word, *of))
        if "#" in form:
            notation.spellings.add(form, _identity if word is Identity else make)
        elif word is Identity:
            notation.declare(Identity(3), form)
    usual_spellings(notation)
    for value in nodes:
        if isinstance(value, Symbol | Identity | Zero):
            notation.declare(value, value.letter)
        elif isinstance(value, Index):
            notation.indices[value.letter] = value
        elif isinstance(value, Family) and (letter := letter_in(value.letter + value.mark)):
            notation.families[letter] = value
    notation.integral = makers.get(Integral)
    return notation


def known_words() -> Iterator[tuple[str, type[Node]]]:
    """The words that are made of nothing but other words, by the names that a file has for them."""
    from chasles.vocabulary import hadamard, motion_vectors, motions, products, quaternions, rotation_vectors

    assert all(
        (hadamard, motion_vectors, motions, products, quaternions, rotation_vectors)
    )  # imported to be known here
    waiting: list[type[Node]] = [Node]
    while waiting:
        kind = waiting.pop()
        waiting += kind.__subclasses__()
        if getattr(sys.modules[kind.__module__], kind.__name__, None) is not kind:
            continue
        held = node_fields(cast(Any, kind)) if is_dataclass(kind) else ()
        if held and {each.name for each in fields(cast(Any, kind))} <= {*held, *CONVENTIONS}:
            yield re.sub(r"(?<!^)(?=[A-Z])", "_", kind.__name__).lower(), kind


def _makers(values: Iterable[Any]) -> dict[Any, Make]:
    """The functions of a module that make a word of their arguments: they know its conventions."""
    values = list(values)
    symbols = {value.shape: value for value in reversed(values) if isinstance(value, Symbol)}
    found: dict[Any, Make] = {}
    for value in values:
        hints = get_type_hints(value) if inspect.isfunction(value) else {}
        result = hints.pop("return", None)
        if not (inspect.isclass(result) and issubclass(result, Node)) or {*hints.values()} != {Node}:
            continue
        for symbol in symbols.values():
            node = made(value, *[symbol] * len(hints))
            if node is not None:
                found.setdefault(type(node), value)
    return found


def _identity(size: Node) -> Node:
    """The identity whose size is printed with it."""
    if not isinstance(size, Number) or size.value < 1:
        raise Misfit(f"{size} is no size")
    return Identity(int(size.value))


def _quotient(name: str, of: Node) -> Quotient:
    """The function of that name as what it is a quotient of."""
    above, below = (
        Number(1) if each == "1" else Call(each, of) if each in ("sin", "cos") else FunctionOf(each, (of,))  # type: ignore[arg-type]
        for each in RATIOS[name].split()
    )
    return Quotient(above, below, called=name)
