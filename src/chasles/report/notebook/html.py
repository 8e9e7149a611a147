"""Things as HTML: one template, fed with what the report shows of them."""

from __future__ import annotations

import re

from chasles.exercises.solution import Solution
from chasles.exercises.worksheet_html import as_html
from chasles.report.html.filling import filled
from chasles.report.html.palette import LIGHT
from chasles.report.notebook.alone import as_displayed
from chasles.report.notebook.cards import card_of

_LINK = re.compile(r'<a href="#[^"]*">(.*?)</a>')
"""A reference within the report's page, which leads nowhere here."""


def html(value: object) -> str:
    """The part of a page that shows the value. Raises TypeError for what is not displayed."""
    if isinstance(value, Solution):
        return as_html(value)
    return _LINK.sub(r"\1", filled("notebook.html.jinja", card=card_of(as_displayed(value)), light=LIGHT))
