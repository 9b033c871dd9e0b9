#!/usr/bin/env python3
"""Runs one .case file (see run_cases.sh) in the folder given; UPDATE=1 in the caller rewrites it."""
import os
import re
import subprocess
import sys


def matches(expected, actual):
    if "{ANY}" not in expected:
        return expected == actual
    return re.fullmatch(".*".join(re.escape(p) for p in expected.split("{ANY}")), actual) is not None


def matches_all(expected, actual):
    return len(expected) == len(actual) and all(map(matches, expected, actual))


def main():
    case, work = sys.argv[1], sys.argv[2]
    steps, comments = [], []  # a step: the comments before it, its command, what it must print
    with open(case, encoding="utf-8") as lines:
        for line in lines.read().splitlines():
            if line.startswith("##"):
                comments.append(line)
            elif line.startswith("$ "):
                steps.append((comments, line[2:], []))
                comments = []
            elif steps:
                steps[-1][2].append(line)
    good = True
    rewritten = []
    for before, command, expected in steps:
        rewritten += before
        run = subprocess.run(["/bin/bash", "-c", command], cwd=work, stdin=subprocess.DEVNULL,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False, timeout=300)
        actual = run.stdout.decode("utf-8", "replace").splitlines()
        if run.returncode != 0:
            actual.append("[%d]" % run.returncode)
        while expected and expected[-1] == "":
            expected = expected[:-1]
        while actual and actual[-1] == "":
            actual = actual[:-1]
        rewritten += ["$ " + command] + (expected if matches_all(expected, actual) else actual)
        if not matches_all(expected, actual):
            good = False
            print("FAILED %s\n$ %s" % (os.path.basename(case), command))
            print("  expected:\n    " + "\n    ".join(expected))
            print("  printed:\n    " + "\n    ".join(actual))
    if os.environ.get("UPDATE") == "1":
        with open(case, "w", encoding="utf-8") as out:
            out.write("\n".join(rewritten) + "\n")
        return 0
    return 0 if good and steps else 1


sys.exit(main())
