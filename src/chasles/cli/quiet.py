"""Quiet commands: `-q` prints errors only, and the JSON that was asked for."""

from __future__ import annotations

import os
from collections.abc import Callable
from contextlib import redirect_stdout
from functools import wraps
from pathlib import Path
from typing import Any

import click

_ASKED = "chasles.cli.quiet"


def quiet_option() -> click.Option:
    """The option `-q`, of the whole command line and of each command."""
    says = "Print errors only, and JSON with --json."
    return click.Option(["-q", "--quiet"], is_flag=True, expose_value=False, callback=_remember, help=says)


def is_quiet() -> bool:
    """Whether `-q` was given, before the command's name or after it."""
    context = click.get_current_context(silent=True)
    return context is not None and bool(context.meta.get(_ASKED))


def can_be_quiet(command: click.Command) -> click.Command:
    """The command with the option `-q`."""
    if command.callback is not None and not any(parameter.name == "quiet" for parameter in command.params):
        command.params.append(quiet_option())
        command.callback = _muffled(command.callback)
    return command


def _remember(context: click.Context, parameter: click.Parameter, value: bool) -> None:
    if value:
        context.meta[_ASKED] = True


def _muffled(callback: Callable[..., Any]) -> Callable[..., Any]:
    """The callback, whose standard output goes nowhere where quiet is asked for and JSON is not."""

    @wraps(callback)
    def called(*words: Any, **options: Any) -> Any:
        if not is_quiet():
            return callback(*words, **options)
        from chasles.report.waiting import silent

        if options.get("json"):
            with silent():
                return callback(*words, **options)
        with Path(os.devnull).open("w", encoding="utf-8") as nowhere, redirect_stdout(nowhere), silent():
            return callback(*words, **options)

    return called
