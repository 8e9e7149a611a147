"""The kernels are those of the public contract, under its names and with its core shapes."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

from chasles import checked, kernels
from chasles.statements import load
from chasles.statements.arrays import SIX

CONTRACT: dict[str, str] = tomllib.loads((Path(__file__).parent / "kernels.toml").read_text(encoding="utf-8"))


def asked() -> list[str]:
    return [kernel.name for entry in load() for kernel in entry.kernels]


def test_every_name_of_the_contract_is_asked_for() -> None:
    assert len(CONTRACT) == 113
    assert {*CONTRACT} <= {*asked()}


def test_every_kernel_asked_for_is_installed_with_its_signature() -> None:
    for name in asked():
        kernel = getattr(kernels, name)
        found = getattr(kernel, "signature", None) or re.search(r"signature +(\S+)", kernel.__doc__)[1]
        assert (name, found) == (name, CONTRACT.get(name, found))


def test_every_kernel_has_a_checked_twin() -> None:
    no_kernels = {"array_api", "backend", "instructions", "one"}
    assert dir(checked) == [name for name in dir(kernels) if name not in no_kernels]


def test_the_inertia_family_comes_in_six_numbers_too() -> None:
    twins = {name for name in CONTRACT if name.endswith(SIX)}
    assert len(twins) == 6
    for name in twins:
        inputs, outputs = CONTRACT[name.removesuffix(SIX)].split("->")
        assert CONTRACT[name] == f"{inputs.replace('(3,3)', '(6)')}->{outputs.replace('(3,3)', '(6)')}"
