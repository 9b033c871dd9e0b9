#!/usr/bin/env bash
# Runs every fuzz target in a folder for S seconds from its seeds, in a scratch folder, so that the
# repository's corpus stays as it is. Prints one line a target; fails when one finds something.
set -u
bin=$1
seconds=${2:-60}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
failed=0
passed=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
run_one() {
  local target=$1 name=$2
  mkdir -p "$work/$name/found" "$work/$name/tmp"
  local seeds=()
  [ -d "$here/corpus/$name" ] && seeds=("$here/corpus/$name")
  (cd "$work/$name" && TMPDIR="$work/$name/tmp" ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 \
    "$target" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=3000 -max_len=65536 -print_final_stats=1 \
    "$work/$name/found" "${seeds[@]}" >"$work/$name/log" 2>&1)
}
for target in "$bin"/fuzz_*; do
  [ -x "$target" ] || continue
  name=$(basename "$target" | sed 's/^fuzz_//')
  if run_one "$(readlink -f "$target")" "$name"; then
    runs=$(grep -oE 'number_of_executed_units: *[0-9]+' "$work/$name/log" | grep -oE '[0-9]+$')
    echo "fuzz $name: clean, $runs runs"
    passed=$((passed + 1))
  else
    echo "fuzz $name: FAILED"
    tail -60 "$work/$name/log"
    failed=$((failed + 1))
  fi
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
