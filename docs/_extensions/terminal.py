"""The README's picture: what a command prints, as an SVG that loads nothing.

`python docs/_extensions/terminal.py` makes it anew; a test says when that is due.
"""

from __future__ import annotations

import re
import subprocess
import sys
from io import StringIO
from os import environ
from pathlib import Path

from rich.console import Console
from rich.terminal_theme import DEFAULT_TERMINAL_THEME
from rich.text import Text

PICTURE = Path(__file__).parents[1] / "_static" / "decide.svg"
COMMAND = ("decide", "3.96e", "--brief")
WIDTH = 92

FORMAT = """\
<svg class="rich-terminal" viewBox="0 0 {width} {height}" xmlns="http://www.w3.org/2000/svg">
  <title>What chasles says of equation (3.96e)</title>
  <style>
  .{unique_id}-matrix {{ font-family: ui-monospace, Menlo, Consolas, "DejaVu Sans Mono", monospace;
    font-size: {char_height}px; line-height: {line_height}px; }}
  {styles}
  </style>
  <defs>
  <clipPath id="{unique_id}-clip-terminal">
    <rect x="0" y="0" width="{terminal_width}" height="{terminal_height}" />
  </clipPath>
  {lines}
  </defs>
  <rect fill="#ffffff" stroke="#888888" x="1" y="1" width="99.8%" height="99.5%" rx="8"/>
  <g transform="translate(16, 12) scale(.95)" clip-path="url(#{unique_id}-clip-terminal)">
  {backgrounds}
  <g class="{unique_id}-matrix">
  {matrix}
  </g>
  </g>
</svg>
"""


def printed() -> str:
    """What the command prints in a terminal of so many columns, without the time that it took."""
    environment = environ | {"COLUMNS": str(WIDTH), "CLICOLOR_FORCE": "1", "NO_COLOR": "", "PYTHONIOENCODING": "utf-8"}
    program = [sys.executable, "-c", "from chasles.cli import main; main()", *COMMAND]
    done = subprocess.run(program, capture_output=True, text=True, encoding="utf-8", env=environment, check=True)
    return re.sub(r"\n[^\n]*\bdecided in[^\n]*", "", done.stdout).strip("\n")


def drawn(text: str) -> str:
    """The text, with its colours, as SVG."""
    console = Console(record=True, width=WIDTH, file=StringIO(), force_terminal=True, legacy_windows=False)
    command = Text(f"$ chasles {' '.join(COMMAND)}\n", style="bold")
    console.print(command, Text.from_ansi(text), sep="\n", soft_wrap=False)
    return console.export_svg(theme=DEFAULT_TERMINAL_THEME, code_format=FORMAT, unique_id="chasles")


if __name__ == "__main__":
    PICTURE.write_text(drawn(printed()), "utf-8")
