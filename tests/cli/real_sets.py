#!/usr/bin/env python3
"""Every real set of the table in the data's own README: new, import, matrix --stats must give exactly its row.

usage: real_sets.py PLANUM DATA_FOLDER; says SKIPPED by name where the data are absent.
"""
import glob
import json
import os
import subprocess
import sys
import tempfile

# README's columns in order, as keys of --stats; None: not a count of ours ("to remove" is an upper bound).
COLUMNS = ["units", "orders", "same_as", "contemporary", "self", "mutual", "merged", "cycle_groups",
           "largest_cycle_group", "orders_in_cycles", None, "redundant", "reduced_from", "depth", "isolated"]


def rows_of(readme):
    rows = []
    with open(readme, encoding="utf-8") as text:
        for line in text:
            cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
            if line.startswith("|") and len(cells) == len(COLUMNS) + 1 and cells[1].isdigit():
                rows.append((cells[0], [int(cell) for cell in cells[1:]]))
    return rows


def files_of(folder, name):
    if name.startswith("hm/") or name == "hmc/ulm-eggingen":
        return sorted(f for f in glob.glob(os.path.join(folder, name, "*")) if "cessford" not in f)
    if name.startswith("pyarchinit/alkhutm"):
        return [os.path.join(folder, "pyarchinit", f) for f in
                ("alkhutm_us_senza_periodo.csv", "alkhutm_us_con_periodo_FINALE.csv")]
    if "…" in name:
        before, after = name.split("…")
        return glob.glob(os.path.join(folder, before + "*" + after))
    return [os.path.join(folder, name)]


def main():
    planum, data = sys.argv[1], os.path.join(sys.argv[2], "matrix")
    if not os.path.exists(os.path.join(data, "README.md")):
        print("SKIPPED, real data absent: matrix/README.md")
        return 0
    failed = passed = 0
    for name, expected in rows_of(os.path.join(data, "README.md")):
        with tempfile.TemporaryDirectory() as work:
            site = os.path.join(work, "s.gpkg")
            for arguments in (["new", site], ["import", site, *files_of(data, name)]):
                done = subprocess.run([planum, *arguments], capture_output=True, check=False)
                if done.returncode != 0:
                    print("FAILED", name, done.stderr.decode())
            done = subprocess.run([planum, "matrix", site, "--stats", "--json"], capture_output=True, check=False)
            stats = json.loads(done.stdout or b"{}")
        wrong = ["%s %s, not %s" % (key, stats.get(key), value)
                 for key, value in zip(COLUMNS, expected) if key is not None and stats.get(key) != value]
        print("%s %s %s" % ("FAILED" if wrong else "ok", name, "; ".join(wrong)))
        failed += bool(wrong)
        passed += not wrong
    print("%d passed, %d failed" % (passed, failed))
    return 1 if failed or not passed else 0


sys.exit(main())
