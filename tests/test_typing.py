"""What a type checker says of programs that use the kernels: of right ones nothing, of wrong ones the line."""

from __future__ import annotations

import importlib
import inspect
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from chasles.generated.numpy.hypotheses import KERNELS

from chasles import checked, generated, kernels

from .sampling import WHOLE

pytest.importorskip("mypy", reason="the type checker comes with the `dev` extra")

STUBS = Path(str(generated.__file__)).parent / "stubs"
PACKAGE = Path(str(importlib.import_module("chasles").__file__)).parent
DERIVATIONS = Path(str(importlib.import_module("chasles.derivations").__file__)).parent

RIGHT = """\
from typing import Any, assert_type

import numpy as np
from numpy.typing import NDArray

import chasles
from chasles import checked, kernels

Array = NDArray[np.floating[Any]]
e = np.array([0.0, 0.0, 1.0])
many = np.zeros((5, 3), dtype=np.float32)

Q = kernels.rotation_from_axis_angle(e, 0.5)
assert_type(Q, Array)
assert_type(kernels.rotation_from_axis_angle([0, 0, 1], np.zeros(4), dtype=np.float32), Array)
assert_type(kernels.rotation_from_axis_angle(many, np.float32(1), out=Q, casting="same_kind"), Array)
assert_type(kernels.linear_invariants(Q, axes=[(0, 1), (0,), ()]), tuple[Array, Any])
assert_type(kernels.one.rotation_from_axis_angle(e, 0.5, out=Q), Array)
assert_type(checked.rotation_from_axis_angle(((0, 0, 1), (1, 0, 0)), 1), Array)
assert_type(chasles.kernels.power.signature, str)
u, u_0 = checked.linear_invariants([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
backend: str = kernels.backend
for kernel in (kernels.screw_axis_point, checked.screw_axis_point):
    print(kernel.__name__, kernel(e, 0.5, e, e))
"""
WRONG = """\
import numpy as np

from chasles import checked, kernels

e = np.array([0.0, 0.0, 1.0])
spectrum = np.fft.fft(e)
kernels.rotation_from_axis_angle(e)  # Too few arguments
kernels.rotation_from_axis_angle(e, "0.5")  # incompatible type "str"
kernels.rotation_from_axis_angle(e, 0.5j)  # incompatible type "complex"
kernels.rotation_from_axis_angle(spectrum, 0.5)  # incompatible type "ndarray
kernels.rotation_from_axis_angle(e, 0.5, where=True)  # Unexpected keyword argument "where"
kernels.rotation_from_axis_angle(e, phi=0.5)  # Unexpected keyword argument "phi"
kernels.rotation_from_axis_angle(e, 0.5, order="Z")  # incompatible type
kernels.rotation_from_axis_angel(e, 0.5)  # maybe "rotation_from_axis_angle"
u, u_0, more = kernels.linear_invariants(np.eye(3))  # Need more than 2 values to unpack
kernels.linear_invariants(np.eye(3), out=e)  # incompatible type
length: int = kernels.rotation_from_axis_angle(e, 0.5)  # Incompatible types in assignment
kernels.one.rotation_from_axis_angle([0.0, 0.0, 1.0], 0.5)  # incompatible type "list[float]"
kernels.one.rotation_from_axis_angle(e, 0.5, dtype=float)  # Unexpected keyword argument "dtype"
kernels.one.rotation(e, 0.5)  # has no attribute "rotation"
checked.power(e)  # Too few arguments
checked.rotation(e, 0.5)  # has no attribute "rotation"
kernels.backend = "fortran"  # Incompatible types in assignment
"""


