"""Section 3: a crank that drives a slider, and four bars in a loop."""

from chasles.statements import Claim, Condition, Definition, Kernel, Section, nonzero, positive
from chasles.vocabulary import column, cos, norm, number, over, rate, sin

from .notation import beta, coupler, coupler_length, crank, frame, omega_rod, output, psi, rod, theta, x

linkage_section = Section("3", "Linkages")

slider_position = Definition(
    "3.1",
    x, crank * cos(theta) + rod * cos(beta),
    says="The position of the slider, at the end of crank and rod.",
)

angular_velocity_of_rod = Definition(
    "3.1",
    rate(beta), omega_rod,
    part=2,
    says="The angular velocity of the rod.",
    sign="=",
)

slider_stays_on_its_guide = Condition(
    "3.2",
    crank * cos(theta) * rate(theta) + rod * cos(beta) * omega_rod, number(0),
    says="The end of the rod does not leave the guide: its velocity has no component across.",
    assuming=(positive(rod), nonzero(cos(beta))),
    on=(omega_rod,),
)

slider_velocity = Claim(
    "3.3",
    rate(x), -over(crank * sin(theta - beta), cos(beta)) * rate(theta),
    says="The velocity of the slider, where the rod is not at right angles to the guide.",
    given=(slider_position, angular_velocity_of_rod, slider_stays_on_its_guide),
    assuming=(positive(rod), nonzero(cos(beta))),
    kernel=Kernel(of=(crank, theta, rate(theta), beta)),
)

coupler_closes_the_loop = Definition(
    "3.4",
    coupler, column(frame + output * cos(psi) - crank * cos(theta), output * sin(psi) - crank * sin(theta)),
    says="The coupler joins the ends of the crank and of the output link.",
    sign="=",
)

length_of_coupler = Definition(
    "3.4",
    coupler_length, norm(coupler),
    part=2,
    says="The length of the coupler.",
    sign="=",
)

freudenstein = Claim(
    "3.5",
    over(frame**2 + crank**2 + output**2 - coupler_length**2, 2 * crank * output)
    - over(frame, output) * cos(theta) + over(frame, crank) * cos(psi),
    cos(theta - psi),
    says="Freudenstein's equation between the angles of the crank and of the output link.",
    given=(coupler_closes_the_loop, length_of_coupler),
    assuming=(positive(crank), positive(output)),
)
