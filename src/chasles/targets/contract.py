"""What does the head of a generated function say? The kernel's contract, in lines that any comment can hold."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from textwrap import wrap

from chasles.lowering.program import Op, Program
from chasles.targets.kernel import Kernel

__all__ = ["WIDTH", "cited", "contract", "operations", "summary"]

WIDTH = 100
_LABEL = 12
_FIXED_SPACE = "\u00a0"


def cited(number: str) -> str:
    """A number as the book cites it: (3.16), but Thm 3.2.2 as it is."""
    return f"({number})" if number[:1].isdigit() else number


def operations(program: Program) -> str:
    """The operation count: "24: 9 add, 13 multiply, 1 sine, 1 cosine"."""
    counts = program.operations
    parts = [f"{counts[op]} {op.value.replace('_', ' ')}" for op in Op if counts[op]]
    return f"{counts.total()}: {', '.join(parts)}" if parts else "0"


def contract(kernel: Kernel, inputs: Sequence[str], outputs: Sequence[str]) -> tuple[str, ...]:
    """The whole contract; `inputs` and `outputs` are the arguments and results as the language declares them."""
    program = kernel.program
    given = [f"{text}: {item.meaning}" for text, item in zip(inputs, program.arguments, strict=True)]
    returned = [f"{text}: {item.meaning}" for text, item in zip(outputs, program.results, strict=True)]
    return (
        *wrap(f"{cited(kernel.heading.number)} {kernel.heading.says}", WIDTH, subsequent_indent="  "),
        *_labelled("given", given),
        *_labelled("returns", returned),
        *_origin(kernel),
    )


def _origin(kernel: Kernel) -> tuple[str, ...]:
    """Where the kernel comes from: verdict, hypotheses, operation count and the hash of its derivation."""
    heading = kernel.heading
    return (
        *_labelled("verdict", [heading.verdict]),
        *_labelled("assumes", heading.hypotheses or ["nothing"]),
        *_labelled("operations", [operations(kernel.program)]),
        *_labelled("derivation", [f"sha256 {heading.derivation}"]),
    )


def summary(kernel: Kernel, what: str) -> tuple[str, ...]:
    """The head of a variant, whose contract is the main function's: what it is and where it comes from."""
    heading = kernel.heading
    # A hypothesis is not broken across lines.
    assumed = ", ".join(hypothesis.replace(" ", _FIXED_SPACE) for hypothesis in heading.hypotheses) or "nothing"
    return (
        *wrap(f"{cited(heading.number)} {what}.", WIDTH, subsequent_indent="  "),
        *_wrapped(f"verdict: {heading.verdict}; assumes {assumed}"),
        *_wrapped(f"{kernel.program.operations.total()} operations; derivation sha256 {heading.derivation}"),
    )


def _wrapped(text: str) -> tuple[str, ...]:
    lines = wrap(text, WIDTH, initial_indent="  ", subsequent_indent="    ", break_on_hyphens=False)
    return tuple(line.replace(_FIXED_SPACE, " ") for line in lines)


def _origin(kernel: Kernel) -> tuple[str, ...]:
    """Where the kernel comes from: verdict, hypotheses, operation count and the hash of its derivation."""
    heading = kernel.heading
    return (
        *_labelled("verdict", [heading.verdict]),
        *_labelled("assumes", heading.hypotheses or ["nothing"]),
        *_labelled("operations", [operations(kernel.program)]),
        *_labelled("derivation", [f"sha256 {heading.derivation}"]),
    )


def summary(kernel: Kernel, what: str) -> tuple[str, ...]:
    """The head of a variant, whose contract is the main function's: what it is and where it comes from."""
    heading = kernel.heading
    assumed = ", ".join(heading.hypotheses) or "nothing"
    text = (
        f"{cited(heading.number)} {what}. Verdict: {heading.verdict}; assumes {assumed}; "
        f"{kernel.program.operations.total()} operations; derivation sha256 {heading.derivation}"
    )
    return tuple(wrap(text, WIDTH, subsequent_indent="  ", break_on_hyphens=False))


def _labelled(label: str, items: Iterable[str]) -> tuple[str, ...]:
    """The items one below the other, the label before the first."""
    blank = " " * (_LABEL + 2)
    lines: list[str] = []
    for item in items:
        first = f"  {label if not lines else '':<{_LABEL}}"
        lines += wrap(item, WIDTH, initial_indent=first, subsequent_indent=blank + "  ", break_on_hyphens=False)
    return tuple(lines)
