#!/usr/bin/env python3
"""A field of 3 x 2 m at 10 m as XYZ: dug_xyz.py DEPTH [RAISED]; in its middle a pit of 1 x 1 m and that depth with
upright sides, one point a square centimetre; the western metre lies RAISED higher."""
import sys

depth = float(sys.argv[1])
raised = float(sys.argv[2]) if len(sys.argv) > 2 else 0.0
inside = lambda x, y: 1 < x < 2 and 0.5 < y < 1.5
for i in range(300):
    for j in range(200):
        x, y = 0.01 * i + 0.005, 0.01 * j + 0.005
        z = 10 - depth if inside(x, y) else 10 + raised if x < 1 else 10
        print(f"{x:.3f} {y:.3f} {z:.4f}")
for k in range(int(100 * depth)):  # the sides
    for i in range(100):
        along, z = 1 + 0.01 * i + 0.005, 10 - 0.01 * k - 0.005
        print(f"{along:.3f} 0.501 {z:.3f}\n{along:.3f} 1.499 {z:.3f}")
        print(f"1.001 {along - 0.5:.3f} {z:.3f}\n1.999 {along - 0.5:.3f} {z:.3f}")
