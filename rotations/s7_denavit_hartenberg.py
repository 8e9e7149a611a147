"""Section 7: Denavit-Hartenberg frames, in the order of Denavit and Hartenberg and in the modified one."""

from chasles.rotations.notation import *

from chasles.statements import Claim, Definition, Kernel, Section
from chasles.vocabulary import CPM, LENGTH, PI, Zero, column, cos, dot, matrix, rate, scalar, sin
from chasles.vocabulary.motions import homogeneous, inverse_motion

denavit_hartenberg = Section("7", "Denavit-Hartenberg Frames")

theta_0 = scalar("theta", r"\theta", "angle at a sliding joint", constant=True)
stroke = scalar("b", "b", "stroke of a sliding joint", LENGTH)
slide = turned(about_z(theta_0)) @ along(stroke * z_axis) @ along(link * x_axis) @ turned(about_x(twist_of_link))
ct, st, cl, sl = cos(theta), sin(theta), cos(twist_of_link), sin(twist_of_link)

link_frame = Definition(
    "7.1",
    A_DH,
    turned(about_z(theta)) @ along(offset * z_axis) @ along(link * x_axis) @ turned(about_x(twist_of_link)),
    says="From a link to the one before it: about and along the axis of the joint, along and about the common normal.",
    sign="=",
)

denavit_hartenberg_matrix = Claim(
    "7.2",
    A_DH,
    matrix(
        (ct, -st * cl, st * sl, link * ct),
        (st, ct * cl, -ct * sl, link * st),
        (0, sl, cl, offset),
        (0, 0, 0, 1),
    ),
    says="The same, entry by entry.",
    given=(link_frame,),
    kernel=Kernel(of=(theta, offset, link, twist_of_link)),
)

rotation_of_link = Claim(
    "7.3",
    A_DH[1:3, 1:3], about_z(theta) @ about_x(twist_of_link),
    says="The rotation of a link.",
    given=(link_frame,),
    kernel=Kernel(of=(theta, twist_of_link)),
)

position_of_link = Claim(
    "7.4",
    A_DH[1:3, 4], about_z(theta) @ column(link, 0, offset),
    says="Where the origin of a link lies.",
    given=(link_frame,),
)

position_of_link_in_its_own_frame = Claim(
    "7.5",
    A_DH[1:3, 1:3].T @ A_DH[1:3, 4], column(link, offset * sl, offset * cl),
    says="The same in the frame of the link, where the angle of the joint does not occur.",
    given=(link_frame,),
)

length_of_link = Claim(
    "7.6",
    dot(A_DH[1:3, 4], A_DH[1:3, 4]), link**2 + offset**2,
    says="How far apart the origins are.",
    given=(link_frame,),
)

inverse_denavit_hartenberg_matrix = Claim(
    "7.7",
    inverse_motion(A_DH),
    matrix(
        (ct, st, 0, -link),
        (-st * cl, ct * cl, sl, -offset * sl),
        (st * sl, -ct * sl, cl, -offset * cl),
        (0, 0, 0, 1),
    ),
    says="From a link to the one after it.",
    given=(link_frame,),
    kernel=Kernel(of=(theta, offset, link, twist_of_link)),
)

turn_and_slide_commute = Claim(
    "7.8",
    turned(about_z(theta)) @ along(offset * z_axis), along(offset * z_axis) @ turned(about_z(theta)),
    says="About and along one axis may be exchanged.",
)

common_normal = Claim(
    "7.9",
    A_DH[1:3, 1:3] @ x_axis, column(ct, st, 0),
    says="The axis x of a link is at right angles to the axes of both its joints.",
    given=(link_frame,),
)

angle_between_joint_axes = Claim(
    "7.10",
    dot(z_axis, A_DH[1:3, 1:3] @ z_axis), cl,
    says="The twist of a link is the angle between the axes of its joints.",
    given=(link_frame,),
)

modified_link_frame = Definition(
    "7.11",
    A_DH,
    turned(about_x(twist_of_link)) @ along(link * x_axis) @ turned(about_z(theta)) @ along(offset * z_axis),
    says="The modified order: about and along the common normal, then about and along the axis of the joint.",
    sign="=",
)

modified_denavit_hartenberg_matrix = Claim(
    "7.12",
    A_DH,
    matrix(
        (ct, -st, 0, link),
        (st * cl, ct * cl, -sl, -offset * sl),
        (st * sl, ct * sl, cl, offset * cl),
        (0, 0, 0, 1),
    ),
    says="The same, entry by entry.",
    given=(modified_link_frame,),
    kernel=Kernel(of=(theta, offset, link, twist_of_link)),
)

rate_at_revolute_joint = Claim(
    "7.13",
    rate(A_DH), rate(theta) * matrix((CPM(z_axis), zero), (zero_row, 0)) @ A_DH,
    says="A turning joint moves what follows about the axis z of the frame before it.",
    given=(link_frame,),
)

rate_at_prismatic_joint = Claim(
    "7.14",
    rate(slide) @ inverse_motion(slide), matrix((Zero(3, 3), rate(stroke) * z_axis), (zero_row, 0)),
    says="A sliding joint moves what follows along that axis.",
)

product_of_rotations_of_two_links = Claim(
    "7.15",
    about_z(phi_1) @ about_x(PI / 2) @ about_z(phi_2) @ about_x(-PI / 2), about_z(phi_1) @ about_y(-phi_2),
    says="Two joints with axes at right angles: the second turns about y, backwards.",
)

parallel_joints_add_up = Claim(
    "7.16",
    turned(about_z(phi_1)) @ along(link * x_axis) @ turned(about_z(phi_2)) @ along(link * x_axis),
    homogeneous(
        about_z(phi_1 + phi_2),
        column(link * (cos(phi_1) + cos(phi_1 + phi_2)), link * (sin(phi_1) + sin(phi_1 + phi_2)), 0),
    ),
    says="Two equal links with parallel axes.",
)
