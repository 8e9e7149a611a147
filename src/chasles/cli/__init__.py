"""The command line: `chasles COMMAND`. Exit status 0 fine, 1 something failed its own check, 2 bad usage or input."""

from __future__ import annotations

import os

import click

from chasles import __version__
from chasles.cli.guarded import Guarded

# Matrices have few rows here, and threads wait for each other longer than they work; NumPy reads this once, on import.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
COMMANDS = (
    "list", "show", "decide", "derive", "repair", "solve", "practice", "emit", "verify", "summary", "report",
    "new", "read", "build", "doctor", "completion",
)  # fmt: skip
EXIT_STATUS = """\b
Exit status:
  0    fine; a wrong equation in the book is a finding, not an error
  1    something failed, is undecided, or is not as `chasles emit` makes it
  2    bad usage or input
  130  stopped from the keyboard

Example: chasles show 3.16
"""


@click.group(
    cls=Guarded,
    invoke_without_command=True,
    modules={name: f"chasles.cli.commands.{name}" for name in COMMANDS},
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog=EXIT_STATUS,
)
@click.version_option(__version__, prog_name="chasles")
@click.option(
    "--chapter",
    metavar="PACKAGE",
    help="Another chapter: a package of declarations, by name, also from the current folder, or by its folder's path.",
)
@click.pass_context
def main(context: click.Context, chapter: str | None) -> None:
    """A textbook chapter on rigid-body mechanics as checked code and fast kernels."""
    if context.invoked_subcommand is None:
        click.echo(context.get_help())
