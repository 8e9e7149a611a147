"""A certificate in words: what is put in, by what is divided, and that nothing is left."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

from markupsafe import Markup, escape

from chasles.report.html.citing import Book

SHOWN = 6
"""So many terms are named for which a hypothesis is used."""
LONG = 24
"""Lengths with longer names are counted, not named."""
CODE = Markup("<code>{}</code>")
RATES = {" (dot)": "the rate of ", " (ddot)": "the second rate of "}


def proof_in_words(book: Book, certificate: Mapping[str, Any]) -> Iterator[Markup]:
    """A sentence for each thing that the checker does; of an inverse with cases, for each case."""
    for says, case in certificate.get("branches", {}).items():
        yield Markup("{}: {}").format(says, Markup(" ").join(_of_one(book, case)))
    if "branches" not in certificate:
        yield from _of_one(book, certificate)


def _of_one(book: Book, certificate: Mapping[str, Any]) -> Iterator[Markup]:
    if certificate.get("spins"):
        yield Markup("Rates of a rotation are written by its angular velocity.")
    if solved := certificate.get("solved"):
        yield _put_in(solved)
    if division := certificate.get("division"):
        lead = Markup("Expanded over a common denominator, the difference of the two sides is divided by {}: ")
        yield lead.format(Markup("; ").join(_divisors(book, division))) + Markup("nothing is left.")
    else:
        yield Markup("Expanded over a common denominator, the two sides are the same polynomial.")


def _put_in(solved: Mapping[str, Mapping[str, Any]]) -> Markup:
    """Which quantities follow from which statements."""
    names = dict.fromkeys(re.sub(r"_\d+$", "", name) for name in solved)
    labels = (label for value in solved.values() for label in value.get("cofactors", ()))
    sources = dict.fromkeys(re.sub(r"^\d+\. | \[.*\]$", "", label) for label in labels)
    listed = Markup(", ").join(map(CODE.format, names))
    return Markup("{} is found from {} and put in.").format(listed, ", ".join(sources) or "what is given")


def _divisors(book: Book, division: list[list[str]]) -> Iterator[Markup]:
    """What vanishes, each with the terms that it replaces."""
    groups: dict[str, list[str]] = {}
    for label, term in division:
        groups.setdefault(re.sub(r" \[[^\]]*\]$", "", label), []).append(term)
    long = [label for label in groups if label.startswith("norm ") and len(label) > LONG]
    for label, terms in groups.items():
        if label not in long:
            named = Markup(", ").join(map(CODE.format, terms[:SHOWN]))
            more = f" and {len(terms) - SHOWN} more" if len(terms) > SHOWN else ""
            yield Markup("{} (for {}{})").format(_said(book, label), named, more)
    if long:
        yield Markup("the square of a length" if len(long) == 1 else f"the squares of {len(long)} lengths")


def _said(book: Book, label: str) -> Markup:
    """What vanishes, in the words of the statement."""
    for ending, lead in RATES.items():
        if label.endswith(ending):
            return escape(lead) + book.condition(label.removesuffix(ending))
    kind, _, of = label.partition(" ")
    if kind == "circle":
        return CODE.format(f"cos({of})^2 + sin({of})^2 = 1")
    if kind == "norm":
        vector = of[1:-1]
        return CODE.format(f"{of}^2 = ({vector}) . ({vector})" if " " in of else f"{of}^2 = {vector} . {vector}")
    return book.condition(label)
