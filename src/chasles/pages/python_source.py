"""Declarations as Python source: every word and sentence as its author would write it, or by its class and fields.

What is written in a short way, with an operator or a function of the vocabulary, is made so first: only if it comes out
equal is it written so. Thus a new word needs nothing here.
"""

from __future__ import annotations

import operator
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import MISSING, dataclass, field, fields, is_dataclass, replace
from fractions import Fraction
from functools import cache
from inspect import isfunction
from itertools import product
from typing import Any, NamedTuple, get_type_hints

from chasles import statements, vocabulary
from chasles.pages.python_layout import WIDTH, laid_out
from chasles.statements import Hypothesis, matrices
from chasles.statements.fingerprint import is_said
from chasles.vocabulary import Contract, Negative, Node, Number, Power, Quotient, Scale, Sum, Symbol, printed, uniform
from chasles.vocabulary.measure import Measure
from chasles.vocabulary.notation import Notation
from chasles.vocabulary.parts import Submatrix

SUM, PRODUCT, SIGN, POWER, ATOM = range(5)
"""How tightly the parts of an expression hold together."""
ROOMS = (vocabulary, statements)
KNOWN = {value: name for name, value in vars(vocabulary).items() if isinstance(value, Symbol | vocabulary.Dimension)}
"""The constants of the vocabulary, by what they are."""
Operation = Callable[[Any, Any], Any]


class PythonText(NamedTuple):
    """The text of an expression, the value that it has, and how tightly its parts hold together."""

    text: str
    value: Any
    level: int = ATOM

    def within(self, level: int) -> str:
        """The text where something of this level is expected."""
        return self.text if self.level >= level else f"({self.text})"


