"""What SymPy's own tests of mechanics form compiles as it comes, and gives SymPy's matrices."""

from __future__ import annotations

import sys
from pathlib import Path

import mpmath
import pytest
import sympy as sp
from sympy.physics import biomechanics

import chasles

ROOT = Path(__file__).resolve().parents[1]
if not (ROOT / "benchmarks").exists():
    pytest.skip("needs the checkout", allow_module_level=True)
pytest.importorskip("sympy.physics.mechanics.tests", reason="SymPy is here without its tests")
sys.path.insert(0, str(ROOT))

from benchmarks.compile.formula import Formula  # noqa: E402
from benchmarks.compile.models import MODELS, chain_in_the_plane  # noqa: E402
from benchmarks.compile.page import page  # noqa: E402
from benchmarks.compile.sympy_models import cases_of, compared, formed  # noqa: E402

FORMED = [
    ("test_jointsmethod", "test_complete_simple_double_pendulum"),
    ("test_jointsmethod", "test_four_bar_linkage_with_manual_constraints"),
    ("test_jointsmethod", "test_chaos_pendulum"),
    ("test_kane", "test_two_dof"),
    ("test_kane", "test_rolling_disc"),
    ("test_kane", "test_aux"),
    ("test_kane2", "test_non_central_inertia"),
    ("test_kane2", "test_sub_qdot"),
    ("test_kane4", "test_replace_qdots_in_force"),
    ("test_kane5", "test_kane_rolling_disc_lu"),
    ("test_lagrange", "test_disc_on_an_incline_plane"),
    ("test_lagrange", "test_nonminimal_pendulum"),
    ("test_lagrange", "test_rolling_disc"),
    ("test_models", "test_multi_mass_spring_damper_higher_order"),
    ("test_models", "test_n_link_pendulum_on_cart_inputs"),
    ("test_system_class", "TestSystemExamples.test_cart_pendulum_kanes"),
]


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("module", "name"), FORMED)
def test_a_model_compiles_as_it_comes(module, name, monkeypatch):
    monkeypatch.setenv("CC", "no-such-compiler")
    method, *_ = formed(dict(cases_of(module))[name], 1)
    outputs = ["mass_matrix", "forcing", "accelerations"]
    if len(method.forcing_full) > len(method.q) + len(method.u):
        outputs.append("multipliers")
    assert compared(method, chasles.compile(method, outputs=outputs)) < 1e-14


def test_a_wrong_kernel_is_seen(monkeypatch):
    monkeypatch.setenv("CC", "no-such-compiler")
    method, *_ = formed(dict(cases_of("test_kane"))["test_one_dof"], 1)
    kernel = chasles.compile(method)

    class Wrong:
        program = kernel.program

        def __call__(self, *point):
            mass, forcing, accelerations = kernel(*point)
            return mass, forcing * (1 + 1e-12), accelerations

    assert compared(method, kernel) < 1e-15
    assert compared(method, Wrong()) > 1e-14


@pytest.mark.parametrize(
    "name",
    ["cart_pendulum_2", "cart_pole_jacobian", "arm_2r", "ur5_jacobian", "quadrotor", "inertial_step", "rotation_error"],
)
def test_a_model_of_the_benchmark_is_said_again_as_it_is(name):
    """At a point: what the peers get is what SymPy has."""
    model = MODELS[name]()
    symbols = [symbol for group in model.inputs.values() for symbol in group]
    assert set().union(*(entry.free_symbols for entry in model.entries)) <= set(symbols)
    values = [0.3 + 7 * k % 11 / 10 for k in range(len(symbols))]
    given, groups = iter(values), model.inputs.values()
    said = Formula(model).of(mpmath, *([mpmath.mpf(next(given)) for _ in group] for group in groups))
    right = sp.lambdify(symbols, model.entries, "math", cse=True)(*values)
    assert [float(each) for each in said] == pytest.approx(right, rel=1e-12, abs=1e-12)


def test_the_page_of_the_benchmark_tells_what_is_missed():
    tools = {
        "chasles": {"cold": 3.0, "warm": 0.2, "batch": 20.0, "call": 0.4, "error": 2.0, "operations": 7},
        "wrenfold_cpp": {"cold": 1.0, "batch": 10.0, "call": 0.8, "error": 2.0, "operations": 7},
        "casadi_c": {"cold": "RuntimeError: no"},
    }
    machine = dict.fromkeys(("date", "processor", "cores", "load", "compiler", "python", "instructions"), "")
    text = page({"machine": machine | {"versions": {}}, "models": {"arm": {"tools": tools}}, "curve": []})
    assert "**3.00** wrenfold" in text
    assert "**2.00** wrenfold" in text
    assert " 0.50 wrenfold" in text
    assert " RuntimeError |" in text
    assert len(chain_in_the_plane(3).entries) == 6


CURVES = [name for name in biomechanics.__all__ if name.startswith(("Fiber", "Tendon"))]


@pytest.mark.parametrize("name", CURVES)
def test_curves_of_muscles_compile_as_they_come(name, monkeypatch):
    """Functions that say themselves what they are, and their derivatives."""
    monkeypatch.setenv("CC", "no-such-compiler")
    x = sp.Symbol("x")
    expression = getattr(biomechanics, name).with_defaults(x)
    for each in (expression, expression.diff(x)):
        right = float(each.doit().subs(x, sp.Rational(9, 8)).evalf(30))
        assert chasles.compile(each, [x])(1.125) == pytest.approx(right, rel=1e-12)
