#!/usr/bin/env bash
# ./dev demo [DIR] [options of planum demo]: makes a sample dig and runs the whole job on it.
set -euo pipefail
planum=$1
shift
target=demo-dig
if [ $# -gt 0 ] && [ "${1#-}" = "$1" ]; then
  target=$1
  shift
elif [ -e "$target" ]; then
  target=$(mktemp -d -u demo-dig-XXXX)
fi
"$planum" demo "$target" "$@"
