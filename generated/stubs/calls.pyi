"""How each kernel is called, by the names of its inputs. Made by `chasles emit`; not to be edited."""

from typing import Any, Protocol, Unpack

from .protocols import Array, Checked, Light, Numbers, Options, Ufunc

class CrossProductMatrix(Protocol):
    def __call__(
        self,
        v: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncCrossProductMatrix(Ufunc, CrossProductMatrix, Protocol): ...
class CheckedCrossProductMatrix(Checked, CrossProductMatrix, Protocol): ...

class LightCrossProductMatrix(Protocol):
    def __call__(
        self,
        v: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class RotationFromAxisAngle(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncRotationFromAxisAngle(Ufunc, RotationFromAxisAngle, Protocol): ...
class CheckedRotationFromAxisAngle(Checked, RotationFromAxisAngle, Protocol): ...

class LightRotationFromAxisAngle(Protocol):
    def __call__(
        self,
        e: Light, phi: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class PointAfterDisplacement(Protocol):
    def __call__(
        self,
        Q: Numbers, a: Numbers, a_prime: Numbers, p: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncPointAfterDisplacement(Ufunc, PointAfterDisplacement, Protocol): ...
class CheckedPointAfterDisplacement(Checked, PointAfterDisplacement, Protocol): ...

class LightPointAfterDisplacement(Protocol):
    def __call__(
        self,
        Q: Light, a: Light, a_prime: Light, p: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class PitchOfMotion(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, d_P: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Any: ...

class UfuncPitchOfMotion(Ufunc, PitchOfMotion, Protocol): ...
class CheckedPitchOfMotion(Checked, PitchOfMotion, Protocol): ...

class LightPitchOfMotion(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, d_P: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Any: ...

class NormalMatrixInverse(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncNormalMatrixInverse(Ufunc, NormalMatrixInverse, Protocol): ...
class CheckedNormalMatrixInverse(Checked, NormalMatrixInverse, Protocol): ...

class LightNormalMatrixInverse(Protocol):
    def __call__(
        self,
        e: Light, phi: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class ScrewAxisPoint(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, a: Numbers, a_prime: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncScrewAxisPoint(Ufunc, ScrewAxisPoint, Protocol): ...
class CheckedScrewAxisPoint(Checked, ScrewAxisPoint, Protocol): ...

class LightScrewAxisPoint(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, a: Light, a_prime: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class PluckerLine(Protocol):
    def __call__(
        self,
        p_1: Numbers, p_2: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncPluckerLine(Ufunc, PluckerLine, Protocol): ...
class CheckedPluckerLine(Checked, PluckerLine, Protocol): ...

class LightPluckerLine(Protocol):
    def __call__(
        self,
        p_1: Light, p_2: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class PluckerTransfer(Protocol):
    def __call__(
        self,
        kappa_A: Numbers, a: Numbers, b: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncPluckerTransfer(Ufunc, PluckerTransfer, Protocol): ...
class CheckedPluckerTransfer(Checked, PluckerTransfer, Protocol): ...

class LightPluckerTransfer(Protocol):
    def __call__(
        self,
        kappa_A: Light, a: Light, b: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class RotationInTriadAxes(Protocol):
    def __call__(
        self,
        triad: Numbers, triad_prime: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncRotationInTriadAxes(Ufunc, RotationInTriadAxes, Protocol): ...
class CheckedRotationInTriadAxes(Checked, RotationInTriadAxes, Protocol): ...

class LightRotationInTriadAxes(Protocol):
    def __call__(
        self,
        triad: Light, triad_prime: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class RotationFromTriads(Protocol):
    def __call__(
        self,
        triad: Numbers, triad_prime: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncRotationFromTriads(Ufunc, RotationFromTriads, Protocol): ...
class CheckedRotationFromTriads(Checked, RotationFromTriads, Protocol): ...

class LightRotationFromTriads(Protocol):
    def __call__(
        self,
        triad: Light, triad_prime: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class AxialVector(Protocol):
    def __call__(
        self,
        Omega: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncAxialVector(Ufunc, AxialVector, Protocol): ...
class CheckedAxialVector(Checked, AxialVector, Protocol): ...

class LightAxialVector(Protocol):
    def __call__(
        self,
        Omega: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class VelocityOfPoint(Protocol):
    def __call__(
        self,
        omega: Numbers, a_dot: Numbers, a: Numbers, p: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncVelocityOfPoint(Ufunc, VelocityOfPoint, Protocol): ...
class CheckedVelocityOfPoint(Checked, VelocityOfPoint, Protocol): ...

class LightVelocityOfPoint(Protocol):
    def __call__(
        self,
        omega: Light, a_dot: Light, a: Light, p: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class InstantScrewPoint(Protocol):
    def __call__(
        self,
        omega: Numbers, a_dot: Numbers, a: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncInstantScrewPoint(Ufunc, InstantScrewPoint, Protocol): ...
class CheckedInstantScrewPoint(Checked, InstantScrewPoint, Protocol): ...

class LightInstantScrewPoint(Protocol):
    def __call__(
        self,
        omega: Light, a_dot: Light, a: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class NaturalRateMatrix(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncNaturalRateMatrix(Ufunc, NaturalRateMatrix, Protocol): ...
class CheckedNaturalRateMatrix(Checked, NaturalRateMatrix, Protocol): ...

class LightNaturalRateMatrix(Protocol):
    def __call__(
        self,
        e: Light, phi: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class LinearRateMatrix(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncLinearRateMatrix(Ufunc, LinearRateMatrix, Protocol): ...
class CheckedLinearRateMatrix(Checked, LinearRateMatrix, Protocol): ...

class LightLinearRateMatrix(Protocol):
    def __call__(
        self,
        e: Light, phi: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRodriguesRateMatrix(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRodriguesRateMatrix(Ufunc, EulerRodriguesRateMatrix, Protocol): ...
class CheckedEulerRodriguesRateMatrix(Checked, EulerRodriguesRateMatrix, Protocol): ...

class LightEulerRodriguesRateMatrix(Protocol):
    def __call__(
        self,
        e: Light, phi: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class RotationFromLinearInvariants(Protocol):
    def __call__(
        self,
        q: Numbers, q_0: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncRotationFromLinearInvariants(Ufunc, RotationFromLinearInvariants, Protocol): ...
class CheckedRotationFromLinearInvariants(Checked, RotationFromLinearInvariants, Protocol): ...

class LightRotationFromLinearInvariants(Protocol):
    def __call__(
        self,
        q: Light, q_0: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class RotationFromEulerRodrigues(Protocol):
    def __call__(
        self,
        q: Numbers, q_0: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncRotationFromEulerRodrigues(Ufunc, RotationFromEulerRodrigues, Protocol): ...
class CheckedRotationFromEulerRodrigues(Checked, RotationFromEulerRodrigues, Protocol): ...

class LightRotationFromEulerRodrigues(Protocol):
    def __call__(
        self,
        q: Light, q_0: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class LinearInvariants(Protocol):
    def __call__(
        self,
        Q: Numbers,
        /,
        *,
        out: tuple[Array | None, Array | None] | None = None,
        **options: Unpack[Options],
    ) -> tuple[Array, Any]: ...

class UfuncLinearInvariants(Ufunc, LinearInvariants, Protocol): ...
class CheckedLinearInvariants(Checked, LinearInvariants, Protocol): ...

class LightLinearInvariants(Protocol):
    def __call__(
        self,
        Q: Light,
        /,
        *,
        out: tuple[Array | None, Array | None] | None = None,
    ) -> tuple[Array, Any]: ...

class NaturalInvariants(Protocol):
    def __call__(
        self,
        Q: Numbers,
        /,
        *,
        out: tuple[Array | None, Array | None] | None = None,
        **options: Unpack[Options],
    ) -> tuple[Array, Any]: ...

class UfuncNaturalInvariants(Ufunc, NaturalInvariants, Protocol): ...
class CheckedNaturalInvariants(Checked, NaturalInvariants, Protocol): ...

class LightNaturalInvariants(Protocol):
    def __call__(
        self,
        Q: Light,
        /,
        *,
        out: tuple[Array | None, Array | None] | None = None,
    ) -> tuple[Array, Any]: ...

class EulerRodriguesParameters(Protocol):
    def __call__(
        self,
        Q: Numbers,
        /,
        *,
        out: tuple[Array | None, Array | None] | None = None,
        **options: Unpack[Options],
    ) -> tuple[Array, Any]: ...

class UfuncEulerRodriguesParameters(Ufunc, EulerRodriguesParameters, Protocol): ...
class CheckedEulerRodriguesParameters(Checked, EulerRodriguesParameters, Protocol): ...

class LightEulerRodriguesParameters(Protocol):
    def __call__(
        self,
        Q: Light,
        /,
        *,
        out: tuple[Array | None, Array | None] | None = None,
    ) -> tuple[Array, Any]: ...

class ScrewOfMotion(Protocol):
    def __call__(
        self,
        Q: Numbers, a: Numbers, a_prime: Numbers,
        /,
        *,
        out: tuple[Array | None, Array | None, Array | None] | None = None,
        **options: Unpack[Options],
    ) -> tuple[Array, Any, Any]: ...

class UfuncScrewOfMotion(Ufunc, ScrewOfMotion, Protocol): ...
class CheckedScrewOfMotion(Checked, ScrewOfMotion, Protocol): ...

class LightScrewOfMotion(Protocol):
    def __call__(
        self,
        Q: Light, a: Light, a_prime: Light,
        /,
        *,
        out: tuple[Array | None, Array | None, Array | None] | None = None,
    ) -> tuple[Array, Any, Any]: ...

class InstantScrew(Protocol):
    def __call__(
        self,
        omega: Numbers, a_dot: Numbers, a: Numbers,
        /,
        *,
        out: tuple[Array | None, Array | None] | None = None,
        **options: Unpack[Options],
    ) -> tuple[Array, Any]: ...

class UfuncInstantScrew(Ufunc, InstantScrew, Protocol): ...
class CheckedInstantScrew(Checked, InstantScrew, Protocol): ...

class LightInstantScrew(Protocol):
    def __call__(
        self,
        omega: Light, a_dot: Light, a: Light,
        /,
        *,
        out: tuple[Array | None, Array | None] | None = None,
    ) -> tuple[Array, Any]: ...

class NaturalVelocityMatrix(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncNaturalVelocityMatrix(Ufunc, NaturalVelocityMatrix, Protocol): ...
class CheckedNaturalVelocityMatrix(Checked, NaturalVelocityMatrix, Protocol): ...

class LightNaturalVelocityMatrix(Protocol):
    def __call__(
        self,
        e: Light, phi: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class LinearVelocityMatrix(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncLinearVelocityMatrix(Ufunc, LinearVelocityMatrix, Protocol): ...
class CheckedLinearVelocityMatrix(Checked, LinearVelocityMatrix, Protocol): ...

class LightLinearVelocityMatrix(Protocol):
    def __call__(
        self,
        e: Light, phi: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRodriguesVelocityMatrix(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRodriguesVelocityMatrix(Ufunc, EulerRodriguesVelocityMatrix, Protocol): ...
class CheckedEulerRodriguesVelocityMatrix(Checked, EulerRodriguesVelocityMatrix, Protocol): ...

class LightEulerRodriguesVelocityMatrix(Protocol):
    def __call__(
        self,
        e: Light, phi: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class PoseRateNatural(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, t: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncPoseRateNatural(Ufunc, PoseRateNatural, Protocol): ...
class CheckedPoseRateNatural(Checked, PoseRateNatural, Protocol): ...

class LightPoseRateNatural(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, t: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class PoseRateLinear(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, t: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncPoseRateLinear(Ufunc, PoseRateLinear, Protocol): ...
class CheckedPoseRateLinear(Checked, PoseRateLinear, Protocol): ...

class LightPoseRateLinear(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, t: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class PoseRateEulerRodrigues(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, t: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncPoseRateEulerRodrigues(Ufunc, PoseRateEulerRodrigues, Protocol): ...
class CheckedPoseRateEulerRodrigues(Checked, PoseRateEulerRodrigues, Protocol): ...

class LightPoseRateEulerRodrigues(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, t: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class TwistFromPoseRateNatural(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, s_dot: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncTwistFromPoseRateNatural(Ufunc, TwistFromPoseRateNatural, Protocol): ...
class CheckedTwistFromPoseRateNatural(Checked, TwistFromPoseRateNatural, Protocol): ...

class LightTwistFromPoseRateNatural(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, s_dot: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class TwistFromPoseRateLinear(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, s_dot: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncTwistFromPoseRateLinear(Ufunc, TwistFromPoseRateLinear, Protocol): ...
class CheckedTwistFromPoseRateLinear(Checked, TwistFromPoseRateLinear, Protocol): ...

class LightTwistFromPoseRateLinear(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, s_dot: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class TwistFromPoseRateEulerRodrigues(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, s_dot: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncTwistFromPoseRateEulerRodrigues(Ufunc, TwistFromPoseRateEulerRodrigues, Protocol): ...
class CheckedTwistFromPoseRateEulerRodrigues(Checked, TwistFromPoseRateEulerRodrigues, Protocol): ...

class LightTwistFromPoseRateEulerRodrigues(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, s_dot: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class TwistTransfer(Protocol):
    def __call__(
        self,
        t_A: Numbers, a: Numbers, p: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncTwistTransfer(Ufunc, TwistTransfer, Protocol): ...
class CheckedTwistTransfer(Checked, TwistTransfer, Protocol): ...

class LightTwistTransfer(Protocol):
    def __call__(
        self,
        t_A: Light, a: Light, p: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class AngularAccelerationMatrix(Protocol):
    def __call__(
        self,
        omega: Numbers, omega_dot: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncAngularAccelerationMatrix(Ufunc, AngularAccelerationMatrix, Protocol): ...
class CheckedAngularAccelerationMatrix(Checked, AngularAccelerationMatrix, Protocol): ...

class LightAngularAccelerationMatrix(Protocol):
    def __call__(
        self,
        omega: Light, omega_dot: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class AccelerationOfPoint(Protocol):
    def __call__(
        self,
        omega: Numbers, omega_dot: Numbers, a_ddot: Numbers, a: Numbers, p: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncAccelerationOfPoint(Ufunc, AccelerationOfPoint, Protocol): ...
class CheckedAccelerationOfPoint(Checked, AccelerationOfPoint, Protocol): ...

class LightAccelerationOfPoint(Protocol):
    def __call__(
        self,
        omega: Light, omega_dot: Light, a_ddot: Light, a: Light, p: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class NaturalRateMatrixDot(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, omega: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncNaturalRateMatrixDot(Ufunc, NaturalRateMatrixDot, Protocol): ...
class CheckedNaturalRateMatrixDot(Checked, NaturalRateMatrixDot, Protocol): ...

class LightNaturalRateMatrixDot(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, omega: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class LinearRateMatrixDot(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, omega: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncLinearRateMatrixDot(Ufunc, LinearRateMatrixDot, Protocol): ...
class CheckedLinearRateMatrixDot(Checked, LinearRateMatrixDot, Protocol): ...

class LightLinearRateMatrixDot(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, omega: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRodriguesRateMatrixDot(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, omega: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRodriguesRateMatrixDot(Ufunc, EulerRodriguesRateMatrixDot, Protocol): ...
class CheckedEulerRodriguesRateMatrixDot(Checked, EulerRodriguesRateMatrixDot, Protocol): ...

class LightEulerRodriguesRateMatrixDot(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, omega: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class NaturalVelocityMatrixDot(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, omega: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncNaturalVelocityMatrixDot(Ufunc, NaturalVelocityMatrixDot, Protocol): ...
class CheckedNaturalVelocityMatrixDot(Checked, NaturalVelocityMatrixDot, Protocol): ...

class LightNaturalVelocityMatrixDot(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, omega: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class LinearVelocityMatrixDot(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, omega: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncLinearVelocityMatrixDot(Ufunc, LinearVelocityMatrixDot, Protocol): ...
class CheckedLinearVelocityMatrixDot(Checked, LinearVelocityMatrixDot, Protocol): ...

class LightLinearVelocityMatrixDot(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, omega: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRodriguesVelocityMatrixDot(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, omega: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRodriguesVelocityMatrixDot(Ufunc, EulerRodriguesVelocityMatrixDot, Protocol): ...
class CheckedEulerRodriguesVelocityMatrixDot(Checked, EulerRodriguesVelocityMatrixDot, Protocol): ...

class LightEulerRodriguesVelocityMatrixDot(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, omega: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class PoseAccelerationNatural(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, t: Numbers, t_dot: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncPoseAccelerationNatural(Ufunc, PoseAccelerationNatural, Protocol): ...
class CheckedPoseAccelerationNatural(Checked, PoseAccelerationNatural, Protocol): ...

class LightPoseAccelerationNatural(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, t: Light, t_dot: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class PoseAccelerationLinear(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, t: Numbers, t_dot: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncPoseAccelerationLinear(Ufunc, PoseAccelerationLinear, Protocol): ...
class CheckedPoseAccelerationLinear(Checked, PoseAccelerationLinear, Protocol): ...

class LightPoseAccelerationLinear(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, t: Light, t_dot: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class PoseAccelerationEulerRodrigues(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, t: Numbers, t_dot: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncPoseAccelerationEulerRodrigues(Ufunc, PoseAccelerationEulerRodrigues, Protocol): ...
class CheckedPoseAccelerationEulerRodrigues(Checked, PoseAccelerationEulerRodrigues, Protocol): ...

class LightPoseAccelerationEulerRodrigues(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, t: Light, t_dot: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class TwistRateFromPoseNatural(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, s_dot: Numbers, s_ddot: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncTwistRateFromPoseNatural(Ufunc, TwistRateFromPoseNatural, Protocol): ...
class CheckedTwistRateFromPoseNatural(Checked, TwistRateFromPoseNatural, Protocol): ...

class LightTwistRateFromPoseNatural(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, s_dot: Light, s_ddot: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class TwistRateFromPoseLinear(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, s_dot: Numbers, s_ddot: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncTwistRateFromPoseLinear(Ufunc, TwistRateFromPoseLinear, Protocol): ...
class CheckedTwistRateFromPoseLinear(Checked, TwistRateFromPoseLinear, Protocol): ...

class LightTwistRateFromPoseLinear(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, s_dot: Light, s_ddot: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class TwistRateFromPoseEulerRodrigues(Protocol):
    def __call__(
        self,
        e: Numbers, phi: Numbers, s_dot: Numbers, s_ddot: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncTwistRateFromPoseEulerRodrigues(Ufunc, TwistRateFromPoseEulerRodrigues, Protocol): ...
class CheckedTwistRateFromPoseEulerRodrigues(Checked, TwistRateFromPoseEulerRodrigues, Protocol): ...

class LightTwistRateFromPoseEulerRodrigues(Protocol):
    def __call__(
        self,
        e: Light, phi: Light, s_dot: Light, s_ddot: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class MovingFrameVelocity(Protocol):
    def __call__(
        self,
        o_dot: Numbers, Q: Numbers, omega: Numbers, rho: Numbers, rho_dot: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncMovingFrameVelocity(Ufunc, MovingFrameVelocity, Protocol): ...
class CheckedMovingFrameVelocity(Checked, MovingFrameVelocity, Protocol): ...

class LightMovingFrameVelocity(Protocol):
    def __call__(
        self,
        o_dot: Light, Q: Light, omega: Light, rho: Light, rho_dot: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class MovingFrameAcceleration(Protocol):
    def __call__(
        self,
        o_ddot: Numbers, Q: Numbers, omega: Numbers, omega_dot: Numbers, rho: Numbers, rho_dot: Numbers, rho_ddot: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncMovingFrameAcceleration(Ufunc, MovingFrameAcceleration, Protocol): ...
class CheckedMovingFrameAcceleration(Checked, MovingFrameAcceleration, Protocol): ...

class LightMovingFrameAcceleration(Protocol):
    def __call__(
        self,
        o_ddot: Light, Q: Light, omega: Light, omega_dot: Light, rho: Light, rho_dot: Light, rho_ddot: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class WrenchAxis(Protocol):
    def __call__(
        self,
        f: Numbers, n_A: Numbers, a: Numbers,
        /,
        *,
        out: tuple[Array | None, Array | None] | None = None,
        **options: Unpack[Options],
    ) -> tuple[Array, Any]: ...

class UfuncWrenchAxis(Ufunc, WrenchAxis, Protocol): ...
class CheckedWrenchAxis(Checked, WrenchAxis, Protocol): ...

class LightWrenchAxis(Protocol):
    def __call__(
        self,
        f: Light, n_A: Light, a: Light,
        /,
        *,
        out: tuple[Array | None, Array | None] | None = None,
    ) -> tuple[Array, Any]: ...

class Power(Protocol):
    def __call__(
        self,
        t: Numbers, w: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Any: ...

class UfuncPower(Ufunc, Power, Protocol): ...
class CheckedPower(Checked, Power, Protocol): ...

class LightPower(Protocol):
    def __call__(
        self,
        t: Light, w: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Any: ...

class ReciprocalProduct(Protocol):
    def __call__(
        self,
        s_w: Numbers, s_t: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Any: ...

class UfuncReciprocalProduct(Ufunc, ReciprocalProduct, Protocol): ...
class CheckedReciprocalProduct(Checked, ReciprocalProduct, Protocol): ...

class LightReciprocalProduct(Protocol):
    def __call__(
        self,
        s_w: Light, s_t: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Any: ...

class WrenchTransfer(Protocol):
    def __call__(
        self,
        w_A: Numbers, a: Numbers, p: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncWrenchTransfer(Ufunc, WrenchTransfer, Protocol): ...
class CheckedWrenchTransfer(Checked, WrenchTransfer, Protocol): ...

class LightWrenchTransfer(Protocol):
    def __call__(
        self,
        w_A: Light, a: Light, p: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class InertiaAboutPoint(Protocol):
    def __call__(
        self,
        I_C: Numbers, m: Numbers, c: Numbers, a: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncInertiaAboutPoint(Ufunc, InertiaAboutPoint, Protocol): ...
class CheckedInertiaAboutPoint(Checked, InertiaAboutPoint, Protocol): ...

class LightInertiaAboutPoint(Protocol):
    def __call__(
        self,
        I_C: Light, m: Light, c: Light, a: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class InertiaAboutPointSym6(Protocol):
    def __call__(
        self,
        I_C: Numbers, m: Numbers, c: Numbers, a: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncInertiaAboutPointSym6(Ufunc, InertiaAboutPointSym6, Protocol): ...
class CheckedInertiaAboutPointSym6(Checked, InertiaAboutPointSym6, Protocol): ...

class LightInertiaAboutPointSym6(Protocol):
    def __call__(
        self,
        I_C: Light, m: Light, c: Light, a: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class MomentumScrew(Protocol):
    def __call__(
        self,
        I_C: Numbers, m: Numbers, t: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncMomentumScrew(Ufunc, MomentumScrew, Protocol): ...
class CheckedMomentumScrew(Checked, MomentumScrew, Protocol): ...

class LightMomentumScrew(Protocol):
    def __call__(
        self,
        I_C: Light, m: Light, t: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class MomentumScrewSym6(Protocol):
    def __call__(
        self,
        I_C: Numbers, m: Numbers, t: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncMomentumScrewSym6(Ufunc, MomentumScrewSym6, Protocol): ...
class CheckedMomentumScrewSym6(Checked, MomentumScrewSym6, Protocol): ...

class LightMomentumScrewSym6(Protocol):
    def __call__(
        self,
        I_C: Light, m: Light, t: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class KineticEnergy(Protocol):
    def __call__(
        self,
        I_C: Numbers, m: Numbers, t: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Any: ...

class UfuncKineticEnergy(Ufunc, KineticEnergy, Protocol): ...
class CheckedKineticEnergy(Checked, KineticEnergy, Protocol): ...

class LightKineticEnergy(Protocol):
    def __call__(
        self,
        I_C: Light, m: Light, t: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Any: ...

class KineticEnergySym6(Protocol):
    def __call__(
        self,
        I_C: Numbers, m: Numbers, t: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Any: ...

class UfuncKineticEnergySym6(Ufunc, KineticEnergySym6, Protocol): ...
class CheckedKineticEnergySym6(Checked, KineticEnergySym6, Protocol): ...

class LightKineticEnergySym6(Protocol):
    def __call__(
        self,
        I_C: Light, m: Light, t: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Any: ...

class NewtonEulerWrench(Protocol):
    def __call__(
        self,
        I_C: Numbers, m: Numbers, t: Numbers, t_dot: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncNewtonEulerWrench(Ufunc, NewtonEulerWrench, Protocol): ...
class CheckedNewtonEulerWrench(Checked, NewtonEulerWrench, Protocol): ...

class LightNewtonEulerWrench(Protocol):
    def __call__(
        self,
        I_C: Light, m: Light, t: Light, t_dot: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class NewtonEulerWrenchSym6(Protocol):
    def __call__(
        self,
        I_C: Numbers, m: Numbers, t: Numbers, t_dot: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncNewtonEulerWrenchSym6(Ufunc, NewtonEulerWrenchSym6, Protocol): ...
class CheckedNewtonEulerWrenchSym6(Checked, NewtonEulerWrenchSym6, Protocol): ...

class LightNewtonEulerWrenchSym6(Protocol):
    def __call__(
        self,
        I_C: Light, m: Light, t: Light, t_dot: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class NewtonEulerTwistRate(Protocol):
    def __call__(
        self,
        I_C: Numbers, m: Numbers, t: Numbers, w: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncNewtonEulerTwistRate(Ufunc, NewtonEulerTwistRate, Protocol): ...
class CheckedNewtonEulerTwistRate(Checked, NewtonEulerTwistRate, Protocol): ...

class LightNewtonEulerTwistRate(Protocol):
    def __call__(
        self,
        I_C: Light, m: Light, t: Light, w: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class NewtonEulerTwistRateSym6(Protocol):
    def __call__(
        self,
        I_C: Numbers, m: Numbers, t: Numbers, w: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncNewtonEulerTwistRateSym6(Ufunc, NewtonEulerTwistRateSym6, Protocol): ...
class CheckedNewtonEulerTwistRateSym6(Checked, NewtonEulerTwistRateSym6, Protocol): ...

class LightNewtonEulerTwistRateSym6(Protocol):
    def __call__(
        self,
        I_C: Light, m: Light, t: Light, w: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class InertiaDyad(Protocol):
    def __call__(
        self,
        I_C: Numbers, m: Numbers, c: Numbers, a: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncInertiaDyad(Ufunc, InertiaDyad, Protocol): ...
class CheckedInertiaDyad(Checked, InertiaDyad, Protocol): ...

class LightInertiaDyad(Protocol):
    def __call__(
        self,
        I_C: Light, m: Light, c: Light, a: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class InertiaDyadSym6(Protocol):
    def __call__(
        self,
        I_C: Numbers, m: Numbers, c: Numbers, a: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncInertiaDyadSym6(Ufunc, InertiaDyadSym6, Protocol): ...
class CheckedInertiaDyadSym6(Checked, InertiaDyadSym6, Protocol): ...

class LightInertiaDyadSym6(Protocol):
    def __call__(
        self,
        I_C: Light, m: Light, c: Light, a: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class RotationFromEulerXyx(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncRotationFromEulerXyx(Ufunc, RotationFromEulerXyx, Protocol): ...
class CheckedRotationFromEulerXyx(Checked, RotationFromEulerXyx, Protocol): ...

class LightRotationFromEulerXyx(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixXyx(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixXyx(Ufunc, EulerRateMatrixXyx, Protocol): ...
class CheckedEulerRateMatrixXyx(Checked, EulerRateMatrixXyx, Protocol): ...

class LightEulerRateMatrixXyx(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixBodyXyx(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixBodyXyx(Ufunc, EulerRateMatrixBodyXyx, Protocol): ...
class CheckedEulerRateMatrixBodyXyx(Checked, EulerRateMatrixBodyXyx, Protocol): ...

class LightEulerRateMatrixBodyXyx(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRatesXyx(Protocol):
    def __call__(
        self,
        angles: Numbers, omega: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRatesXyx(Ufunc, EulerRatesXyx, Protocol): ...
class CheckedEulerRatesXyx(Checked, EulerRatesXyx, Protocol): ...

class LightEulerRatesXyx(Protocol):
    def __call__(
        self,
        angles: Light, omega: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class RotationFromEulerXyz(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncRotationFromEulerXyz(Ufunc, RotationFromEulerXyz, Protocol): ...
class CheckedRotationFromEulerXyz(Checked, RotationFromEulerXyz, Protocol): ...

class LightRotationFromEulerXyz(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixXyz(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixXyz(Ufunc, EulerRateMatrixXyz, Protocol): ...
class CheckedEulerRateMatrixXyz(Checked, EulerRateMatrixXyz, Protocol): ...

class LightEulerRateMatrixXyz(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixBodyXyz(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixBodyXyz(Ufunc, EulerRateMatrixBodyXyz, Protocol): ...
class CheckedEulerRateMatrixBodyXyz(Checked, EulerRateMatrixBodyXyz, Protocol): ...

class LightEulerRateMatrixBodyXyz(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRatesXyz(Protocol):
    def __call__(
        self,
        angles: Numbers, omega: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRatesXyz(Ufunc, EulerRatesXyz, Protocol): ...
class CheckedEulerRatesXyz(Checked, EulerRatesXyz, Protocol): ...

class LightEulerRatesXyz(Protocol):
    def __call__(
        self,
        angles: Light, omega: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class RotationFromEulerXzx(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncRotationFromEulerXzx(Ufunc, RotationFromEulerXzx, Protocol): ...
class CheckedRotationFromEulerXzx(Checked, RotationFromEulerXzx, Protocol): ...

class LightRotationFromEulerXzx(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixXzx(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixXzx(Ufunc, EulerRateMatrixXzx, Protocol): ...
class CheckedEulerRateMatrixXzx(Checked, EulerRateMatrixXzx, Protocol): ...

class LightEulerRateMatrixXzx(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixBodyXzx(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixBodyXzx(Ufunc, EulerRateMatrixBodyXzx, Protocol): ...
class CheckedEulerRateMatrixBodyXzx(Checked, EulerRateMatrixBodyXzx, Protocol): ...

class LightEulerRateMatrixBodyXzx(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRatesXzx(Protocol):
    def __call__(
        self,
        angles: Numbers, omega: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRatesXzx(Ufunc, EulerRatesXzx, Protocol): ...
class CheckedEulerRatesXzx(Checked, EulerRatesXzx, Protocol): ...

class LightEulerRatesXzx(Protocol):
    def __call__(
        self,
        angles: Light, omega: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class RotationFromEulerXzy(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncRotationFromEulerXzy(Ufunc, RotationFromEulerXzy, Protocol): ...
class CheckedRotationFromEulerXzy(Checked, RotationFromEulerXzy, Protocol): ...

class LightRotationFromEulerXzy(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixXzy(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixXzy(Ufunc, EulerRateMatrixXzy, Protocol): ...
class CheckedEulerRateMatrixXzy(Checked, EulerRateMatrixXzy, Protocol): ...

class LightEulerRateMatrixXzy(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixBodyXzy(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixBodyXzy(Ufunc, EulerRateMatrixBodyXzy, Protocol): ...
class CheckedEulerRateMatrixBodyXzy(Checked, EulerRateMatrixBodyXzy, Protocol): ...

class LightEulerRateMatrixBodyXzy(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRatesXzy(Protocol):
    def __call__(
        self,
        angles: Numbers, omega: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRatesXzy(Ufunc, EulerRatesXzy, Protocol): ...
class CheckedEulerRatesXzy(Checked, EulerRatesXzy, Protocol): ...

class LightEulerRatesXzy(Protocol):
    def __call__(
        self,
        angles: Light, omega: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class RotationFromEulerYxy(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncRotationFromEulerYxy(Ufunc, RotationFromEulerYxy, Protocol): ...
class CheckedRotationFromEulerYxy(Checked, RotationFromEulerYxy, Protocol): ...

class LightRotationFromEulerYxy(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixYxy(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixYxy(Ufunc, EulerRateMatrixYxy, Protocol): ...
class CheckedEulerRateMatrixYxy(Checked, EulerRateMatrixYxy, Protocol): ...

class LightEulerRateMatrixYxy(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixBodyYxy(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixBodyYxy(Ufunc, EulerRateMatrixBodyYxy, Protocol): ...
class CheckedEulerRateMatrixBodyYxy(Checked, EulerRateMatrixBodyYxy, Protocol): ...

class LightEulerRateMatrixBodyYxy(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRatesYxy(Protocol):
    def __call__(
        self,
        angles: Numbers, omega: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRatesYxy(Ufunc, EulerRatesYxy, Protocol): ...
class CheckedEulerRatesYxy(Checked, EulerRatesYxy, Protocol): ...

class LightEulerRatesYxy(Protocol):
    def __call__(
        self,
        angles: Light, omega: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class RotationFromEulerYxz(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncRotationFromEulerYxz(Ufunc, RotationFromEulerYxz, Protocol): ...
class CheckedRotationFromEulerYxz(Checked, RotationFromEulerYxz, Protocol): ...

class LightRotationFromEulerYxz(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixYxz(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixYxz(Ufunc, EulerRateMatrixYxz, Protocol): ...
class CheckedEulerRateMatrixYxz(Checked, EulerRateMatrixYxz, Protocol): ...

class LightEulerRateMatrixYxz(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixBodyYxz(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixBodyYxz(Ufunc, EulerRateMatrixBodyYxz, Protocol): ...
class CheckedEulerRateMatrixBodyYxz(Checked, EulerRateMatrixBodyYxz, Protocol): ...

class LightEulerRateMatrixBodyYxz(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRatesYxz(Protocol):
    def __call__(
        self,
        angles: Numbers, omega: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRatesYxz(Ufunc, EulerRatesYxz, Protocol): ...
class CheckedEulerRatesYxz(Checked, EulerRatesYxz, Protocol): ...

class LightEulerRatesYxz(Protocol):
    def __call__(
        self,
        angles: Light, omega: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class RotationFromEulerYzx(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncRotationFromEulerYzx(Ufunc, RotationFromEulerYzx, Protocol): ...
class CheckedRotationFromEulerYzx(Checked, RotationFromEulerYzx, Protocol): ...

class LightRotationFromEulerYzx(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixYzx(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixYzx(Ufunc, EulerRateMatrixYzx, Protocol): ...
class CheckedEulerRateMatrixYzx(Checked, EulerRateMatrixYzx, Protocol): ...

class LightEulerRateMatrixYzx(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixBodyYzx(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixBodyYzx(Ufunc, EulerRateMatrixBodyYzx, Protocol): ...
class CheckedEulerRateMatrixBodyYzx(Checked, EulerRateMatrixBodyYzx, Protocol): ...

class LightEulerRateMatrixBodyYzx(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRatesYzx(Protocol):
    def __call__(
        self,
        angles: Numbers, omega: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRatesYzx(Ufunc, EulerRatesYzx, Protocol): ...
class CheckedEulerRatesYzx(Checked, EulerRatesYzx, Protocol): ...

class LightEulerRatesYzx(Protocol):
    def __call__(
        self,
        angles: Light, omega: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class RotationFromEulerYzy(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncRotationFromEulerYzy(Ufunc, RotationFromEulerYzy, Protocol): ...
class CheckedRotationFromEulerYzy(Checked, RotationFromEulerYzy, Protocol): ...

class LightRotationFromEulerYzy(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixYzy(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixYzy(Ufunc, EulerRateMatrixYzy, Protocol): ...
class CheckedEulerRateMatrixYzy(Checked, EulerRateMatrixYzy, Protocol): ...

class LightEulerRateMatrixYzy(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixBodyYzy(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixBodyYzy(Ufunc, EulerRateMatrixBodyYzy, Protocol): ...
class CheckedEulerRateMatrixBodyYzy(Checked, EulerRateMatrixBodyYzy, Protocol): ...

class LightEulerRateMatrixBodyYzy(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRatesYzy(Protocol):
    def __call__(
        self,
        angles: Numbers, omega: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRatesYzy(Ufunc, EulerRatesYzy, Protocol): ...
class CheckedEulerRatesYzy(Checked, EulerRatesYzy, Protocol): ...

class LightEulerRatesYzy(Protocol):
    def __call__(
        self,
        angles: Light, omega: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class RotationFromEulerZxy(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncRotationFromEulerZxy(Ufunc, RotationFromEulerZxy, Protocol): ...
class CheckedRotationFromEulerZxy(Checked, RotationFromEulerZxy, Protocol): ...

class LightRotationFromEulerZxy(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixZxy(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixZxy(Ufunc, EulerRateMatrixZxy, Protocol): ...
class CheckedEulerRateMatrixZxy(Checked, EulerRateMatrixZxy, Protocol): ...

class LightEulerRateMatrixZxy(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixBodyZxy(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixBodyZxy(Ufunc, EulerRateMatrixBodyZxy, Protocol): ...
class CheckedEulerRateMatrixBodyZxy(Checked, EulerRateMatrixBodyZxy, Protocol): ...

class LightEulerRateMatrixBodyZxy(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRatesZxy(Protocol):
    def __call__(
        self,
        angles: Numbers, omega: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRatesZxy(Ufunc, EulerRatesZxy, Protocol): ...
class CheckedEulerRatesZxy(Checked, EulerRatesZxy, Protocol): ...

class LightEulerRatesZxy(Protocol):
    def __call__(
        self,
        angles: Light, omega: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class RotationFromEulerZxz(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncRotationFromEulerZxz(Ufunc, RotationFromEulerZxz, Protocol): ...
class CheckedRotationFromEulerZxz(Checked, RotationFromEulerZxz, Protocol): ...

class LightRotationFromEulerZxz(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixZxz(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixZxz(Ufunc, EulerRateMatrixZxz, Protocol): ...
class CheckedEulerRateMatrixZxz(Checked, EulerRateMatrixZxz, Protocol): ...

class LightEulerRateMatrixZxz(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixBodyZxz(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixBodyZxz(Ufunc, EulerRateMatrixBodyZxz, Protocol): ...
class CheckedEulerRateMatrixBodyZxz(Checked, EulerRateMatrixBodyZxz, Protocol): ...

class LightEulerRateMatrixBodyZxz(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRatesZxz(Protocol):
    def __call__(
        self,
        angles: Numbers, omega: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRatesZxz(Ufunc, EulerRatesZxz, Protocol): ...
class CheckedEulerRatesZxz(Checked, EulerRatesZxz, Protocol): ...

class LightEulerRatesZxz(Protocol):
    def __call__(
        self,
        angles: Light, omega: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class RotationFromEulerZyx(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncRotationFromEulerZyx(Ufunc, RotationFromEulerZyx, Protocol): ...
class CheckedRotationFromEulerZyx(Checked, RotationFromEulerZyx, Protocol): ...

class LightRotationFromEulerZyx(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixZyx(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixZyx(Ufunc, EulerRateMatrixZyx, Protocol): ...
class CheckedEulerRateMatrixZyx(Checked, EulerRateMatrixZyx, Protocol): ...

class LightEulerRateMatrixZyx(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixBodyZyx(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixBodyZyx(Ufunc, EulerRateMatrixBodyZyx, Protocol): ...
class CheckedEulerRateMatrixBodyZyx(Checked, EulerRateMatrixBodyZyx, Protocol): ...

class LightEulerRateMatrixBodyZyx(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRatesZyx(Protocol):
    def __call__(
        self,
        angles: Numbers, omega: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRatesZyx(Ufunc, EulerRatesZyx, Protocol): ...
class CheckedEulerRatesZyx(Checked, EulerRatesZyx, Protocol): ...

class LightEulerRatesZyx(Protocol):
    def __call__(
        self,
        angles: Light, omega: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class RotationFromEulerZyz(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncRotationFromEulerZyz(Ufunc, RotationFromEulerZyz, Protocol): ...
class CheckedRotationFromEulerZyz(Checked, RotationFromEulerZyz, Protocol): ...

class LightRotationFromEulerZyz(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixZyz(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixZyz(Ufunc, EulerRateMatrixZyz, Protocol): ...
class CheckedEulerRateMatrixZyz(Checked, EulerRateMatrixZyz, Protocol): ...

class LightEulerRateMatrixZyz(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRateMatrixBodyZyz(Protocol):
    def __call__(
        self,
        angles: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRateMatrixBodyZyz(Ufunc, EulerRateMatrixBodyZyz, Protocol): ...
class CheckedEulerRateMatrixBodyZyz(Checked, EulerRateMatrixBodyZyz, Protocol): ...

class LightEulerRateMatrixBodyZyz(Protocol):
    def __call__(
        self,
        angles: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...

class EulerRatesZyz(Protocol):
    def __call__(
        self,
        angles: Numbers, omega: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        **options: Unpack[Options],
    ) -> Array: ...

class UfuncEulerRatesZyz(Ufunc, EulerRatesZyz, Protocol): ...
class CheckedEulerRatesZyz(Checked, EulerRatesZyz, Protocol): ...

class LightEulerRatesZyz(Protocol):
    def __call__(
        self,
        angles: Light, omega: Light,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Array: ...
