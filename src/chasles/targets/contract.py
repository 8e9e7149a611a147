"""What does the head of a generated function say? The kernel's contract, in lines that any comment can hold."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from textwrap import wrap

from chasles.lowering.program import Op, Program
from chasles.targets.kernel import TargetKernel, signature

_WIDTH = 100
_LABEL = 12
ROUNDOFF = "2^-53, in single precision 2^-24"
_FIXED_SPACE = "\u00a0"


def cited(number: str) -> str:
    """A number as the book cites it: (3.16), but Thm 3.2.2 as it is."""
    return f"({number})" if number[:1].isdigit() else number


def operations(program: Program) -> str:
    """The operation count: "24: 6 add, 4 subtract, 12 multiply, 1 sine, 1 cosine"."""
    counts = program.operations
    parts = [f"{counts[op]} {op.value.replace('_', ' ')}" for op in Op if counts[op]]
    return f"{counts.total()}: {', '.join(parts)}" if parts else "0"


def contract(kernel: TargetKernel, inputs: Sequence[str], outputs: Sequence[str]) -> tuple[str, ...]:
    """The whole contract; `inputs` and `outputs` are the arguments and results as the language declares them."""
    program, heading = kernel.program, kernel.heading
    given = [f"{text}: {item.meaning}" for text, item in zip(inputs, program.arguments, strict=True)]
    returned = [f"{text}: {item.meaning}" for text, item in zip(outputs, program.results, strict=True)]
    return (
        *wrap(f"{cited(heading.number)} {heading.says}", _WIDTH, subsequent_indent="  "),
        *_labelled("given", given),
        *_labelled("returns", returned),
        *_labelled("verdict", [heading.verdict]),
        *_labelled("assumes", heading.hypotheses or ["nothing"]),
        *_labelled("expects", heading.expected),
        *_labelled("made of", ["an offered form, proved equal to the statement"] if heading.form == "offered" else ()),
        *_labelled("operations", [operations(program)]),
        *_labelled("error bound", _bounded(kernel)),
        *_labelled("derivation", [f"sha256 {heading.derivation}"]),
    )


def contract_in_arrays(kernel: TargetKernel, words: Sequence[str] = ()) -> tuple[str, ...]:
    """The contract of a function of arrays with its signature; `words` are its parameters where these have other names.

    The shapes are those of one item: batch axes come before.
    """
    parameters, count = kernel.program.parameters, len(kernel.program.arguments)
    named = zip(words or [item.name for item in parameters], parameters, strict=True)
    shown = [f"{name} ({', '.join(map(str, item.shape))})" if item.shape else name for name, item in named]
    return (*contract(kernel, shown[:count], shown[count:]), f"  {'signature':<{_LABEL}}{signature(kernel.program)}")


def summary(kernel: TargetKernel, what: str) -> tuple[str, ...]:
    """The head of a variant, whose contract is the main function's: what it is and where it comes from."""
    heading = kernel.heading
    # A hypothesis is not broken across lines.
    assumed = ", ".join(hypothesis.replace(" ", _FIXED_SPACE) for hypothesis in heading.hypotheses) or "nothing"
    return (
        *wrap(f"{cited(heading.number)} {what}", _WIDTH, subsequent_indent="  "),
        *_indented(f"verdict: {heading.verdict}; assumes {assumed}", "  "),
        *_indented(f"{kernel.program.operations.total()} operations; derivation sha256 {heading.derivation}", "  "),
    )


def _bounded(kernel: TargetKernel) -> tuple[str, ...]:
    """What is proved of the errors, a line for each result, what u is, and under which rounding model."""
    if not kernel.box_bounds and kernel.bound is None:
        return ()
    # Where nothing is bounded that is not imported.
    from chasles.bounds.model import SINGLE

    supposed = f"supposed: {SINGLE.in_words(kernel.program.operations)}"
    if kernel.box_bounds:
        return (*(line for bound in kernel.box_bounds for line in str(bound).splitlines()), supposed)
    assert kernel.bound is not None
    *lines, last = kernel.bound.in_words
    if all(guarantee.against == "nothing" for guarantee in kernel.bound.guarantees):
        return (*lines, last)
    return (*lines, f"{last}; u = {ROUNDOFF}", supposed)


def _labelled(label: str, items: Iterable[str]) -> tuple[str, ...]:
    """The items one below the other, the label before the first."""
    lines: list[str] = []
    for item in items:
        lines += _indented(item, f"  {'' if lines else label:<{_LABEL}}")
    return tuple(lines)


def _indented(text: str, start: str) -> tuple[str, ...]:
    """The text after `start`, further lines two deeper."""
    further = " " * (len(start) + 2)
    lines = wrap(text, _WIDTH, initial_indent=start, subsequent_indent=further, break_on_hyphens=False)
    return tuple(line.replace(_FIXED_SPACE, " ") for line in lines)
