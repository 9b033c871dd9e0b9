#!/usr/bin/env python3
"""A trench of 3 x 2 m on two days, in the folder it runs in: 1 lies over 2, a corner of it stays; beside it 3, where nothing
changed. Scans in site coordinates with markers, outlines."""
import json
import os


def height(day, x):
    return 10.14 if x < 200 and (day == "2025-06-01" or x < 20) else 10.0


markers = ["scan,marker,x,y,z"]
for day in ("2025-06-01", "2025-06-02"):
    os.makedirs(day, exist_ok=True)
    with open(f"{day}/s.xyz", "w", encoding="utf-8") as out:
        for x in range(300):
            for y in range(200):
                out.write(f"{x / 100 + 0.005:.3f} {y / 100 + 0.005:.3f} {height(day, x):.3f}\n")
    markers += [f"{day}/s,M{i},{at}" for i, at in enumerate(("0,0,11", "3,0,11", "0,2,11", "3,2,12"))]
markers += [f"site,M{i},{at}" for i, at in enumerate(("0,0,11", "3,0,11", "0,2,11", "3,2,12"))]
with open("markers.csv", "w", encoding="utf-8") as out:
    out.write("\n".join(markers) + "\n")


def outline(unit, day, west, east):
    ring = [[west, 0], [east, 0], [east, 2], [west, 2], [west, 0]]
    return {"type": "Feature", "properties": {"unit": unit, "day": day},
            "geometry": {"type": "Polygon", "coordinates": [ring]}}


features = [outline("1", "2025-06-01", 0, 2), outline("3", "2025-06-01", 2, 3), outline("1", "2025-06-02", 0, 0.2),
            outline("2", "2025-06-02", 0.2, 2), outline("3", "2025-06-02", 2, 3)]
with open("outlines.geojson", "w", encoding="utf-8") as out:
    json.dump({"type": "FeatureCollection", "features": features}, out)
