"""How a notebook displays things: each as HTML, as LaTeX and in plain text, in the pieces of the report.

Nothing is decided, simplified or derived here: what is shown is what the thing holds.
"""

from chasles.report.notebook.html import html
from chasles.report.notebook.latex import latex
from chasles.report.notebook.text import text

__all__ = ["html", "latex", "text"]
