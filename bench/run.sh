#!/usr/bin/env bash
# Runs the benches in a folder, or the ones named: ./dev bench [matrix|…] [arguments of that bench].
set -u
bin=$1
shift
if [ $# -gt 0 ]; then
  name=$1
  shift
  exec "$bin/bench_$name" "$@"
fi
for bench in "$bin"/bench_*; do
  echo "== $(basename "$bench")"
  "$bench" || exit 1
done
