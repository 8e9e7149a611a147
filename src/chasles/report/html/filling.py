"""Templates of the page, filled in: text is escaped, a value that is missing is an error."""

from __future__ import annotations

from functools import cache
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup


def filled(template: str, **values: object) -> Markup:
    """The template with these values."""
    return Markup(environment().get_template(template).render(values))


@cache
def environment(autoescape: bool = True, **marks: Any) -> Environment:
    """The templates of the report, with their usual marks or others."""
    return Environment(
        loader=PackageLoader("chasles.report"),
        autoescape=autoescape,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        **marks,
    )