@pytest.fixture(scope="module")
def types(kept: Callable[[str], Path], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder to check programs in, where mypy finds the package put together as in a wheel."""
    folder = tmp_path_factory.mktemp("types")
    parts = folder / "parts" / "chasles"
    parts.mkdir(parents=True)
    for name, place in (("derivations", DERIVATIONS), ("generated", STUBS.parent)):
        if not (PACKAGE / name).exists():
            (parts / name).symlink_to(place)
    (folder / "mypy.ini").write_text(
        f"[mypy]\nstrict = True\ncache_dir = {kept('mypy')}\n"
        f"mypy_path = {PACKAGE.parent}:{parts.parent}\n"
        "[mypy-sympy.*,latex2mathml.*,mpmath.*]\nignore_missing_imports = True\n"
        # Whether the package itself is right is what `make types` says; the kernels need none of these.
        "[mypy-chasles.*]\nignore_errors = True\n"
        "[mypy-IPython.*,matplotlib.*,rich.*,lark.*,jinja2.*,click.*,flint.*]\nfollow_imports = skip\n",
        "utf-8",
    )
    return folder


def mypy(folder: Path, *words: str | Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", *map(str, words)]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


def test_right_programs_pass_and_each_wrong_line_is_named(types: Path) -> None:
    (types / "right.py").write_text(RIGHT, "utf-8")
    (types / "wrong.py").write_text(WRONG, "utf-8")
    said = mypy(types, "mypy", "--config-file", "mypy.ini", "right.py", "wrong.py").stdout
    assert "right.py" not in said, said
    found = {int(line): text for line, text in re.findall(r"^wrong\.py:(\d+): error: (.*)$", said, re.MULTILINE)}
    expected = {n: line.split("  # ")[1] for n, line in enumerate(WRONG.splitlines(), 1) if "  # " in line}
    assert sorted(found) == sorted(expected), said
    assert {n: text for n, text in expected.items() if text not in found[n]} == {}, said


@pytest.mark.slow
@pytest.mark.skipif(not WHOLE, reason="names and numbers of operands are compared below: set CHASLES_TEST_WHOLE=1")
@pytest.mark.skipif(kernels.backend != "c", reason="the stubs are those of ufuncs")
def test_the_stubs_agree_with_what_runs(types: Path) -> None:
    # Its names are those of the module that it passes on, which no checker reads.
    (types / "passed_on").write_text(r"chasles\.kernels\.array_api\..*", "utf-8")
    options = ("--mypy-config-file", "mypy.ini", "--allowlist", "passed_on", "--ignore-unused-allowlist")
    done = mypy(types, "mypy.stubtest", *options, "chasles.kernels", "chasles.checked")
    assert done.returncode == 0, done.stdout + done.stderr


def declared(name: str) -> dict[str, tuple[str, str]]:
    """By kernel, the type and the documentation in a stub."""
    text = (STUBS / f"{name}.pyi").read_text("utf-8")
    return {name: (kind, says) for name, kind, says in re.findall(r'^(\w+): (.+)\n"""((?:.|\n)*?)"""$', text, re.M)}


def test_every_kernel_is_declared_with_its_numbers_of_inputs_and_results_and_its_text() -> None:
    for module, family, found in (
        ("kernels", "Ufunc", kernels),
        ("one", "Light", kernels.one),
        ("checked", "Checked", checked),
    ):
        stub = declared(module)
        assert set(stub) == set(KERNELS)
        more = {name for name in dir(found) if not name.startswith("_")} - set(stub)
        assert kernels.backend != "c" or more <= {"array_api", "backend", "instructions", "one"}
        assert set(stub) <= set(dir(found))
        for name, (kind, says) in stub.items():
            signature = signature_of(getattr(kernels, name))
            given, returned = (re.findall(r"\([\d,]*\)", side) for side in signature.split("->"))
            assert kind == f"{family}{called(name)}"
            results = ["Any" if core == "()" else "Array" for core in returned]
            names, gives = CALLS[called(name)]
            assert len(names) == len(given)
            assert gives == (results[0] if len(results) == 1 else f"tuple[{', '.join(results)}]")
            assert signature in says
            assert inputs_of(getattr(found, name)) == names


def test_an_editor_shows_the_contract_of_a_kernel() -> None:
    for name, (_, says) in declared("kernels").items():
        written = getattr(kernels, name).__doc__ or ""
        lines = [line.strip().replace('"', "'") for line in written.splitlines() if line.strip()]
        start = next(n for n, line in enumerate(lines) if line == says.splitlines()[0].strip())
        assert lines[start:] == [line.strip() for line in says.splitlines() if line.strip()], name


def called(name: str) -> str:
    """The protocol of a kernel's call."""
    return "".join(map(str.capitalize, name.split("_")))


CALLS = {
    name: (re.findall(r"(\w+): Numbers", call), gives)
    for name, call, gives in re.findall(
        r"^class (\w+)\(Protocol\):\n((?:(?!\nclass )(?:.|\n))*?: Numbers(?:.|\n)*?)-> (.*): \.\.\.$",
        (STUBS / "calls.pyi").read_text("utf-8"),
        re.M,
    )
}
"""By protocol, the names of the inputs and what a call gives."""


def inputs_of(kernel: Any) -> list[str]:
    """The names of the inputs, as `help` and an editor at work show them."""
    parameters = inspect.signature(kernel).parameters.values()
    return [each.name for each in parameters if each.kind is inspect.Parameter.POSITIONAL_ONLY]


def signature_of(kernel: Any) -> str:
    """The signature, which a NumPy function has in its text alone."""
    return str(getattr(kernel, "signature", None) or re.search(r"signature +(\S+)", kernel.__doc__)[1])
