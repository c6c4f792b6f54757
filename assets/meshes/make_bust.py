#!/usr/bin/env python3
"""Writes bust.obj, the torso of a dressmaker's dummy: superellipses along a spine, closed at both ends."""
import math
import pathlib

AROUND = 28
# Height [m], half width, half depth, exponent of the superellipse, and how far the spine leans back at that height [m].
RINGS = [
    (0.00, 0.155, 0.105, 2.0, 0.000),
    (0.05, 0.168, 0.115, 2.0, 0.000),
    (0.13, 0.165, 0.112, 2.0, 0.004),
    (0.22, 0.132, 0.095, 2.0, 0.006),
    (0.30, 0.128, 0.092, 2.0, 0.004),
    (0.38, 0.145, 0.105, 2.1, 0.000),
    (0.46, 0.162, 0.120, 2.2, -0.004),
    (0.53, 0.180, 0.112, 2.3, -0.004),
    (0.58, 0.196, 0.094, 2.3, 0.000),
    (0.62, 0.200, 0.078, 2.2, 0.004),
    (0.645, 0.185, 0.068, 2.1, 0.006),
    (0.665, 0.140, 0.062, 2.0, 0.008),
    (0.680, 0.090, 0.058, 2.0, 0.008),
    (0.700, 0.064, 0.055, 2.0, 0.006),
    (0.740, 0.056, 0.053, 2.0, 0.002),
    (0.780, 0.055, 0.053, 2.0, 0.000),
]


def point(ring, step):
    height, width, depth, exponent, lean = ring
    angle = 2 * math.pi * step / AROUND
    c, s = math.cos(angle), math.sin(angle)
    x = math.copysign(abs(c) ** (2 / exponent), c) * width
    z = math.copysign(abs(s) ** (2 / exponent), s) * depth
    return x, height, z - lean


def main():
    lines = ["# Made by make_bust.py"]
    for ring in RINGS:
        lines += ["v %.4f %.4f %.4f" % point(ring, step) for step in range(AROUND)]
    lines += ["v 0 0 0", "v 0 %.4f 0" % RINGS[-1][0]]
    bottom, top = len(RINGS) * AROUND + 1, len(RINGS) * AROUND + 2
    for r in range(len(RINGS) - 1):
        for step in range(AROUND):
            a, b = r * AROUND + step + 1, r * AROUND + (step + 1) % AROUND + 1
            lines += ["f %d %d %d" % (a, a + AROUND, b), "f %d %d %d" % (b, a + AROUND, b + AROUND)]
    last = (len(RINGS) - 1) * AROUND
    for step in range(AROUND):
        after = (step + 1) % AROUND
        lines += ["f %d %d %d" % (step + 1, after + 1, bottom), "f %d %d %d" % (last + after + 1, last + step + 1, top)]
    pathlib.Path(__file__).with_name("bust.obj").write_text("\n".join(lines) + "\n")


main()
