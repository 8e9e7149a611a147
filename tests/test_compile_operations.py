"""How many operations models of mechanics take, as `chasles.compile` spells them: fewer are welcome."""

from __future__ import annotations

import pytest
import sympy as sp
from benchmarks.compile.models import MODELS

from chasles.compiling.inputs import inputs_of
from chasles.compiling.program_of import program_of
from chasles.compiling.results import outputs_of

MOST = {
    "cart_pendulum_4": 145,
    "cart_pole_jacobian": 54,
    "arm_2r": 54,
    "ur5_jacobian": 134,
    "quadrotor": 96,
    "inertial_step": 123,
    "rotation_error": 248,
    "vehicle": 87,
}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", MOST)
def test_models_take_no_more_operations(name):
    model = MODELS[name]()
    given = inputs_of({key: sp.Matrix(group) for key, group in model.inputs.items()})
    program = program_of("model", given, outputs_of(sp.Matrix(model.entries), given, None))
    assert sum(program.operations.values()) <= MOST[name]
