"""Ex 3.10: the angular velocity from the rates of Euler angles, for all twelve sequences of axes, in both frames."""

from chasles.derivations.notation import Q, one, unit_columns
from chasles.derivations.x3_10_euler_angles import SEQUENCES, W, W_body, angles, rates, rates_of_the_angles

from chasles.statements import Definition
from chasles.statements.derivation import Consider, Derivation, Expand, Factor, FactorOut, Substitute
from chasles.vocabulary import (
    CPM,
    Node,
    cos,
    det,
    rate,
    sin,
    vect,
    vector,
)

axes = tuple(
    vector(letter, letter, f"unit vector along axis {axis}", constant=True)
    for letter, axis in zip("ijk", "xyz", strict=True)
)
axes_by_components = tuple(
    Definition("Ex 3.10", axis, components, says="A unit vector along a coordinate axis.", part=part)
    for part, (axis, components) in enumerate(zip(axes, unit_columns, strict=True), start=3)
)
_dyads = tuple(one_axis @ another.T @ rates for one_axis in axes for another in axes)


def _about(axis: str, angle: Node) -> Node:
    """The rotation about a coordinate axis."""
    u = axes["xyz".index(axis)]
    return u @ u.T + cos(angle) * (one - u @ u.T) + sin(angle) * CPM(u)


def _road(sequence: str, frame: str) -> Derivation:
    turned = _about(sequence[0], angles.parts[0])
    for axis, angle in zip(sequence[1:], angles.parts[1:], strict=True):
        turned = turned @ _about(axis, angle)
    found = W if frame == "fixed" else W_body
    rotation = Definition("Ex 3.10", Q, turned, says=f"The rotation by Euler angles {sequence}.")
    return Derivation(
        "Ex 3.10",
        to=None,
        says=f"The angular velocity in the {frame} frame from the rates of the angles about {', '.join(sequence)}, "
        "and the determinant that must not vanish.",
        steps=(
            Consider(vect(rate(Q) @ Q.T if frame == "fixed" else Q.T @ rate(Q))),
            Substitute(rotation, using=axes_by_components),
            Factor(*_dyads, using=(rates_of_the_angles, *axes_by_components)),
            FactorOut(rates, named=found),
            Substitute(*axes_by_components),
            Expand(),
            Consider(det(found)),
            Substitute(),
            Factor(),
        ),
    )


euler_angles = {f"euler_{s}_{frame}": _road(s, frame) for s in SEQUENCES for frame in ("fixed", "body")}
