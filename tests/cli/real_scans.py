#!/usr/bin/env python3
"""Every real scan through the program, held against what plain readers here find in the same file.

usage: real_scans.py PLANUM DATA_FOLDER; says SKIPPED by name where the data are absent.

The readers are as simple as the formats let them be (split the line, unpack the record); of E57 they read only the XML, whose
counts, bounds, poses and limits the program must find again in the points. Damaged files must be refused with a sentence.
"""
import glob
import json
import math
import os
import re
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

# What the README of the data says, which no reader decides.
STATED = {
    "e57/pye57_pumpAVisualReferenceImage.e57": {"points": 155201, "rows": 1074, "columns": 345},
    "3dtk/scan000.3d": {"points": 81360},
    "3dtk/scan001.3d": {"points": 81360},
    "3dtk/scan002.3d": {"points": 81360},
    "pairs/small_gicp_source.ply": {"points": 69792},
    "pairs/small_gicp_target.ply": {"points": 69088},
    "las/pdal_simple.las": {"points": 1065},
    "las/pdal_1.2-with-color.las": {"points": 1065},
}
DAMAGED = {
    "e57/asm_bad-crc.e57": "page 0 of 1 (byte 0) is damaged: its checksum is wrong",
    "e57/asm_InvalidCVHeader.e57": "byte 48: no table of points starts here",
}
# Sound files without a scan in them: nothing to add, and said so.
WITHOUT_SCAN = ("e57/asm_empty.e57", "e57/asm_PinholeImageWithDistortionParameters.e57")
# Its matrix stretches, which no pose can: the program brings the stretching into the points.
STRETCHED = "pdal_multiple-and-transform.ptx"


def run(planum, *arguments):
    return subprocess.run([planum, *arguments], capture_output=True, text=True, check=False)


def cloud(points=(), **more):
    """What an oracle knows of a cloud; bounds from its points where it has them."""
    found = dict(more)
    if points:
        found["points"] = len(points)
        found["bounds"] = ([min(p[i] for p in points) for i in range(3)], [max(p[i] for p in points) for i in range(3)])
    return found


def read_ptx(file):
    lines = open(file, encoding="ascii").read().split("\n")
    clouds, at = [], 0
    while at < len(lines) and lines[at].strip():
        columns, rows = int(lines[at]), int(lines[at + 1])
        matrix = [[float(w) for w in lines[at + 6 + i].split()] for i in range(4)]
        records = [line.split() for line in lines[at + 10:at + 10 + columns * rows]]
        points = [[float(w) for w in r[:3]] for r in records if any(float(w) != 0 for w in r[:3])]
        channels = ["intensity"] + (["colour"] if len(records[0]) == 7 else []) + ["row and column"]
        # The file has rows of a row vector: transposed is ours.
        pose = [[matrix[c][r] for c in range(4)] for r in range(4)]
        clouds.append(cloud(points, rows=rows, columns=columns, pose=pose, channels=channels, records=columns * rows))
        at += 10 + columns * rows
    if file.endswith(STRETCHED):
        for one in clouds:
            del one["bounds"], one["pose"]
    return clouds


def read_pts(file):
    records = [line.split() for line in open(file, encoding="ascii").read().split("\n")[1:] if line.strip()]
    width = len(records[0])
    channels = {3: [], 4: ["intensity"], 7: ["intensity", "colour"]}[width]
    return [cloud([[float(w) for w in r[:3]] for r in records], channels=channels)]


def read_las(file):
    data = open(file, "rb").read()
    begins, _, kind, length, count = struct.unpack_from("<IIBHI", data, 96)
    if data[25] == 4:
        count = struct.unpack_from("<Q", data, 247)[0]
    scale, offset = struct.unpack_from("<3d", data, 131), struct.unpack_from("<3d", data, 155)
    raw = [struct.unpack_from("<3i", data, begins + i * length) for i in range(count)]
    points = [[r[i] * scale[i] + offset[i] for i in range(3)] for r in raw]
    return [cloud(points, channels=["intensity"] + (["colour"] if kind in (2, 3, 7, 8) else []))]


def read_ply(file):
    data = open(file, "rb").read()
    head, body = data.split(b"end_header\n", 1)
    count = int(re.search(rb"element vertex (\d+)", head).group(1))
    assert b"binary_little_endian" in head and head.count(b"property float") == 4
    return [cloud([struct.unpack_from("<3f", body, 16 * i) for i in range(count)], channels=["intensity"])]


