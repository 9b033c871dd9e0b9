#!/usr/bin/env bash
# Every --json output holds to its schema in schema/json/.
set -u
planum=$(readlink -f "$1")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
schemas=$here/../../schema/json
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failed=0
passed=0
holds() {
  local schema=$1
  shift
  if "$planum" "$@" --json >out.json 2>err.txt; [ $? -gt 1 ]; then
    echo "FAILED planum $*: $(cat err.txt)"
    failed=$((failed + 1))
  elif ! python3 "$here/../support/validate_json.py" "$schemas/$schema.schema.json" <out.json; then
    echo "FAILED planum $* against $schema"
    failed=$((failed + 1))
  else
    passed=$((passed + 1))
  fi
}
"$planum" new -q site.gpkg
holds import import site.gpkg "$here/data/units.csv" "$here/data/relations.csv"
holds import import site.gpkg "$here/data/tomorrow.csv" --dry-run
"$planum" relation add -q site.gpkg 5 covers 1 >/dev/null
"$planum" relation add -q site.gpkg 2 same_as 4 >/dev/null
"$planum" phase add -q site.gpkg I --from -200 --to -100 >/dev/null
"$planum" interpretation add -q site.gpkg Ada --adds "3 later 2" >/dev/null
"$planum" find add -q site.gpkg F1 --unit 2 --z 9.9 >/dev/null
holds matrix-stats matrix site.gpkg --stats
holds matrix matrix site.gpkg -o m.svg
holds matrix matrix site.gpkg -o m.pdf --paper a4 --paging poster
holds export matrix site.gpkg -o m.dot
holds export export site.gpkg -o m.csv
holds check check site.gpkg
holds info info site.gpkg
holds history history site.gpkg
holds history history site.gpkg --unit 4
holds verify verify site.gpkg
holds today today site.gpkg
holds record-show unit show site.gpkg 2
mkdir -p 2025-06-01 && printf '1 2 3\n4 5 6\n' >2025-06-01/station1.xyz
holds scan-add scan add site.gpkg 2025-06-01
holds scan-add scan add site.gpkg 2025-06-01
holds scan-list scan list site.gpkg
holds scan-show scan show site.gpkg 2025-06-01/station1
holds panorama panorama site.gpkg 2025-06-01/station1 -o panorama.png --width 40
holds demo demo dig --seed 3
holds suggest suggest dig/demo.gpkg
# The sample dig proposes relations; one of them taken the wrong way round is a height contradiction.
clash=$("$planum" suggest dig/demo.gpkg --json | python3 -c "import json,sys; s=[s for s in json.load(sys.stdin)['suggestions'] if s['type']=='relation' and s['area_m2'] > 0.2][0]; print(s['other'], 'covers', s['unit'])")
"$planum" relation add -q dig/demo.gpkg "$clash" >/dev/null
clash=$("$planum" check dig/demo.gpkg --json | python3 -c "import json,sys; print([p['id'] for p in json.load(sys.stdin)['problems'] if p['code']=='height-contradiction'][0])")
holds check-show check dig/demo.gpkg --show "$clash" -o clash.png
holds region-import region import site.gpkg "$here/data/outlines.geojson" --dry-run
holds region-import region import site.gpkg "$here/data/outlines.geojson" --create-units
holds region-list region list site.gpkg
holds region-patches region patches site.gpkg --all
holds record-show region show site.gpkg 2025-06-01/1
holds register register site.gpkg
printf 'scan,marker,x,y,z\nsite,M1,0,0,0\nsite,M2,5,0,0\nsite,M3,0,5,0\n' >markers.csv
printf '2025-06-01/station1,M1,1,0,0\n2025-06-01/station1,M2,6,0,0\n2025-06-01/station1,M3,1,5,0\n' >>markers.csv
holds markers-import markers import site.gpkg markers.csv
holds register register site.gpkg --method markers
holds register-compare register site.gpkg --compare 1 2
holds scan-list scan list site.gpkg
holds scan-show scan show site.gpkg 2025-06-01/station1
holds surface surface site.gpkg 2025-06-01 --cell 0.5 -o heights.tif
mkdir -p 2025-06-02 && printf '1 2 2\n4 5 6\n' >2025-06-02/station1.xyz && "$planum" scan add -q site.gpkg 2025-06-02 >/dev/null
sed 's/2025-06-01/2025-06-02/' markers.csv >other.csv && "$planum" markers import -q site.gpkg other.csv >/dev/null
"$planum" register -q site.gpkg --method markers >/dev/null
holds surface-change surface site.gpkg 2025-06-02 --since 2025-06-01 --cell 0.5 -o change.tif
holds surface-volumes surface site.gpkg --volumes --cell 0.5
holds section section site.gpkg --from 0,2 --to 9,2 -o section.png --depth 1
holds plan plan site.gpkg --surface 2025-06-01 -o plan.png --cell 0.1
holds survey-import survey import site.gpkg "$here/data/station.csv"
holds suggest suggest site.gpkg
holds find-assign find assign site.gpkg
holds find-assign find assign site.gpkg --apply
holds interpretation-diff interpretation diff site.gpkg record record
for kind in unit relation phase period group dating find level sample document area surface interpretation; do
  holds record-list "$kind" list site.gpkg
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
