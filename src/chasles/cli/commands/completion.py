"""`chasles completion SHELL`."""

from __future__ import annotations

import click

from chasles.cli.book import as_data, print_data

VARIABLE = "_CHASLES_COMPLETE"
"""What Click reads to know that a shell asks for words."""
ABOUT = """Print what makes a shell complete commands, options, equation numbers, kernels and exercises.

\b
bash  eval "$(chasles completion bash)"         in ~/.bashrc; bash 4.4 or newer
zsh   eval "$(chasles completion zsh)"          in ~/.zshrc, after compinit
fish  chasles completion fish | source          in ~/.config/fish/config.fish
"""


@click.command(
    "completion",
    help=ABOUT,
    short_help="Let a shell complete commands and numbers.",
    epilog='Example: chasles completion bash, or in a start-up file: eval "$(chasles completion bash)"',
)
@click.argument("shell", type=click.Choice(["bash", "zsh", "fish"]))
@as_data
def command(shell: str, json: bool) -> None:
    """Print what makes a shell complete commands, options, equation numbers, kernels and exercises."""
    from click.shell_completion import get_completion_class

    group = click.get_current_context().find_root().command
    kind = get_completion_class(shell)
    assert kind is not None
    script = kind(group, {}, "chasles", VARIABLE).source()
    if json:
        print_data({"shell": shell, "script": script})
    else:
        click.echo(script)