@dataclass
class PythonSource:
    """Writes values as Python; `used` are module and name of all that it names.

    `variable` gives the module and the name of the variable that stands for a value, if there is one.
    """

    variable: Callable[[Any], tuple[str, str] | None] = lambda value: None
    used: set[tuple[str, str]] = field(default_factory=set)

    def text(self, value: Any) -> str:
        """The value as an expression; raises TypeError for what no declaration holds."""
        match value:
            case None | bool() | int():
                return repr(value)
            case str():
                plain = value.isprintable() and '"' not in value and not value.endswith("\\")
                raw = "r" * ("\\" in value)
                return f'{raw}"{value}"' if plain else repr(value)
            case tuple():
                return f"({', '.join(map(self.text, value))}{',' * (len(value) == 1)})"
            case Mapping():
                return f"{{{', '.join(f'{self.text(key)}: {self.text(held)}' for key, held in value.items())}}}"
            case Fraction():
                return f"{self._named('fractions', 'Fraction')}({value.numerator}, {value.denominator})"
            case Notation():
                return f"{self._named(Notation.__module__, 'Notation')}({self.text(value.all_forms)})"
            case type():
                return self.called(value)
            case Measure() if value == uniform(value.shape, value.grid[0][0]):
                return f"{self.called(uniform)}({self.text(value.shape)}, {self.text(value.grid[0][0])})"
            case Node():
                text = self._word(value).text
                return f"{self.called(printed)}(lambda: {text})" if value.fault else text
            case Hypothesis() if short := self._hypothesis(value):
                return short
            case _ if is_dataclass(value):
                return self._variable(value) or self.made(value)
        raise TypeError(f"a declaration cannot hold {value!r}")

    def made(self, value: Any, in_lines: bool = False) -> str:
        """The class called with what is said in its fields, each in a line if so: a default says nothing."""
        said = [each for each in fields(value) if each.init and each.name != "home" and is_said(value, each)]
        needed = [each.default is MISSING and each.default_factory is MISSING for each in said]
        texts = [self.text(getattr(value, each.name)) for each in said]
        inner = [t if n else f"{each.name}={t}" for each, n, t in zip(said, needed, texts, strict=True)]
        inner += ["home=__name__"] if isinstance(value, Symbol) else []
        listed = "".join(f"\n    {laid_out(each, 4, 1)}," for each in inner) + "\n" if in_lines else ", ".join(inner)
        return f"{self.called(type(value))}({listed})"

    def _variable(self, value: Any) -> str:
        found = (vocabulary.__name__, KNOWN[value]) if value in KNOWN else self.variable(value)
        return self._named(*found) if found else ""

    def _named(self, module: str, name: str) -> str:
        self.used.add((module, name))
        return name

    def called(self, named: Any) -> str:
        """The name of a class or a function."""
        room = next((room for room in ROOMS if getattr(room, named.__name__, None) is named), None)
        return self._named(room.__name__ if room else named.__module__, named.__name__)

    def _word(self, node: Node) -> PythonText:
        name = self._variable(node)
        if name:
            return PythonText(name, node)
        ways = (self._with_operator, self._of_one, self._with_function)
        found = printed(lambda: next(filter(None, (write(node) for write in ways)), None))  # type: ignore[type-var]
        return found or PythonText(self.made(node), node)

    def _with_operator(self, node: Node) -> PythonText | None:
        match node:
            case Number(value):
                said = str(value) if value.denominator == 1 else self.text(value)
                return PythonText(f"{self.called(vocabulary.number)}({said})", node)
            case Negative(term):
                return PythonText(f"-{self._word(term).within(ATOM)}", node, SIGN)
            case Power(base, exponent):
                of = self._word(base).within(ATOM)
                sign = "**" if of.replace(".", "_").isidentifier() else " ** "
                return PythonText(f"{of}{sign}{self.text(exponent)}", node, POWER)
            case Sum(terms):
                signs = [("-", operator.sub) if isinstance(each, Negative) else ("+", operator.add) for each in terms]
                bare = [each.term if isinstance(each, Negative) else each for each in terms[1:]]
                return self._chained(node, (terms[0], *bare), signs[1:], SUM)
            case Scale(factor, term, trailing):
                factors = (term, factor) if trailing else (factor, term)
                return self._chained(node, factors, [("*", operator.mul)], PRODUCT)
            case Quotient(above, below, False):
                return self._chained(node, (above, below), [("/", operator.truediv)], PRODUCT)
            case Contract(factors):
                return self._chained(node, factors, [("@", operator.matmul)] * (len(factors) - 1), PRODUCT)
        return None

    def _chained(
        self, node: Node, parts: tuple[Node, ...], signs: list[tuple[str, Operation]], level: int
    ) -> PythonText | None:
        """The parts with signs between them, numbers among the first two as Python's own, if that makes the word."""
        variants = [list(self._operands(part)) if place < 2 else [self._word(part)] for place, part in enumerate(parts)]
        for first, *rest in product(*variants):
            value, text = first.value, first.within(level)
            with suppress(TypeError, ValueError, AttributeError):
                for (sign, operation), each in zip(signs, rest, strict=True):
                    value, text = operation(value, each.value), f"{text} {sign} {each.within(level + 1)}"
                if value == node:
                    return PythonText(text, node, level)
        return None

    def _operands(self, part: Node) -> Iterator[PythonText]:
        if isinstance(part, Number) and part.value >= 0:
            value = part.value
            whole = value.denominator == 1
            yield PythonText(str(value), int(value)) if whole else PythonText(self.text(value), value)
        yield self._word(part)

    def _of_one(self, node: Node) -> PythonText | None:
        """What is written behind its one part: `R.T`, `v.x`, `R[1, 2]`."""
        if len(node.below) != 1:
            return None
        of = node.below[0]
        for name in ("T", "x", "y", "z"):
            with suppress(ValueError, TypeError):
                if getattr(of, name) == node:
                    return PythonText(f"{self._word(of).within(ATOM)}.{name}", node)
        if isinstance(node, Submatrix):
            places = node.rows[0], node.columns[0]
            for place in (places, places[0], places[1]):
                with suppress(ValueError, TypeError):
                    if of[place] == node:
                        return PythonText(f"{self._word(of).within(ATOM)}[{str(place).strip('()')}]", node)
        return None

    def _with_function(self, node: Node) -> PythonText | None:
        """A function of the vocabulary that makes the word of its parts, or of the rows of its only field."""
        held = [getattr(node, each.name) for each in fields(node)]  # type: ignore[arg-type]
        rows = [held[0]] if len(held) == 1 and isinstance(held[0], tuple) else []
        makers = _functions(type(node))  # type: ignore[arg-type]
        for taken, function in product((node.below, *rows) if node.below else (), makers):
            with suppress(TypeError, ValueError, AttributeError):
                if function(*taken) == node:
                    return PythonText(f"{self.called(function)}({', '.join(map(self.text, taken))})", node)
        return None

    def _hypothesis(self, value: Hypothesis) -> str:
        """A named hypothesis by its function, told in its own way if it is."""
        for function in _functions(Hypothesis):
            with suppress(TypeError, ValueError):
                made = function(*value.subjects)
                if replace(value, latex=made.latex, text=made.text) == made:
                    text = f"{self.called(function)}({', '.join(map(self.text, value.subjects))})"
                    said = f"latex={self.text(value.latex)}, text={self.text(value.text)}"
                    return text if value == made else f"{self.called(replace)}({text}, {said})"
        return ""


@cache
def _functions(kind: Any) -> tuple[Callable[..., Any], ...]:
    """The functions of the vocabulary, and of the module of a kind of word, that make one."""
    modules = (*ROOMS, matrices, sys.modules[kind.__module__])
    held = (each for module in modules for each in vars(module).values() if isfunction(each))
    named = dict.fromkeys(each for each in held if not each.__name__.startswith("_"))
    return tuple(each for each in named if get_type_hints(each).get("return") is kind)


def imports(used: Iterable[tuple[str, str]]) -> str:
    """The lines that import the names from their modules, those of the package itself last."""
    by_module: dict[str, list[str]] = {}
    for module, name in sorted(used, key=lambda each: (each[0].startswith("."), each[0].startswith("chasles"), each)):
        by_module.setdefault(module, []).append(name)
    lines = {module: f"from {module} import {', '.join(names)}" for module, names in by_module.items()}
    long = {module: laid_out(f"from {module} import ({', '.join(by_module[module])})", behind=3) for module in lines}
    return "".join(f"{line if len(line) <= WIDTH else long[module]}\n" for module, line in lines.items())