def read_3dtk(file):
    records = [[float(w) for w in line.split()] for line in open(file, encoding="ascii") if line.strip()]
    # Left-handed centimetres, y up and z forward; ours is z up, x forward, y to the left.
    points = [[r[2] / 100, -r[0] / 100, r[1] / 100] for r in records]
    place = [float(w) / 100 for w in open(file[:-3] + ".pose", encoding="ascii").readline().split()]
    return [cloud(points, stands=[place[2], -place[0], place[1]], channels=[])]


def read_csv(file):
    lines = open(file, encoding="ascii").read().split("\n")
    named = [word.strip('"') for word in lines[0].split(",")]
    points = [[float(w) for w in line.split(",")[:3]] for line in lines[1:] if line.strip()]
    channels = (["intensity"] if "Intensity" in named else []) + (["colour"] if "Red" in named else [])
    return [cloud(points, channels=channels)]


def number(node, path, default=0.0):
    found = node.find(path)
    return default if found is None else float(found.text or 0) * float(found.get("scale", 1)) + float(found.get("offset", 0))


def read_e57(file):
    data = open(file, "rb").read()
    xml_at, xml_long, page = struct.unpack_from("<QQQ", data, 24)
    logical = b"".join(data[i:i + page - 4] for i in range(0, len(data), page))
    begins = xml_at // page * (page - 4) + xml_at % page
    text = logical[begins:begins + xml_long].decode("utf-8")
    root = ElementTree.fromstring(re.sub(r'xmlns="[^"]*"', "", text, count=1))
    clouds = []
    for scan in root.findall("data3D/vectorChild"):
        points = scan.find("points")
        fields = [field.tag for field in points.find("prototype")]
        has = [("intensity", "intensity"), ("colour", "colorRed"), ("row and column", "rowIndex")]
        known = {"channels": [name for name, field in has if field in fields], "records": int(points.get("recordCount"))}
        bounds = scan.find("cartesianBounds")
        if bounds is not None and known["records"]:
            known["bounds"] = tuple([number(bounds, axis + end) for axis in "xyz"] for end in ("Minimum", "Maximum"))
        if not known["records"] or not {"cartesianInvalidState", "sphericalInvalidState"} & set(fields):
            known["points"] = known["records"]
        w, x, y, z = (number(scan, "pose/rotation/" + n, 1.0 if n == "w" else 0.0) for n in "wxyz")
        if scan.find("pose") is not None:
            known["pose"] = [
                [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), number(scan, "pose/translation/x")],
                [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), number(scan, "pose/translation/y")],
                [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), number(scan, "pose/translation/z")],
                [0, 0, 0, 1]]
        limits = scan.find("intensityLimits")
        if limits is not None and "intensity" in fields:
            known["limits"] = [number(limits, "intensityMinimum"), number(limits, "intensityMaximum")]
        clouds.append(known)
    return clouds


READERS = {".ptx": read_ptx, ".pts": read_pts, ".las": read_las, ".ply": read_ply, ".3d": read_3dtk, ".txt": read_csv,
           ".e57": read_e57}


def near(found, wanted, within):
    return found is not None and len(found) == len(wanted) and all(
        math.isclose(a, b, rel_tol=1e-9, abs_tol=within) for a, b in zip(found, wanted))


def differences(shown, known):
    """What the program says of a cloud otherwise than the oracle, in words."""
    wrong = []

    def check(name, good, found, wanted):
        if not good:
            wrong.append("%s: %s, not %s" % (name, found, wanted))

    for name in ("points", "rows", "columns"):
        if name in known:
            check(name, shown[name] == known[name], shown[name], known[name])
    original = shown["original"] or {}
    if "records" in known:
        check("records", original.get("records") == known["records"], original.get("records"), known["records"])
    kept = [channel for channel in shown["channels"] if channel != "time"]
    check("channels", kept == known["channels"], kept, known["channels"])
    if "bounds" in known:
        for end, wanted in zip(("minimum", "maximum"), known["bounds"]):
            check("bounds", near(shown["bounds"][end], wanted, 2e-5), shown["bounds"][end], wanted)
    pose = shown["header_pose"]
    if "pose" in known:
        flat = [value for row in known["pose"] for value in row]
        is_identity = near(flat, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], 0)
        check("pose", near(pose, flat, 1e-5) or (pose is None and is_identity), pose, flat)
    if "stands" in known:
        stands = None if pose is None else [pose[3], pose[7], pose[11]]
        check("place", near(stands, known["stands"], 1e-9), stands, known["stands"])
    if "limits" in known:
        limits = (original.get("intensity") or {}).get("limits")
        check("intensity limits", near(limits, known["limits"], 1e-12), limits, known["limits"])
    return wrong


