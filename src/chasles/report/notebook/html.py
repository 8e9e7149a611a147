"""Things as HTML: one template, fed with what the report shows of them."""

from __future__ import annotations

import re

from chasles.exercises.solution import Solution
from chasles.report.html.exercises import view_of
from chasles.report.html.filling import filled
from chasles.report.html.palette import LIGHT
from chasles.report.notebook.alone import as_displayed
from chasles.report.notebook.cards import card_of

_LINK = re.compile(r'<a href="#[^"]*">(.*?)</a>')
"""A reference within the report's page, which leads nowhere here."""


def html(value: object) -> str:
    """The part of a page that shows the value. Raises TypeError for what is not displayed."""
    if isinstance(value, Solution):
        return worked(value)
    return _LINK.sub(r"\1", filled("notebook.html.jinja", card=card_of(as_displayed(value)), light=LIGHT))


def worked(solution: Solution, whole: bool = False) -> str:
    """A worked solution, its picture inside; as a `whole` page it needs nothing from elsewhere."""
    return str(filled("solution.html.jinja", one=view_of(solution), light=LIGHT, whole=whole))
