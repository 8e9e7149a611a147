"""A worked solution as HTML: MathML formulas and the picture as SVG inside, no script, nothing from elsewhere."""

from __future__ import annotations

import re
from collections.abc import Iterator
from html import escape
from io import StringIO
from itertools import count
from typing import Any

from latex2mathml.converter import convert

from chasles.exact.spelling import decimal_text, latex_of
from chasles.exercises.formulas import Proofs
from chasles.exercises.solution import Formula, Solution, SolutionStep, cited

_PAGE = """
:root { color-scheme: light dark; }
body { font: 1rem/1.5 system-ui, sans-serif; max-width: 46rem; margin: 2rem auto; padding: 0 1rem; }
"""
_WORKED = """
.worked li { margin: 0.8rem 0; }
.worked math { font-size: 1.05rem; }
.worked .line { overflow: auto hidden; margin: 0.1rem 0; padding: 0.3rem 0; }
.worked .cites, .worked .decimals { opacity: 0.75; font-size: 0.9rem; }
.worked table { border-collapse: collapse; display: block; overflow: auto hidden; }
.worked .answers th { text-align: left; padding: 0.3rem 1rem 0.3rem 0; font-weight: 600; vertical-align: top; }
.worked .answers td { text-align: left; padding: 0.3rem 0; }
.worked svg { max-width: 100%; height: auto; background: white; }
"""


def as_page(solution: Solution) -> str:
    """A whole page."""
    title = escape(f"Exercise {solution.exercise}: {solution.title}")
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta name="viewport" content="width=device-width">\n<title>{title}</title>\n<style>{_PAGE}</style>\n'
        f"</head>\n<body>\n{as_html(solution)}</body>\n</html>\n"
    )


def as_html(solution: Solution) -> str:
    """The part of a page that shows the solution, as a notebook does."""
    return "\n".join(_parts(solution)) + "\n"


def _parts(solution: Solution) -> Iterator[str]:
    yield f'<section class="worked">\n<style>{_WORKED}</style>'
    yield f"<h1>Exercise {escape(solution.exercise)}: {escape(solution.title)}</h1>"
    yield "<ol class='asked'>" + "".join(f"<li>{escape(text)}</li>" for text in solution.asked) + "</ol>"
    if solution.assumptions:
        yield "<p>Assumed: " + " ".join(escape(text) for text in solution.assumptions) + "</p>"
    yield "<h2>Solution</h2>\n<ol>"
    yield from map(_step, solution.steps)
    yield f"</ol>\n<h2>Answer: {escape(solution.outcome)}</h2>\n<table class='answers'>"
    for name, value in solution.answers.items():
        says = escape(solution.means.get(name, ""))
        yield f"<tr><th>{escape(name)}</th><td>{_answer(value)}<div>{says}</div></td></tr>"
    yield "</table>"
    if solution.checks:
        yield "<h2>Substituted back</h2>\n<ul>" + "".join(map(_step, solution.checks)) + "</ul>"
    yield from _picture(solution)
    yield "</section>"


def _step(step: SolutionStep) -> str:
    cites = cited(step.cites)
    beside = f' <span class="cites">{escape(cites)}</span>' if cites else ""
    return f"<li>{escape(step.says)}{beside}{''.join(map(_line, step.lines))}</li>"


def _line(line: Formula) -> str:
    return f'<div class="line">{_formula(line.latex)}{_decimals(line.decimals)}</div>'


def _answer(value: Any) -> str:
    if isinstance(value, Proofs):
        return "<br>".join(escape(line) for line in value.as_text().split("\n"))
    return _formula(latex_of(value)) + _decimals(decimal_text(value))


def _decimals(decimals: str) -> str:
    return f' <span class="decimals">&asymp; {escape(decimals)}</span>' if decimals else ""


def _formula(latex: str) -> str:
    # The converter leaves the backslash before an underscore in words.
    return str(convert(latex)).replace(r"\_", "_")


def _picture(solution: Solution) -> Iterator[str]:
    if solution.picture is None:
        return
    try:
        figure = solution.figure()
    except ImportError as error:
        yield f"<p>{escape(str(error))}</p>"
        return
    drawn = StringIO()
    figure.savefig(drawn, format="svg", metadata={"Date": None})
    yield f"<figure>{_without_random_names(drawn.getvalue()[drawn.getvalue().index('<svg') :])}</figure>"


def _without_random_names(svg: str) -> str:
    """The drawing with its inner names counted: they are random as matplotlib gives them."""
    names: dict[str, str] = {}
    numbers = count(1)
    for name in re.findall(r'id="([mp][0-9a-f]{10})"', svg):
        names.setdefault(name, f"part{next(numbers)}")
    for name, number in names.items():
        svg = svg.replace(name, number)
    return svg
