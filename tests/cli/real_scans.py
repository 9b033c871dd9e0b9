#!/usr/bin/env python3
"""Real scans through the program: the counts that their own README states, and damaged files refused with a sentence.

usage: real_scans.py PLANUM DATA_FOLDER; says SKIPPED by name where the data are absent.
"""
import json
import os
import subprocess
import sys
import tempfile

# Points, and rows and columns of the grid, as the data's README or the files' headers state them.
SOUND = {
    "e57/pye57_pumpAVisualReferenceImage.e57": (155201, 1074, 345),
    "3dtk/scan000.3d": (81360, None, None),
    "pairs/small_gicp_source.ply": (69792, None, None),
    "pairs/small_gicp_target.ply": (69088, None, None),
    "las/pdal_simple.las": (1065, None, None),
    "las/pdal_1.2-with-color.las": (1065, None, None),
}
DAMAGED = {
    "e57/asm_bad-crc.e57": "page 0 of 1 (byte 0) is damaged: its checksum is wrong",
    "e57/asm_InvalidCVHeader.e57": "byte 48: no table of points starts here",
}


def run(planum, *arguments):
    return subprocess.run([planum, *arguments], capture_output=True, text=True, check=False)


def refused(planum, site, scan, sentence):
    answer = run(planum, "scan", "add", site, scan, "--day", "2025-06-02")
    if answer.returncode == 3 and sentence in answer.stderr and answer.stderr.count("\n") == 1:
        return True
    print("FAILED %s: exit status %d: %s" % (scan, answer.returncode, answer.stderr))
    return False


def main():
    planum, data = os.path.abspath(sys.argv[1]), os.path.join(sys.argv[2], "scans")
    passed, failed = 0, 0
    with tempfile.TemporaryDirectory() as folder:
        site = os.path.join(folder, "site.gpkg")
        run(planum, "new", "-q", site)
        for name, (points, rows, columns) in SOUND.items():
            scan = os.path.join(data, name)
            if not os.path.exists(scan):
                print("SKIPPED, real data absent: scans/" + name)
                continue
            answer = run(planum, "scan", "add", site, scan, "--day", "2025-06-01", "--json")
            added = json.loads(answer.stdout)["added"][0] if answer.returncode == 0 else {}
            good = added.get("points") == points
            good = good and (rows is None or (added["rows"], added["columns"]) == (rows, columns))
            passed, failed = passed + good, failed + (not good)
            if not good:
                print("FAILED %s: %s%s" % (name, answer.stdout, answer.stderr))
        for name, sentence in DAMAGED.items():
            scan = os.path.join(data, name)
            if not os.path.exists(scan):
                print("SKIPPED, real data absent: scans/" + name)
                continue
            good = refused(planum, site, scan, sentence)
            passed, failed = passed + good, failed + (not good)
    print("%d as stated, %d not" % (passed, failed))
    return 1 if failed else 0


sys.exit(main())
