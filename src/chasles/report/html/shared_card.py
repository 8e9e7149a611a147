"""The picture of an erratum that is shown where its page is shared: what is printed, and what is right."""

from __future__ import annotations

from importlib.util import find_spec
from io import BytesIO
from textwrap import wrap

from chasles.report.html.palette import LIGHT
from chasles.report.html.shown import NumberShown

WIDTH, HEIGHT, DOTS = 12.0, 6.3, 100
COLUMNS, LINES = 62, 5


def drawn_card(number: NumberShown, source: str) -> bytes | None:
    """A PNG of 1200 x 630 dots; None for a number that is true as printed, and where Matplotlib is not installed."""
    wrong = [part for part in number.parts if part.instead]
    if not wrong or find_spec("matplotlib") is None:
        return None
    from matplotlib.figure import Figure

    part = wrong[0]
    figure = Figure(figsize=(WIDTH, HEIGHT), dpi=DOTS, facecolor=LIGHT["ground"])
    blocks = (
        (f"{number.cited}  {part.badge.word}", 34, LIGHT["bad"], "DejaVu Sans"),
        ("as printed", 17, LIGHT["quiet"], "DejaVu Sans"),
        (_lines(part.equations[0].words), 20, LIGHT["ink"], "DejaVu Sans Mono"),
        ("right is", 17, LIGHT["quiet"], "DejaVu Sans"),
        (_lines(part.instead[0].equation.words), 20, LIGHT["good"], "DejaVu Sans Mono"),
    )
    top = 0.93
    for text, size, colour, family in blocks:
        figure.text(0.04, top, text, size=size, color=colour, family=family, va="top", parse_math=False)
        top -= (text.count("\n") + 1) * size * 1.45 / (HEIGHT * 72) + 0.02
    figure.text(0.04, 0.04, source, size=14, color=LIGHT["quiet"], family="DejaVu Sans", va="bottom", wrap=True)
    file = BytesIO()
    figure.savefig(file, format="png", metadata={"Software": None})
    return file.getvalue()


def _lines(text: str) -> str:
    lines = wrap(text, COLUMNS, break_long_words=False)
    return "\n".join(lines if len(lines) <= LINES else [*lines[: LINES - 1], "..."])
