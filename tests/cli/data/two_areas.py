#!/usr/bin/env python3
"""Two trenches of 3 x 2 m on the same two days, in the folder it runs in: A at x = 0 and 10 m up, B at x = 5 and 7 m up. In both 1
lies over 2, 14 cm thick, and is gone on the second day. One scan a trench and day in site coordinates, markers, outlines."""
import json
import os

places = ("0,0,11", "8,0,11", "0,2,11", "8,2,12")
markers = ["scan,marker,x,y,z"] + [f"site,M{i},{at}" for i, at in enumerate(places)]
features = []
for area, west, floor in (("A", 0, 10.0), ("B", 5, 7.0)):
    for day, unit in (("2025-06-01", "1"), ("2025-06-02", "2")):
        os.makedirs(f"{area}/{day}", exist_ok=True)
        z = floor + (0.14 if unit == "1" else 0.0)
        with open(f"{area}/{day}/{area}.xyz", "w", encoding="utf-8") as out:
            for x in range(300):
                for y in range(200):
                    out.write(f"{west + x / 100 + 0.005:.3f} {y / 100 + 0.005:.3f} {z:.3f}\n")
        markers += [f"{day}/{area},M{i},{at}" for i, at in enumerate(places)]
        ring = [[west, 0], [west + 3, 0], [west + 3, 2], [west, 2], [west, 0]]
        features.append({"type": "Feature", "properties": {"unit": unit, "area": area, "day": day},
                         "geometry": {"type": "Polygon", "coordinates": [ring]}})
with open("markers.csv", "w", encoding="utf-8") as out:
    out.write("\n".join(markers) + "\n")
with open("outlines.geojson", "w", encoding="utf-8") as out:
    json.dump({"type": "FeatureCollection", "features": features}, out)
