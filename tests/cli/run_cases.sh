#!/usr/bin/env bash
# Runs every .case file of this folder: exact text, empty directory, bare environment.
#
# A case is a shell script with expectations. Lines starting with "$ " are commands; the lines up to the
# next command are what it must print (stdout and stderr together), `[N]` alone on a line the exit status
# when it is not 0. `{ANY}` in an expected line stands for any text on that line. Lines starting with
# `##` are comments. UPDATE=1 rewrites what differs; read the difference before you commit it.
set -u
program=$(readlink -f "$1")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
failed=0
passed=0
for case in "$here"/*.case; do
  work=$(mktemp -d)
  if env -i PATH="$(dirname "$program"):/usr/bin:/bin" HOME="$work" LC_ALL=C PLANUM_AUTHOR=tester ASAN_OPTIONS="${ASAN_OPTIONS:-}" QT_QPA_PLATFORM=offscreen CASE_DATA="$here/data" UPDATE="${UPDATE:-0}" \
      python3 "$here/run_case.py" "$case" "$work"; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
  fi
  rm -rf "$work"
done
echo "cases: $passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
