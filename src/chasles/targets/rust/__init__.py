"""Rust: a crate that needs no standard library, with a module for each kernel and a function in either precision.

What `core` lacks, as sines, is called in one module, `math`: the crate `libm`'s functions by default, those of the
standard library with the feature `std`, where nothing has to be fetched. Arrays are Rust's own, nested row by row.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from chasles.lowering.names import Names
from chasles.lowering.passes.prune import pruned
from chasles.lowering.program import Op
from chasles.targets.c.functions import Function, head, precisions_of, unread
from chasles.targets.constants import DOUBLE, SINGLE, Precision, literals
from chasles.targets.dialect import ARITHMETIC, Dialect, Level, Phrase, Shape, call, called, circular, nested
from chasles.targets.kernel import TargetKernel, signature
from chasles.targets.layout import listed
from chasles.targets.spelling import spelled
from chasles.targets.target import Page, Target

_KEYWORDS = """
    as async await box break const continue crate do dyn else enum extern false final fn for gen if impl in let loop
    macro match mod move mut override priv pub ref return self Self static struct super trait true try type typeof
    unsafe unsized use virtual where while yield abstract become union
    bool char f32 f64 i32 str u8 usize core std lib libm main math Some None Ok Err _
"""
_RESERVED = frozenset(_KEYWORDS.split())
_DOUBLE, _SINGLE = replace(DOUBLE, name="f64"), replace(SINGLE, name="f32", suffix="")
_METHODS = {"pow": "powf", "log": "ln", "log1p": "ln_1p", "expm1": "exp_m1", "fabs": "abs"}
"""Functions of C that are called otherwise in Rust's standard library."""
_OPERATORS = {"fmod": "x % y"}
_FROM_C = ("erf", "erfc", "tgamma", "lgamma", "asinh", "acosh", "atanh")
"""Functions that the standard library has not, or from formulas that lose digits: it is linked with those of C."""


def _pages(kernels: tuple[TargetKernel, ...]) -> Iterator[Page]:
    """The crate of all kernels."""
    yield from _crate("", "chasles-kernels", kernels)


def _alone(kernels: tuple[TargetKernel, ...]) -> Iterator[Page]:
    """A crate for each kernel, in a folder of its name."""
    for kernel in kernels:
        yield from _crate(f"{kernel.name}/", f"chasles-{kernel.name}", (kernel,))


def _crate(folder: str, name: str, kernels: tuple[TargetKernel, ...]) -> Iterator[Page]:
    names = Names(_RESERVED)
    modules = [{"name": (word := names.take(kernel.name)), "single": names.take(f"{word}_f32")} for kernel in kernels]
    for kernel, module in zip(kernels, modules, strict=True):
        main = module["name"]
        functions = [_function(kernel, _DOUBLE, main)]
        if SINGLE in precisions_of(kernel):
            functions.append(_function(kernel, _SINGLE, module["single"], main))
        values = {"signature": signature(kernel.program), "functions": functions}
        yield Page(f"{folder}src/{main}.rs", "module.rs.jinja", values)
    used = sorted(set().union(*(called(pruned(kernel.program)) for kernel in kernels)))
    values = {"functions": [function for each in used for function in _wrapped(*each)]}
    yield Page(f"{folder}src/math.rs", "math.rs.jinja", values)
    yield Page(f"{folder}src/lib.rs", "lib.rs.jinja", {"modules": modules})
    yield Page(f"{folder}Cargo.toml", "Cargo.toml.jinja", {"name": name})


def _function(kernel: TargetKernel, precision: Precision, name: str, main: str = "") -> Function:
    program, text = kernel.program, spelled(kernel.program, _DIALECTS[precision])
    inputs = [
        f"{word}: {'&' if item.shape else ''}{_type(item.shape, precision)}"
        for word, item in zip(text.arguments, program.arguments, strict=True)
    ]
    outputs = [_type(result.shape, precision) for result in program.results]
    end = f") -> {_several(outputs)}"
    values = [_array(item.shape, entries) for item, entries in zip(program.results, text.entries, strict=True)]
    return Function(
        name,
        head(kernel, text, main),
        "\n".join(listed(f"pub fn {name}(", inputs, end)),
        (*unread(kernel, text.arguments, "let _ = {};"), *text.lines, _several(values)),
    )


def _several(texts: Sequence[str]) -> str:
    """One as it is, more as a tuple."""
    return texts[0] if len(texts) == 1 else f"({', '.join(texts)})"


def _type(shape: Shape, precision: Precision) -> str:
    text = precision.name
    for extent in reversed(shape):
        text = f"[{text}; {extent}]"
    return text


def _array(shape: Shape, entries: Sequence[str]) -> str:
    """The entries in arrays in arrays."""
    if not shape:
        return entries[0]
    size = len(entries) // shape[0]
    rows = [_array(shape[1:], entries[start : start + size]) for start in range(0, len(entries), size)]
    return f"[{', '.join(rows)}]"


def _wrapped(name: str, operands: int) -> Iterator[dict[str, str]]:
    """The functions of `math` in both precisions, as the standard library has them."""
    for kind, suffix in (("f64", ""), ("f32", "f")):
        words = ("x", "y")[:operands]
        parameters, passed = ", ".join(f"{word}: {kind}" for word in words), ", ".join(words)
        if name in _FROM_C:
            body = f'extern "C" {{ fn {name}{suffix}({parameters}) -> {kind}; }} unsafe {{ {name}{suffix}({passed}) }}'
        else:
            body = _OPERATORS.get(name) or f"x.{_METHODS.get(name, name)}({', '.join(words[1:])})"
        yield {"name": f"{name}{suffix}", "parameters": parameters, "kind": kind, "body": body}


def _dialect(precision: Precision) -> Dialect:
    suffix = "f" if precision is _SINGLE else ""

    def function(name: str, operands: int) -> Phrase:
        return call(f"math::{name}{suffix}", operands)

    def declare(name: str, text: str, truth: bool) -> str:
        return f"let {name}: {'bool' if truth else precision.name} = {text};"

    spell: Mapping[Op, Phrase] = {
        **ARITHMETIC,
        **circular(function),
        Op.NOT_A_NUMBER: Phrase(f"{precision.name}::NAN", Level.ATOM, ()),
        Op.SELECT: Phrase("if {} {{ {} }} else {{ {} }}", Level.CHOICE, (Level.COMPARISON, Level.SUM, Level.SUM)),
    }
    return Dialect(spell, literals(precision), nested, declare, _RESERVED, function=function)


_DIALECTS = {precision: _dialect(precision) for precision in (_DOUBLE, _SINGLE)}
TARGET = Target("rust", Path(__file__).parent, _pages, _alone, by_default=False)
