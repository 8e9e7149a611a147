"""The group of all commands: none ends in a traceback."""

from __future__ import annotations

import os
import sys
from io import TextIOWrapper
from traceback import print_exc
from typing import Any

import click

from chasles.cli.failures import BAD_INPUT, FAILED, Failure, say
from chasles.cli.quiet import can_be_quiet, quiet_option
from chasles.nearest import nearest

INTERRUPTED = 130
DEBUG = "CHASLES_DEBUG"


class Guarded(click.Group):
    """A group of commands, each module imported when its command is called; no command ends in a traceback."""

    def __init__(self, *args: Any, modules: dict[str, str], **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self._modules = modules
        self.params.append(quiet_option())

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(self._modules)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        from importlib import import_module

        if cmd_name not in self._modules:
            return None
        command = import_module(self._modules[cmd_name]).command
        assert isinstance(command, click.Command)
        return can_be_quiet(command)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        if args and not args[0].startswith("-") and args[0] not in self._modules:
            raise click.UsageError(f"there is no command {args[0]!r}{nearest(args[0], list(self._modules))}", ctx)
        return super().resolve_command(ctx, args)

    def invoke(self, ctx: click.Context) -> Any:
        try:
            return super().invoke(ctx)
        except (Failure, click.ClickException, click.exceptions.Exit, click.Abort, OSError):
            raise
        except Exception as error:
            from chasles.cli.chosen_chapter import place

            where = None if _is_of_a_declaration(error) or os.environ.get(DEBUG) else place(error)
            if where is None:
                raise
            said = str(error) if getattr(error, "place", "") else f"{where}: {type(error).__name__}: {error}"
            raise Failure(said, BAD_INPUT) from error

    def main(self, *args: Any, **kwargs: Any) -> Any:
        sys.exit(self._status(*args, **kwargs))

    def _status(self, *args: Any, **kwargs: Any) -> int:
        """The exit status; whatever went wrong has been said."""
        kwargs["standalone_mode"] = False
        _show_what_can_be_shown()
        try:
            return int(super().main(*args, **kwargs) or 0)
        except click.exceptions.Exit as end:
            return end.exit_code
        except Failure as failure:
            say(str(failure))
            return failure.status
        except click.ClickException as error:
            say(_with_help(error))
            return error.exit_code
        except (click.Abort, KeyboardInterrupt):
            say("stopped")
            return INTERRUPTED
        except BrokenPipeError:
            # The reader has left; Python would complain once more when it flushes at the end.
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            return FAILED
        except Exception as error:
            if os.environ.get(DEBUG):
                print_exc()
            if _is_of_a_declaration(error):
                say(str(error))
                return BAD_INPUT
            say(
                f"this is a defect of chasles: {type(error).__name__}: {error}. "
                f"Please report it, with what the same command prints under {DEBUG}=1"
            )
            return FAILED


def _show_what_can_be_shown() -> None:
    """A name that the terminal's encoding lacks, as Plücker's may be, must not end the command."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(errors="replace")


def _with_help(error: click.ClickException) -> str:
    message = error.format_message().rstrip(".")
    if isinstance(error, click.UsageError) and error.ctx is not None:
        return f"{message}; see `{error.ctx.command_path} --help`"
    return message


def _is_of_a_declaration(error: Exception) -> bool:
    """Whether a chapter or an exercise is declared wrongly: that is its author's to mend."""
    from chasles.statements import DeclarationError

    return isinstance(error, DeclarationError)
