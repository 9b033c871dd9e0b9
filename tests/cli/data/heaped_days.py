#!/usr/bin/env python3
"""A trench of 3 x 2 m on three days, in the folder it runs in. On the second a heap of 1 x 1 m lies on 1, 12 cm high, which is
gone on the third, when two scans disagree over 0.8 m² of 2 by 6 cm. Scans in site coordinates with markers, outlines."""
import json
import os


def height(day, scan, x, y):
    if day == "2025-06-02" and 50 <= x < 150 and 50 <= y < 150:
        return 10.12
    if scan == "b" and 200 <= x < 280 and 50 <= y < 150:
        return 10.06
    return 9.999 if day == "2025-06-03" else 10.0


scans = [("2025-06-01", "a"), ("2025-06-02", "a"), ("2025-06-03", "a"), ("2025-06-03", "b")]
places = ("0,0,11", "3,0,11", "0,2,11", "3,2,12")
markers = ["scan,marker,x,y,z"] + [f"site,M{i},{at}" for i, at in enumerate(places)]
for day, scan in scans:
    os.makedirs(day, exist_ok=True)
    with open(f"{day}/{scan}.xyz", "w", encoding="utf-8") as out:
        for x in range(300):
            for y in range(200):
                out.write(f"{x / 100 + 0.005:.3f} {y / 100 + 0.005:.3f} {height(day, scan, x, y):.3f}\n")
    markers += [f"{day}/{scan},M{i},{at}" for i, at in enumerate(places)]
with open("markers.csv", "w", encoding="utf-8") as out:
    out.write("\n".join(markers) + "\n")


def outline(unit, day, west, east):
    ring = [[west, 0], [east, 0], [east, 2], [west, 2], [west, 0]]
    return {"type": "Feature", "properties": {"unit": unit, "day": day},
            "geometry": {"type": "Polygon", "coordinates": [ring]}}


# Nobody drew anything on the third day yet: the outlines of the second still hold.
features = [outline(unit, day, west, east) for day in ("2025-06-01", "2025-06-02")
            for unit, west, east in (("1", 0, 1.8), ("2", 1.8, 3))]
with open("outlines.geojson", "w", encoding="utf-8") as out:
    json.dump({"type": "FeatureCollection", "features": features}, out)
