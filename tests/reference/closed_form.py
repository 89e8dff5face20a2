"""The macro-block range of a regular wall, Eqs. (1) to (7) of the paper as printed, thickness and specific weight 1."""
from math import sqrt

import bonds


def macro_block(file):
    """`lower`, `upper` and `tan_beta` of a coursed wall in running bond."""
    courses = len(bonds.rows(file))
    height, s = courses * file["unit"]["height"], file["unit"]["length"] / 2
    p, f = file.get("overburden", 0.0) * height, file["friction"]
    alpha_b = s / file["unit"]["height"]
    F = (p * height * alpha_b + (height * alpha_b + s) * height / 2) * f  # (1)
    r, t, v = p / height, s / height, F / height**2  # (7)
    tan_beta = (-3 * t * (1 + 2 * r) + sqrt(3 * t**2 * (1 + 4 * r) + 8 * v * (1 + 3 * r))) / (2 * (1 + 3 * r))  # (6)
    P, P1, P2 = p * (height * tan_beta + s), height**2 * tan_beta / 2, s * height  # (3)

    def multiplier(F):  # (5)
        resisting = P * (height * tan_beta + s) / 2 + P1 * (height * tan_beta / 3 + s) + P2 * s / 2 + F * height / 3
        return resisting / (P * height + P1 * 2 / 3 * height + P2 * height / 2)

    return {"lower": multiplier(0.0), "upper": multiplier(F), "tan_beta": tan_beta}
