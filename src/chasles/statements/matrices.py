"""What is assumed of matrices of any size: that they have an inverse, are orthogonal, idempotent, commute."""

from __future__ import annotations

from dataclasses import replace as with_fields
from typing import TypeVar

from chasles.statements.hypotheses import Hypothesis, said_of
from chasles.statements.kernel import Kernel
from chasles.statements.statement import Statement
from chasles.vocabulary import Contract, Determinant, Identity, Misfit, Negative, Node, Symbol, Transpose, latex, plain
from chasles.vocabulary.arguments import declaring
from chasles.vocabulary.sizes import at_sizes

_S = TypeVar("_S", bound=Statement)


@declaring
def invertible(matrix: Node) -> Hypothesis:
    """The matrix has an inverse."""
    determinant = Determinant(matrix)
    printed = rf"{latex(determinant)} \neq 0"
    return Hypothesis("nonzero", (matrix,), (), (determinant,), printed, f"{plain(matrix)} is invertible")


@declaring
def orthogonal(matrix: Symbol) -> Hypothesis:
    """The transpose of the matrix is its inverse."""
    one, back = Identity(matrix.shape[0]), Transpose(matrix)
    equations = ((back @ matrix, one), (matrix @ back, one))
    return said_of("orthogonal", (matrix,), r"{0} \text{{ is orthogonal}}", "{0} is orthogonal", *equations)


@declaring
def orthonormal_columns(matrix: Symbol) -> Hypothesis:
    """The columns of the matrix have length one, and are at right angles to each other."""
    equation = (Transpose(matrix) @ matrix, Identity(matrix.shape[1]))
    return said_of("orthonormal columns", (matrix,), equation, "{0} has orthonormal columns", equation)


@declaring
def skew_symmetric(matrix: Symbol) -> Hypothesis:
    """The matrix is the negative of its transpose."""
    equation = (matrix, Negative(Transpose(matrix)))
    return said_of("skew-symmetric", (matrix,), equation, "{0} is skew-symmetric", equation)


@declaring
def idempotent(matrix: Symbol) -> Hypothesis:
    """The matrix is its own square, as a projection is."""
    equation = (matrix @ matrix, matrix)
    return said_of("idempotent", (matrix,), equation, "{0} is idempotent", equation)


@declaring
def commuting(one: Symbol, other: Symbol) -> Hypothesis:
    """The two matrices commute."""
    if one.shape != other.shape:
        raise Misfit(f"{one} and {other} cannot commute: they are of different size")
    equation = (Contract((one, other)), Contract((other, one)))
    return said_of("commuting", (one, other), equation, "{0} and {1} commute", equation)


@declaring
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
