"""Things as HTML: one template, fed with what the report shows of them."""

from __future__ import annotations

import re
from functools import cache

from jinja2 import Template

from chasles.report.html.page import environment
from chasles.report.html.palette import LIGHT
from chasles.report.notebook.cards import card_of

__all__ = ["html"]

_LINK = re.compile(r'<a href="#[^"]*">(.*?)</a>')
"""A reference within the report's page, which leads nowhere here."""


def html(value: object) -> str:
    """The part of a page that shows the value. Raises TypeError for what is not displayed."""
    return _LINK.sub(r"\1", _template().render(card=card_of(value), light=LIGHT))


@cache
def _template() -> Template:
    return environment().get_template("notebook.html.jinja")
