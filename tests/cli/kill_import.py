#!/usr/bin/env python3
"""kill -9 in the middle of an import, many times: what was acknowledged is there, the file is whole.

usage: kill_import.py PLANUM ROUNDS [SEED]

Each round imports a further list into the same project and kills the program after a random time. An
import that ended with exit status 0 is acknowledged: all its units must be there for ever after. One that was
killed must have left all or nothing.
"""
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time

UNITS = 1500


def planum(program, *arguments):
    return subprocess.run([program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)


def units_of(program, site):
    answer = planum(program, "info", site, "--json")
    if answer.returncode != 0:
        sys.exit("after a kill the project does not open: " + answer.stderr.decode())
    return json.loads(answer.stdout)["units"]


def write_list(folder, number):
    path = os.path.join(folder, "list%d.csv" % number)
    with open(path, "w", encoding="utf-8") as out:
        out.write("unit,kind,title\n")
        for i in range(UNITS):
            out.write("%d-%d,layer,unit of list %d\n" % (number, i, number))
    return path


def main():
    program, rounds = sys.argv[1], int(sys.argv[2])
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else int(time.time())
    print("seed", seed)
    dice = random.Random(seed)
    with tempfile.TemporaryDirectory() as folder:
        site = os.path.join(folder, "site.gpkg")
        planum(program, "new", site)
        trial = os.path.join(folder, "trial.gpkg")
        planum(program, "new", trial)
        began = time.time()
        planum(program, "import", trial, write_list(folder, 0))
        whole = time.time() - began
        acknowledged, killed, kept = 0, 0, 0
        for number in range(1, rounds + 1):
            listing = write_list(folder, number)
            process = subprocess.Popen([program, "import", site, listing, "-q"], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
            try:
                process.wait(timeout=dice.uniform(0.0, 1.3 * whole))
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGKILL)
                process.wait()
            there = units_of(program, site)
            if process.returncode == 0:
                acknowledged += UNITS
                if there != acknowledged:
                    sys.exit("round %d: %d units acknowledged, %d there" % (number, acknowledged, there))
            else:
                killed += 1
                if there == acknowledged + UNITS:  # killed after the commit, before the answer
                    acknowledged = there
                    kept += 1
                elif there != acknowledged:
                    sys.exit("round %d: killed, %d units there, neither %d nor %d" %
                             (number, there, acknowledged, acknowledged + UNITS))
            os.remove(listing)
        problems = json.loads(planum(program, "verify", site, "--json").stdout)["problems"]
        if problems:
            sys.exit("verify: %s" % problems[:3])
        if killed == 0:
            sys.exit("no import was ever killed: the test tests nothing")
        print("%d rounds, %d killed (%d after their commit), %d units acknowledged and there" %
              (rounds, killed, kept, acknowledged))


main()
