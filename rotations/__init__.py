"""Rotations and rigid motions: one module a section, each equation decided; what every text on robotics uses."""

from chasles.vocabulary import CPM, Transpose
from chasles.vocabulary.motions import (
    AdjointOfMotion,
    AdjointOfTwist,
    InverseMotion,
    TwistMatrix,
)
from chasles.vocabulary.notation import Notation
from chasles.vocabulary.products import DirectSum
from chasles.vocabulary.quaternions import (
    ProductFromLeft,
    ProductFromRight,
    QuaternionConjugate,
    QuaternionProduct,
    QuaternionRotation,
)
from chasles.vocabulary.rotation_vectors import (
    Cayley,
    LeftJacobian,
    RightJacobian,
    RotationByVector,
)

if __name__ != "chasles.rotations":
    raise ImportError(
        f"the chapter was imported as {__name__!r}; import it as 'chasles.rotations', so that no statement exists twice"
    )

TITLE = "Rotations and Rigid Motions"
SOURCE = "the mathematics as it is generally known, in words of our own"
SECTIONS = (
    "s1_rotations",
    "s2_quaternions",
    "s3_rotation_vectors",
    "s4_cayley",
    "s5_euler_angles",
    "s6_motions",
    "s7_denavit_hartenberg",
    "s8_twists",
    "s9_motion_vectors",
    "s10_arms",
)
NOTATION = Notation(
    {
        CPM: r"\hat{#1}",
        Transpose: r"#1^\mathsf{T}",
        QuaternionProduct: r"#1 \circ #2",
        QuaternionConjugate: r"#1^*",
        ProductFromLeft: r"\mathbf{L}(#1)",
        ProductFromRight: r"\mathbf{R}(#1)",
        QuaternionRotation: r"\mathbf{Q}(#1)",
        RotationByVector: r"\operatorname{Exp}(#1)",
        LeftJacobian: r"\mathbf{J}_l(#1)",
        RightJacobian: r"\mathbf{J}_r(#1)",
        Cayley: r"\operatorname{cay}(#1)",
        DirectSum: r"#1 \oplus #2",
        InverseMotion: r"#1^{-1}",
        AdjointOfMotion: r"\operatorname{Ad}(#1)",
        AdjointOfTwist: r"\operatorname{ad}(#1)",
        TwistMatrix: r"\hat{#1}",
    }
)
