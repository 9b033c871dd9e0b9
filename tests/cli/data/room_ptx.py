#!/usr/bin/env python3
"""A room of 10 x 10 x 4 m as PTX: room_ptx.py COLUMNS ROWS [--colour]; one ray for each cell, a whole turn, no misses."""
import math
import sys

columns, rows = int(sys.argv[1]), int(sys.argv[2])
colour = "--colour" in sys.argv
out = [str(columns), str(rows), "0 0 0", "1 0 0", "0 1 0", "0 0 1", "1 0 0 0", "0 1 0 0", "0 0 1 0", "0 0 0 1"]
for c in range(columns):
    azimuth = math.pi - 2 * math.pi * (c + 0.5) / columns
    for r in range(rows):
        elevation = math.radians(-60 + 120 * (r + 0.5) / rows)
        x, y, z = math.cos(elevation) * math.cos(azimuth), math.cos(elevation) * math.sin(azimuth), math.sin(elevation)
        reach = min(5 / max(abs(x), abs(y)), 2.5 / z if z > 0 else 1.5 / -z)
        line = f"{reach * x:.5f} {reach * y:.5f} {reach * z:.5f} {0.2 + 0.6 * ((c // 5 + r // 5) % 2):.3f}"
        out.append(line + (f" {c % 256} {r % 256} 90" if colour else ""))
print("\n".join(out))