def judge(planum, site, data, name):
    """Adds one file as the scans of a new day and returns what is wrong with them."""
    file = os.path.join(data, name)
    known = READERS[os.path.splitext(name)[1]](file)
    answer = run(planum, "scan", "add", site, file, "--day", judge.day(), "--json")
    if name in WITHOUT_SCAN:
        good = answer.returncode == 3 and "has no scan in it" in answer.stderr
        return [] if good else ["exit status %d: %s%s" % (answer.returncode, answer.stdout, answer.stderr)]
    if answer.returncode != 0:
        return ["exit status %d: %s" % (answer.returncode, answer.stderr)]
    added = json.loads(answer.stdout)["added"]
    if len(added) != len(known):
        return ["%d clouds, not %d" % (len(added), len(known))]
    known[0].update(STATED.get(name, {}))
    wrong = []
    for one, cloud_known in zip(added, known):
        shown = json.loads(run(planum, "scan", "show", site, one["scan"], "--json").stdout)
        wrong += differences(shown, cloud_known)
    return wrong


def days():
    number_of_days = 0

    def day():
        nonlocal number_of_days
        number_of_days += 1
        return "2025-%02d-%02d" % (1 + number_of_days // 28, 1 + number_of_days % 28)

    return day


def refused(planum, site, scan, sentence):
    answer = run(planum, "scan", "add", site, scan, "--day", "2024-06-02")
    if answer.returncode == 3 and sentence in answer.stderr and answer.stderr.count("\n") == 1:
        return []
    return ["exit status %d: %s" % (answer.returncode, answer.stderr)]


def image_of_pump(planum, site, folder):
    """The photograph inside the real E57 file comes out as the JPEG it is."""
    scans = json.loads(run(planum, "scan", "list", site, "--json").stdout)["scans"]
    pump = [scan["scan"] for scan in scans if "pumpA" in scan["file"]]
    if not pump:
        return []
    picture = os.path.join(folder, "pump.jpg")
    answer = run(planum, "scan", "image", site, pump[0], "-o", picture)
    data = open(picture, "rb").read() if answer.returncode == 0 else b""
    whole = data[:2] == b"\xff\xd8" and data.rstrip(b"\0")[-2:] == b"\xff\xd9" and len(data) == 1504576
    return [] if whole else ["image: %d bytes, %s" % (len(data), answer.stderr)]


def main():
    planum, data = os.path.abspath(sys.argv[1]), os.path.join(sys.argv[2], "scans")
    passed, failed, seen = 0, 0, 0
    judge.day = days()

    def count(name, wrong):
        nonlocal passed, failed
        passed, failed = passed + (not wrong), failed + bool(wrong)
        for line in wrong:
            print("FAILED %s: %s" % (name, line))

    with tempfile.TemporaryDirectory() as folder:
        site = os.path.join(folder, "site.gpkg")
        run(planum, "new", "-q", site)
        for file in sorted(glob.glob(os.path.join(data, "**", "*"), recursive=True)):
            name = os.path.relpath(file, data)
            ours = os.path.splitext(name)[1] in READERS and not name.endswith(("VOLUMES.txt", "from_scan.txt", "_source.txt"))
            if not ours or name in DAMAGED:
                continue
            seen += 1
            count(name, judge(planum, site, data, name))
        for name, sentence in DAMAGED.items():
            if os.path.exists(os.path.join(data, name)):
                count(name, refused(planum, site, os.path.join(data, name), sentence))
        count("the image of pumpA", image_of_pump(planum, site, folder))
        if not seen:
            print("SKIPPED, real data absent: scans")
    print("%d as stated, %d not" % (passed, failed))
    return 1 if failed else 0


sys.exit(main())
