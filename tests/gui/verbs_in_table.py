#!/usr/bin/env python3
"""Every command of planum stands in the table of docs/desktop.md, and the table names none that there is not.

verbs_in_table.py PLANUM DESKTOP.md
"""
import re
import subprocess
import sys

planum, page = sys.argv[1:3]
text = subprocess.run([planum, "--help"], check=True, capture_output=True, text=True).stdout
listed = text.split("Subcommands:\n", 1)[1].split("\n\n", 1)[0]
there = {line.split()[0] for line in listed.splitlines() if line.startswith("  ") and line[2] != " "}
rows = [line for line in open(page, encoding="utf-8") if line.startswith("| `planum ")]
named = set(re.findall(r"`planum ([a-z-]+)`", "".join(row.split("|")[1] for row in rows)))
empty = [row.strip() for row in rows if not row.split("|")[2].strip()]
trouble = [f"planum {verb} is not in the table" for verb in sorted(there - named)]
trouble += [f"the table names planum {verb}, which there is not" for verb in sorted(named - there)]
trouble += [f"says nothing: {row}" for row in empty]
print("\n".join(trouble) or f"{len(named)} commands stand in the table")
sys.exit(1 if trouble else 0)
