#!/usr/bin/env bash
# A flight from the command line: numbered frames of the size that was asked for, and what is wrong is said with the
# exit status of its kind: flight.sh PLANUM PLANUM-DESKTOP SCHEMAS
set -euo pipefail
planum=$1
desktop=$2
schemas=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"$planum" new site.gpkg --quiet
mkdir 2025-06-01
for i in $(seq 0 59); do for j in $(seq 0 59); do echo "0.0$i 0.0$j 0.00$((i % 7))"; done; done >2025-06-01/s.xyz
"$planum" scan add site.gpkg 2025-06-01 --quiet >/dev/null

cat >cameras.json <<'JSON'
{"format": "planum-flight", "version": 1, "cameras": [
  {"target": [100.05, 200.05, 50], "distance": 0.3}, {"target": [100.05, 200.05, 50], "distance": 0.2, "yaw_deg": 0}]}
JSON
python3 "$here/../support/validate_json.py" "$schemas/flight.schema.json" <cameras.json

# refused STATUS WORDS ARGUMENT...
refused() {
  local wanted=$1 words=$2 status=0
  shift 2
  "$desktop" "$@" >said.txt 2>&1 || status=$?
  if [ "$status" != "$wanted" ] || ! grep -qF -- "$words" said.txt; then
    echo "planum-desktop $*: status $status instead of $wanted, or not \"$words\": $(cat said.txt)"
    exit 1
  fi
}
refused 2 "--flight wants" --flight cameras.json site.gpkg
refused 2 "frames: between" --flight cameras.json -o out --frames 0 site.gpkg
refused 2 "colour: mauve" --flight cameras.json -o out --colour mauve site.gpkg
refused 2 "belongs to --flight" --frames 3 site.gpkg
refused 2 "--colour belongs to" --colour height --screenshot plan -o out site.gpkg
refused 2 "not both" --flight cameras.json --screenshot plan -o out site.gpkg
refused 3 "gone.json" --flight gone.json -o out site.gpkg
echo '{"format": "planum-flight", "version": 1, "cameras": [{}]}' >wrong.json
refused 3 "wrong.json: camera 1: target" --flight wrong.json -o out site.gpkg
echo '{"format": "planum-flight", "version": 1, "cameras": []}' >none.json
refused 3 "no cameras" --flight none.json -o out site.gpkg
refused 3 "gone.gpkg" --flight cameras.json -o out gone.gpkg
refused 4 "needs a display" --flight cameras.json -o out site.gpkg
test ! -e out

fly() { xvfb-run -a -s "-screen 0 1280x1024x24" env QT_QPA_PLATFORM=xcb "$desktop" "$@"; }
status=0
fly --flight cameras.json -o out site.gpkg 2>said.txt || status=$?
test "$status" = 3 && grep -qF "on the site grid" said.txt
printf '%s\n' scan,marker,x,y,z site,M1,100,200,50 site,M2,105,200,50 site,M3,100,205,51 site,M4,105,206,52 \
  2025-06-01/s,M1,0,0,0 2025-06-01/s,M2,5,0,0 2025-06-01/s,M3,0,5,1 2025-06-01/s,M4,5,6,2 >markers.csv
"$planum" markers import site.gpkg markers.csv --quiet >/dev/null
"$planum" register site.gpkg --quiet >/dev/null
before=$(cat site.gpkg | md5sum)
fly --flight cameras.json -o out --frames 2 --size 320x200 --colour height site.gpkg
python3 - out <<'PY'
import pathlib, struct, sys
frames = sorted(pathlib.Path(sys.argv[1]).iterdir())
assert [f.name for f in frames] == ["fly-0001.png", "fly-0002.png", "fly-0003.png"], frames
contents = [f.read_bytes() for f in frames]
for content in contents:
    assert struct.unpack(">II", content[16:24]) == (320, 200), struct.unpack(">II", content[16:24])
    assert len(content) > 1000, "an empty picture"
assert len(set(contents)) == 3
PY
test "$before" = "$(cat site.gpkg | md5sum)"
status=0
fly --flight cameras.json -o out --surface 2030-01-01 site.gpkg 2>said.txt || status=$?
test "$status" = 3 && grep -qF "no surface 2030-01-01; there are 2025-06-01" said.txt
echo x >file
status=0
fly --flight cameras.json -o file/out site.gpkg 2>said.txt || status=$?
test "$status" = 4
