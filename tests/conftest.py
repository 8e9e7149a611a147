"""For all tests: how to renew the golden files, and where a test says what it found."""

from __future__ import annotations

import os

import pytest
from hypothesis import settings

# How long an example takes says nothing on a machine that does other things too.
settings.register_profile("untimed", deadline=None)
settings.load_profile("untimed")

# No test sees what another run has decided, nor leaves anything behind.
os.environ["CHASLES_CACHE"] = ""


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--update-golden", action="store_true", help="write the golden files anew instead of comparing")


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """What tests recorded as their "report", also where they ran in another process."""
    for result in terminalreporter.getreports("passed"):
        for name, text in result.user_properties if result.when == "call" else ():
            if name == "report":
                terminalreporter.section(result.nodeid)
                terminalreporter.write_line(str(text))
