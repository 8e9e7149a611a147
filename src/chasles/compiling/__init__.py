"""COMPILING: SymPy expressions of a user's own as kernels that broadcast, compiled once and kept.

Operands become arrays, expressions a straight-line program; the targets spell it; a C compiler makes of it a shared
object with a ufunc's inner loop, for which neither Python's nor NumPy's headers are needed. Where there is no compiler
the NumPy text runs.
"""

from __future__ import annotations

from typing import Any

from chasles.compiling.collection import collection_held_off
from chasles.compiling.depth import at_any_depth
from chasles.compiling.derived import derived_from
from chasles.compiling.inputs import inputs_of, require_kernel_name
from chasles.compiling.kernel import CompiledKernel, kernel_for
from chasles.compiling.recall import key_of
from chasles.compiling.results import outputs_of
from chasles.lowering.program import Program
from chasles.lowering.refusal import LoweringError

__all__ = ["CompiledKernel", "LoweringError", "compile"]


@at_any_depth
@collection_held_off()
def compile(
    expr: Any,
    inputs: Any = None,
    outputs: Any = None,
    name: str = "expression",
    *,
    jacobian: bool = False,
    hessian: bool = False,
    jvp: bool = False,
    vjp: bool = False,
    wrt: Any = None,
    coo: bool = False,
    levels: str = "own",
) -> CompiledKernel:
    """The kernel that computes SymPy expressions, with NaN wherever something is divided by zero.

    What is compiled is the cheapest spelling that is proved equal and loses no digits that another one keeps: a sum is
    nested, 1 - cos(x) is 2 sin(x/2)^2, 1 - exp(x) is -expm1(x). A quotient of functions of one angle that has a limit
    where the angle is zero has that for its value, and near it all digits.

    Symbols are real; those of an expression are the inputs of their names, whatever is assumed of either. Functions of
    anything and their derivatives go in like symbols, each for itself: what is no input is refused, never derived from
    one that is. The kernel takes its inputs in their order or by name.

    A comparison with NaN does not hold, as in C; a Piecewise without a piece that applies is NaN.

    Args:
        expr: a scalar or a matrix, or a list or tuple of them: one result each. A matrix with one row or one column is
            a vector, one of a single entry a scalar. Or a `KanesMethod`, `LagrangesMethod`, `System` or `JointsMethod`
            of `sympy.physics.mechanics` whose equations M a = f are formed.
        inputs: the arguments in their order: symbols, indexed ones too, functions such as q(t), derivatives of these,
            matrix symbols, `IndexedBase` with a shape, and matrices or lists of symbols; or a mapping of names to them.
            Where no name is given it is made of the symbols': q_dot of q(t).diff(t), omega of a Greek letter.
            For a method it may be left out: the coordinates are `q`, the speeds `u` (rates of coordinates, for
            Lagrange), other functions of time `specified`, constants `parameters`, by name; what each holds is in the
            kernel's `inputs`.
        outputs: the results' names; else `result`, or `result_1`, `result_2`... For a method, some of `mass_matrix`,
            `forcing`, `accelerations`, which are all three if nothing is said, `state_rates` and `multipliers`. M is
            supposed positive definite and factorised as L D L^T without pivots; with constraints rows are exchanged.
        name: what the kernel is called.
        jacobian: adds a result for each result: the derivatives of its entries, row by row, by all numbers that go in,
            in their order, as columns. A scalar has one row, which is a vector; by one number there is no axis of
            columns. Of Abs, Min, Max, sign and Piecewise it is the derivative of the piece taken.
        hessian: adds the symmetric matrix of second derivatives of each result, which must be a scalar.
        jvp: adds an input `tangent` after the others, one number for each column, and for each result its Jacobian
            times the tangent, in the shape of the result.
        vjp: adds an input `..._cotangent` for each result, of its shape, and one result, with one number for each
            column: the sum of cotangents times Jacobians.
        wrt: what to differentiate by instead of all inputs: the name of one, what is in one, or a list of such.
        coo: of Jacobians and Hessians only the entries that are not zero by construction, as a vector, in the order of
            the kernel's `pattern`.
        levels: "own" compiles for the instructions of this machine, "all" for lesser ones, too, so that
            `chasles_limit` of the shared object can be asked for them.

    Raises:
        LoweringError: a ValueError that names what cannot be compiled.
    """
    if levels not in ("own", "all"):
        raise LoweringError(f"levels must be 'own' or 'all', not {levels!r}")
    asked = {"jacobian": jacobian, "hessian": hessian, "jvp": jvp, "vjp": vjp}
    kinds = tuple(kind for kind, is_asked in asked.items() if is_asked)
    if any(str(each.__module__).startswith("sympy.physics.mechanics.") for each in type(expr).__mro__):
        # What is not needed is not imported.
        from chasles.compiling.mechanics import program_of_method

        options = {"kinds": kinds, "wrt": wrt, "coo": coo}
        return kernel_for(*program_of_method(require_kernel_name(name), expr, inputs, outputs, **options), levels)
    given = inputs_of(inputs)
    results = outputs_of(expr, given, outputs)
    given_as = [item.identity for item in given]
    shapes = [(result.name, result.shape) for result in results]
    derived = derived_from(given, results, kinds, wrt, coo=coo)
    key = key_of(
        (entry for result in results for entry in result.entries), require_kernel_name(name), given_as, shapes, derived
    )

    def made() -> Program:
        # What is recalled is not made: SymPy is not read.
        from chasles.compiling.program_of import program_of

        return program_of(name, given, results, derived)

    return kernel_for(key, made, levels)
