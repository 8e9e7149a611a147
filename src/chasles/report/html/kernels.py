"""The kernels that were emitted, as their manifest tells: names, signatures, counts of operations, proved bounds."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from chasles.bounds.bound import Bound
from chasles.report.details import number_in_words
from chasles.report.emission_records import emitted_kernels
from chasles.report.html.citing import Book, Link, place_of_number, slug
from chasles.report.html.shown import KernelRow

FORMS = {"stated": "as stated", "offered": "in a form proved equal"}


def kernel_rows(book: Book, manifest: str) -> dict[str, KernelRow]:
    """The kernels of the chapter by name, in the manifest's order; those that are not of this chapter are left out."""
    known = {kernel.name for entry in book.chapter for kernel in entry.kernels}
    return {name: _row(book, name, kernel) for name, kernel in emitted_kernels(manifest).items() if name in known}


def _row(book: Book, name: str, kernel: Mapping[str, Any]) -> KernelRow:
    counts: Mapping[str, int] = kernel["operations"]
    number = kernel["number"]
    return KernelRow(
        name=name,
        place=f"kernel-{slug(name)}",
        number=Link(f"#{place_of_number(number)}", number_in_words(number)),
        says=kernel["says"],
        signature=kernel["signature"],
        needs=tuple(book.condition(text) for text in kernel["hypotheses"]),
        total=sum(counts.values()),
        operations=", ".join(f"{count} {kind.replace('_', ' ')}" for kind, count in counts.items()) or "none",
        bound=Bound.from_data(kernel["bound"]).in_words if kernel.get("bound") else (),
        form=FORMS.get(kernel["form"], kernel["form"]),
    )
