"""The roads: how the important results come about, one module a road, in the book's order."""

ROADS = (
    "r01_mozzi_chasles",
    "r02_screw_axis",
    "r03_velocity",
    "r04_instant_screw",
    "r05_rate_matrices",
    "r06_left_inverses",
    "r07_acceleration",
    "r08_rates_of_matrices",
    "r09_moving_frame",
    "r10_statics",
    "r11_energy_and_inertia",
    "r12_newton_euler",
    "r13_euler_angles",
)
