"""A page that was read as HTML: its displayed equations in its own LaTeX, what was found of each in the margin."""

from __future__ import annotations

from collections.abc import Iterator
from html import escape
from itertools import groupby

from latex2mathml.converter import convert

from chasles.pages.findings_told import is_fine, line_of
from chasles.pages.page import ReadPage
from chasles.pages.page_equation import PageEquation

_STYLE = """
:root { color-scheme: light dark; }
body { font: 1rem/1.5 system-ui, sans-serif; max-width: 70rem; margin: 2rem auto; padding: 0 1rem; }
article { display: grid; grid-template-columns: 3fr 2fr; gap: 0 2rem; border-top: 1px solid #8884; padding: 0.6rem 0; }
article > div { overflow: auto hidden; }
aside { font-size: 0.9rem; border-left: 0.3rem solid #8888; padding-left: 0.6rem; overflow-wrap: anywhere; }
aside.wrong { border-color: #c33; }
aside.fine { border-color: #393; }
aside p { margin: 0.2rem 0; }
small { opacity: 0.7; }
"""


def read_page_as_html(page: ReadPage) -> str:
    """The whole as one file, with nothing from elsewhere and no script."""
    title = escape(page.file or "page")
    body = "\n".join(_articles(page))
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta name="viewport" content="width=device-width">\n<title>{title}</title>\n<style>{_STYLE}</style>\n'
        f"</head>\n<body>\n<h1>{title}</h1>\n<p>{escape(page.summary)}</p>\n{body}\n</body>\n</html>\n"
    )


def _articles(page: ReadPage) -> Iterator[str]:
    section = None
    for _, parts in groupby(page.equations, key=lambda each: id(each.read)):
        found = list(parts)
        printed = found[0].printed
        if printed.section != section:
            section = printed.section
            yield f"<h2>{escape(section or '')}</h2>"
        name = escape(f"({printed.number or printed.label})" if printed.number or printed.label else "")
        yield (
            f"<article><div>{_formula(printed.latex)} {name} <small>line {printed.line}</small></div>\n"
            f"{''.join(_margin(each, page.file) for each in found)}</article>"
        )


def _margin(each: PageEquation, file: str) -> str:
    kind = "fine" if is_fine(each) else "wrong" if each.verdict in ("fails", "ill-formed") else "open"
    text = line_of(each, file).removeprefix(f"{each.printed.file or file}:{each.line}:").strip()
    return f'<aside class="{kind}"><p>{escape(text)}</p></aside>'


def _formula(latex: str) -> str:
    """MathML; the LaTeX itself where that cannot be made, or would lead elsewhere: a page may be anybody's."""
    try:
        made = convert(latex, display="block")
    except Exception:  # the converter raises whatever it stumbles on
        made = ""
    is_safe = made and not any(word in made.lower() for word in ("href", "src=", "style=", "<script"))
    return made if is_safe else f"<code>{escape(latex)}</code>"
