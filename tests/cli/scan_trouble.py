#!/usr/bin/env python3
"""Scans come in while the disk fills up, the user stops, or somebody watches.

usage: scan_trouble.py PLANUM [ROUNDS]

After a full disk or Ctrl-C project and store folder are as before; a wait of over a second says how long it will be.
"""
import hashlib
import os
import pty
import random
import re
import resource
import select
import signal
import subprocess
import sys
import tempfile
import time

COLUMNS, ROWS = 3000, 1000
HEADER = "%d\n%d\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"


def fail(sentence):
    sys.exit("FAILED: " + sentence)


def write_scan(path):
    """Three million points; each column repeats the one before it, 10 m further."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="ascii") as out:
        out.write(HEADER % (COLUMNS, ROWS))
        rows = ["%.4f %.4f 0.5\n" % (0.01 * r, 0.002 * r) for r in range(ROWS)]
        for column in range(COLUMNS):
            x = "%.3f " % (0.01 * column)
            out.write(x + x.join(rows))


def content(folder):
    """Names and hashes of all below a folder."""
    found = {}
    for base, folders, files in os.walk(folder):
        for name in folders:
            found[os.path.relpath(os.path.join(base, name), folder)] = "folder"
        for name in files:
            with open(os.path.join(base, name), "rb") as file:
                found[os.path.relpath(os.path.join(base, name), folder)] = hashlib.sha256(file.read()).hexdigest()
    return found


def expect_as_before(before, folder, when):
    after = content(folder)
    if before != after:
        changed = [name for name in sorted(set(before) | set(after)) if before.get(name) != after.get(name)]
        fail("%s: not as before: %s" % (when, ", ".join(changed)))


def full_disk(program, folder, site, scan, megabytes):
    def small_disk():
        # The program itself must see to it that write() says EFBIG, as it would say ENOSPC, instead of being ended.
        signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
        resource.setrlimit(resource.RLIMIT_FSIZE, (megabytes << 20, megabytes << 20))

    before = content(folder)
    answer = subprocess.run([program, "scan", "add", site, scan], preexec_fn=small_disk, capture_output=True, check=False)
    said = answer.stderr.decode()
    if answer.returncode != 4:
        fail("full at %d MB: exit status %d, not 4: %s" % (megabytes, answer.returncode, said))
    if not re.search(r"cannot be written|writing|temporary", said) or said.count("\n") != 1:
        fail("full at %d MB: no sentence that says what cannot be written: %s" % (megabytes, said))
    expect_as_before(before, folder, "full at %d MB" % megabytes)


def stopped(program, folder, site, scan, after):
    """Whether Ctrl-C came in time."""
    before = content(folder)
    process = subprocess.Popen([program, "scan", "add", site, scan], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    try:
        process.wait(timeout=after)
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGINT)
    said = process.communicate(timeout=60)[1].decode()
    if process.returncode == 0:
        subprocess.run([program, "undo", site, "-q"], check=True, stdout=subprocess.DEVNULL)
        return False
    if process.returncode not in (130, -signal.SIGINT):
        fail("stopped after %.2f s: exit status %d: %s" % (after, process.returncode, said))
    expect_as_before(before, folder, "stopped after %.2f s" % after)
    return True


def watched(program, site, scan):
    """What a terminal shows while a scan comes in on a slow computer: the program may work a fifth of the time."""
    pid, terminal = pty.fork()
    if pid == 0:
        os.execv(program, [program, "scan", "add", site, scan])
    shown = b""
    started = time.monotonic()
    runs, turn = True, started
    while True:
        if select.select([terminal], [], [], 0.01)[0]:
            try:
                piece = os.read(terminal, 65536)
            except OSError:
                break
            if not piece:
                break
            shown += piece
        now = time.monotonic()
        if now - turn > (0.02 if runs else 0.08):
            os.kill(pid, signal.SIGSTOP if runs else signal.SIGCONT)
            runs, turn = not runs, now
    os.kill(pid, signal.SIGCONT)
    took = time.monotonic() - started
    if os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]) != 0:
        fail("on a terminal: " + shown.decode())
    return shown.decode(), took


def main():
    program = os.path.abspath(sys.argv[1])
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 4
    dice = random.Random(1)
    with tempfile.TemporaryDirectory() as folder:
        site, scan = os.path.join(folder, "site.gpkg"), os.path.join(folder, "2025-06-01", "wide.ptx")
        write_scan(scan)
        subprocess.run([program, "new", "-q", site], check=True)
        for megabytes in (1, 12):
            full_disk(program, folder, site, scan, megabytes)
        in_time = sum(stopped(program, folder, site, scan, dice.uniform(0.05, 0.9)) for _ in range(rounds))
        if in_time == 0:
            fail("Ctrl-C never came in time: the test tests nothing")
        shown, took = watched(program, site, scan)
        if "added 2025-06-01/wide" not in shown:
            fail("not added: " + shown)
        if took > 2.0 and "s left" not in shown:
            fail("nothing said how long %.1f s would take: %s" % (took, shown))
        print("disk full, %d of %d times stopped: as before; a terminal was told %s" %
              (in_time, rounds, "how long it takes" if "s left" in shown else "nothing, it took %.1f s" % took))


main()
