"""What is assumed of matrices of any size: that they have an inverse, are orthogonal, idempotent, commute."""

from __future__ import annotations

from dataclasses import replace as with_fields
from typing import TypeVar

from chasles.statements.hypotheses import Hypothesis
from chasles.statements.kernel import Kernel
from chasles.statements.statement import Statement
from chasles.vocabulary import Contract, Determinant, Identity, Misfit, Negative, Node, Symbol, Transpose, latex, plain
from chasles.vocabulary.arguments import declaring
from chasles.vocabulary.sizes import at_sizes

_S = TypeVar("_S", bound=Statement)


@declaring
def invertible(matrix: Node) -> Hypothesis:
    """The matrix has an inverse."""
    said = rf"\det {latex(matrix)} \neq 0"
    return Hypothesis("nonzero", (matrix,), (), (Determinant(matrix),), said, f"{plain(matrix)} is invertible")


@declaring
def orthogonal(matrix: Symbol) -> Hypothesis:
    """The transpose of the matrix is its inverse."""
    one, back = Identity(matrix.shape[0]), Transpose(matrix)
    equations = ((back @ matrix, one), (matrix @ back, one))
    said = rf"{latex(matrix)} \text{{ is orthogonal}}"
    return Hypothesis("orthogonal", (matrix,), equations, (), said, f"{plain(matrix)} is orthogonal")


@declaring
def orthonormal_columns(matrix: Symbol) -> Hypothesis:
    """The columns of the matrix have length one, and are at right angles to each other."""
    equation = (Transpose(matrix) @ matrix, Identity(matrix.shape[1]))
    said = rf"{latex(matrix)}^T {latex(matrix)} = \mathbf{{1}}"
    return Hypothesis(
        "orthonormal columns", (matrix,), (equation,), (), said, f"{plain(matrix)} has orthonormal columns"
    )


@declaring
def skew_symmetric(matrix: Symbol) -> Hypothesis:
    """The matrix is the negative of its transpose."""
    said = rf"{latex(matrix)} = -{latex(matrix)}^T"
    equation = (matrix, Negative(Transpose(matrix)))
    return Hypothesis("skew-symmetric", (matrix,), (equation,), (), said, f"{plain(matrix)} is skew-symmetric")


@declaring
def idempotent(matrix: Symbol) -> Hypothesis:
    """The matrix is its own square, as a projection is."""
    said = rf"{latex(matrix)}^2 = {latex(matrix)}"
    return Hypothesis("idempotent", (matrix,), ((matrix @ matrix, matrix),), (), said, f"{plain(matrix)} is idempotent")


@declaring
def commuting(one: Symbol, other: Symbol) -> Hypothesis:
    """The two matrices commute."""
    if one.shape != other.shape:
        raise Misfit(f"{one} and {other} cannot commute: they are of different size")
    said = rf"{latex(one)} {latex(other)} = {latex(other)} {latex(one)}"
    equation = (Contract((one, other)), Contract((other, one)))
    return Hypothesis("commuting", (one, other), (equation,), (), said, f"{plain(one)} and {plain(other)} commute")


def with_sizes(statement: _S, numbers: dict[str, int], kernel: Kernel | None = None) -> _S:
    """The same said of matrices of these sizes, with all that it rests on: such a statement may have a kernel."""

    def sized(node: Node) -> Node:
        return at_sizes(node, numbers)

    return with_fields(
        statement,
        left=sized(statement.left),
        right=sized(statement.right),
        given=tuple(with_sizes(given, numbers) for given in statement.given),
        assuming=tuple(hypothesis.rewritten(sized) for hypothesis in statement.assuming),
        reading=None,
        corrected=None,
        kernel=kernel and with_fields(kernel, of=tuple(sized(of) if isinstance(of, Node) else of for of in kernel.of)),
    )
