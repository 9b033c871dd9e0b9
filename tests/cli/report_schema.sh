#!/usr/bin/env bash
# The XML report holds to its schema, for an empty project and for one with problems of every kind.
set -eu
planum=$(readlink -f "$1")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
schema=$here/../../schema/xsd/planum-report-1.xsd
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
"$planum" new -q empty.gpkg
"$planum" report -q empty.gpkg -o empty.xml
xmllint --noout --schema "$schema" empty.xml
"$planum" new -q site.gpkg --name 'Hill & <Farm>'
"$planum" import -q site.gpkg "$here/data/units.csv" "$here/data/relations.csv" >/dev/null
"$planum" relation add -q site.gpkg 5 covers 1 >/dev/null
"$planum" period add -q site.gpkg II --from -300 --to 10 >/dev/null
"$planum" phase add -q site.gpkg I --period II --title "first & last" >/dev/null
"$planum" unit set -q site.gpkg 2 --phase I --colour "brown <dark>" --description $'two\nlines'
"$planum" find add -q site.gpkg F1 --unit 2 --z 9.9 --type sherd >/dev/null
"$planum" dating add -q site.gpkg C14-1 --unit 2 --kind radiocarbon --bp 2100 --bp-error 30 >/dev/null
"$planum" sample add -q site.gpkg S1 --unit 2 --type soil >/dev/null
"$planum" document add -q site.gpkg P1 --unit 2 --type photo >/dev/null
"$planum" group add -q site.gpkg G1 --members "2, 3" >/dev/null
printf '%s' '{"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"unit": "2", "day": "2025-06-03"},
 "geometry": {"type": "Polygon", "coordinates": [[[0, 0, 9], [2, 0, 9], [2, 2, 9], [0, 2, 9], [0, 0, 9]],
 [[0.5, 0.5, 9], [0.5, 1, 9], [1, 1, 9], [1, 0.5, 9], [0.5, 0.5, 9]]]}}]}' >outlines.geojson
"$planum" region import -q site.gpkg outlines.geojson >/dev/null
"$planum" interpretation add -q site.gpkg other --adds "1 later 4" >/dev/null
id=$("$planum" check site.gpkg --json | python3 -c 'import json,sys; print(json.load(sys.stdin)["problems"][0]["id"])')
"$planum" check -q site.gpkg --accept "$id" --because "seen in the section"
"$planum" report -q site.gpkg -o site.xml
xmllint --noout --schema "$schema" site.xml
grep -q 'state="accepted"' site.xml
grep -q '<hole>' site.xml
grep -q '<added subject=' site.xml
"$planum" unit set -q site.gpkg 2 --excavated-on 2025-06-03
"$planum" report -q site.gpkg -o day.xml --day 2025-06-03
xmllint --noout --schema "$schema" day.xml
test "$(grep -c 'of-day="true"' day.xml)" = 1
grep -q 'day="2025-06-03"' day.xml
"$planum" report -q site.gpkg -o day.html --day 2025-06-03
grep -q 'The day' day.html
status=0
"$planum" report -q site.gpkg -o none.xml --day 2025-06-02 2>message || status=$?
test $status = 3
grep -q 'the first day with something is 2025-06-03' message
test ! -e none.xml
"$planum" report -q site.gpkg -o site.html
xmllint --noout --html site.html 2>&1 | grep -v 'Tag \(svg\|title\|desc\|g\|path\|rect\|text\|style\|line\|polygon\|polyline\|circle\|a\|defs\|section\|tspan\) invalid\|^ *^\|^ *<' | head -5
echo "1 passed, 0 failed"
