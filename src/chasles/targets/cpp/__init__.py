"""C++20: a header for each kernel, with functions of spans in both precisions and, with Eigen, of its matrices.

The text is the same as in C but for how numbers come in and out; where a name of the kernel is a word of C++, an
underscore follows it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from pathlib import Path

from chasles.lowering.names import Names
from chasles.lowering.program import Argument, Op, Result
from chasles.targets.c.functions import PRECISIONS, Function, head, precisions_of, unread
from chasles.targets.c.language import RESERVED
from chasles.targets.constants import SINGLE, Precision, literals
from chasles.targets.dialect import ARITHMETIC, CONDITIONAL, Dialect, Phrase, Shape, call, circular, flat
from chasles.targets.kernel import TargetKernel, signature
from chasles.targets.layout import listed
from chasles.targets.spelling import spelled
from chasles.targets.target import Page, Target

_RESERVED = RESERVED | {"std", "Eigen", "chasles"}
_MOST_AXES = 2
"""Eigen has no arrays of more axes."""


def _pages(kernels: tuple[TargetKernel, ...]) -> Iterator[Page]:
    for kernel in kernels:
        precisions = precisions_of(kernel)
        values = {
            "guard": f"CHASLES_{kernel.name.upper()}",
            "signature": signature(kernel.program),
            "functions": [_function(kernel, precision) for precision in precisions],
            "overloads": [_overload(kernel, precision) for precision in precisions] if _is_for_eigen(kernel) else [],
        }
        yield Page(f"{kernel.name}.hpp", "kernel.hpp.jinja", values)


def _dialect(precision: Precision) -> Dialect:
    def function(name: str, operands: int) -> Phrase:
        return call(f"std::{name}", operands)

    spell = {
        **ARITHMETIC,
        **circular(function),
        Op.NOT_A_NUMBER: call(f"std::numeric_limits<{precision.name}>::quiet_NaN", 0),
        Op.SELECT: CONDITIONAL,
    }
    return Dialect(
        spell,
        literals(precision),
        flat,
        lambda name, text, truth: f"const {'bool' if truth else precision.name} {name} = {text};",
        _RESERVED,
        function=function,
    )


_DIALECTS = {precision: _dialect(precision) for precision in PRECISIONS}


def _function(kernel: TargetKernel, precision: Precision) -> Function:
    """The function of spans."""
    program, text = kernel.program, spelled(kernel.program, _DIALECTS[precision])
    name = _name(kernel)
    words = zip((*text.arguments, *text.results), program.parameters, strict=True)
    stores = [
        f"{word}[{place}] = {entry};" if item.shape else f"{word} = {entry};"
        for word, item, entries in zip(text.results, program.results, text.entries, strict=True)
        for place, entry in enumerate(entries)
    ]
    parameters = [_scalar(word, item, precision) or f"{_span(item, precision)} {word}" for word, item in words]
    lines = (*unread(kernel, text.arguments), *text.lines, *stores)
    comment = head(kernel, text, name if precision is SINGLE else "")
    return Function(name, comment, _prototype(name, parameters), lines)


def _overload(kernel: TargetKernel, precision: Precision) -> Function:
    """The function of Eigen's vectors and matrices, which calls the one of spans."""
    program, name, names = kernel.program, _name(kernel), Names(_RESERVED)
    parameters, before, passed, after = [], [], [], []
    for word, item in [(names.take(item.name), item) for item in program.parameters]:
        scalar = _scalar(word, item, precision)
        if scalar:
            parameters.append(scalar)
            passed.append(word)
            continue
        matrix, rows = _matrix(item.shape, precision), names.take(f"{word}_rows")
        columns = matrix.replace(", Eigen::RowMajor", "")
        if isinstance(item, Argument):
            parameters.append(f"const Eigen::Ref<const {columns}> &{word}")
            before.append(f"const {matrix} {rows}({word});")
        else:
            parameters.append(f"Eigen::Ref<{columns}> {word}")
            before.append(f"{matrix} {rows};")
            after.append(f"{word} = {rows};")
        passed.append(f"{_span(item, precision)}({rows}.data(), {math.prod(item.shape)})")
    return Function(
        name, (), _prototype(name, parameters), (*before, *listed(f"chasles::{name}(", passed, ");"), *after)
    )


def _name(kernel: TargetKernel) -> str:
    return Names(_RESERVED).take(kernel.name)


def _is_for_eigen(kernel: TargetKernel) -> bool:
    axes = [len(item.shape) for item in kernel.program.parameters]
    return 0 < max(axes) <= _MOST_AXES


def _scalar(word: str, item: Argument | Result, precision: Precision) -> str:
    """The declaration of a number; empty for an array."""
    if item.shape:
        return ""
    return f"{precision.name} {word}" if isinstance(item, Argument) else f"{precision.name} &{word}"


def _span(item: Argument | Result, precision: Precision) -> str:
    return f"std::span<{'const ' if isinstance(item, Argument) else ''}{precision.name}, {math.prod(item.shape)}>"


def _matrix(shape: Shape, precision: Precision) -> str:
    """Eigen's type, whose numbers lie row by row; a vector is a column."""
    rows, columns = (*shape, 1)[:2]
    order = ", Eigen::RowMajor" if rows > 1 and columns > 1 else ""
    return f"Eigen::Matrix<{precision.name}, {rows}, {columns}{order}>"


def _prototype(name: str, parameters: Sequence[str]) -> str:
    return "\n".join(listed(f"inline void {name}(", parameters, ")"))


TARGET = Target("cpp", Path(__file__).parent, _pages, _pages, by_default=False)
