"""COMPILING: SymPy expressions of a user's own as kernels that broadcast, compiled once and kept.

Operands become arrays, expressions a straight-line program; the targets spell it; a C compiler makes of it a shared
object with a ufunc's inner loop, for which neither Python's nor NumPy's headers are needed. Where there is no compiler
the NumPy text runs.
"""

from __future__ import annotations

from typing import Any

from chasles.compiling.kernel import CompiledKernel, kernel_of
from chasles.compiling.operands import inputs_of, outputs_of, require_kernel_name
from chasles.compiling.program_of import program_of
from chasles.lowering.refusal import LoweringError

__all__ = ["CompiledKernel", "LoweringError", "compile"]


def compile(
    expr: Any, inputs: Any, outputs: Any = None, name: str = "expression", *, jacobian: bool = False
) -> CompiledKernel:
    """The kernel that computes SymPy expressions, with NaN wherever something is divided by zero.

    What is compiled is the cheapest spelling that is proved equal and loses no digits that another one keeps: a sum is
    nested, 1 - cos(x) is 2 sin(x/2)^2. A quotient of functions of one angle that has a limit has that for its value.

    Symbols are real. A comparison with NaN does not hold, as in C; a Piecewise without a piece that applies is NaN.

    Args:
        expr: a scalar or a matrix, or a list or tuple of them: one result each. A matrix with one row or one column is
            a vector, one of a single entry a scalar.
        inputs: the arguments in their order: symbols, indexed ones too, matrix symbols, and matrices or lists of
            symbols; or a mapping of names to them.
        outputs: the results' names; else `result`, or `result_1`, `result_2`...
        name: what the kernel is called.
        jacobian: adds a result for each result: the derivatives of its entries, row by row, by all numbers that go in,
            in their order, as columns. A scalar has one row, which is a vector; where one scalar goes in there is no
            axis of columns. Of Abs, Min, Max, sign and Piecewise it is the derivative of the piece taken.

    Raises:
        LoweringError: a ValueError that names what cannot be compiled.
    """
    given = inputs_of(inputs)
    results = outputs_of(expr, given, outputs)
    return kernel_of(program_of(require_kernel_name(name), given, results, jacobian=jacobian))
