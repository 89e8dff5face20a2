#!/usr/bin/env python3
"""The thinnest semicircle of some voussoirs that stands, over its mean radius, where nothing slides.

    tests/reference/thinnest.py 9 27 100

Milankovitch's 0.1075 is the limit of many voussoirs. Bisects with the program of `falls.py`.
"""
import sys

from falls import letter
from lay import scene


def thinnest(voussoirs):
    falls, stands = 0.08, 0.12
    while stands - falls > 1e-6:
        middle = (falls + stands) / 2
        arch = {"mean_radius": 1.0, "thickness": middle, "embrace": 180.0, "voussoirs": voussoirs}
        if letter(scene({"arch": arch, "friction": 10.0}, "contact", "right")) == "s":
            stands = middle
        else:
            falls = middle
    return stands


if __name__ == "__main__":
    for number in sys.argv[1:]:
        print(f"{number} voussoirs: {thinnest(int(number)):.5f}")
