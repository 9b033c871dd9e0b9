# SPDX-License-Identifier: MIT
"""Edits a project through GDAL as QGIS does, and prints what happened, one line a step.

Exit status 77: GDAL's Python modules are not installed."""
import sys

try:
    from osgeo import gdal, ogr
except ImportError:
    sys.exit(77)

gdal.UseExceptions()
ogr.UseExceptions()
warnings = []
gdal.PushErrorHandler(lambda kind, code, text: warnings.append(text))


def step(name, work):
    try:
        print(f"{name}: {work()}")
    except RuntimeError as error:
        print(f"{name}: refused: {error}")


def add(layer, **fields):
    feature = ogr.Feature(layer.GetLayerDefn())
    for name, value in fields.items():
        if name == "wkt":
            feature.SetGeometry(ogr.CreateGeometryFromWkt(value))
        else:
            feature[name] = value
    layer.CreateFeature(feature)
    return "done"


def change(layer, condition, **fields):
    layer.SetAttributeFilter(condition)
    for feature in layer:
        for name, value in fields.items():
            feature[name] = value
        layer.SetFeature(feature)
    layer.SetAttributeFilter(None)
    return "done"


def delete(layer, condition):
    layer.SetAttributeFilter(condition)
    for fid in [feature.GetFID() for feature in layer]:
        layer.DeleteFeature(fid)
    layer.SetAttributeFilter(None)
    return "done"


def read_everything(path):
    """What ogrinfo does: every layer, every feature, read-only."""
    warnings.clear()
    dataset = gdal.OpenEx(path, gdal.OF_VECTOR)
    layers = [dataset.GetLayer(i) for i in range(dataset.GetLayerCount())]
    features = sum(1 for layer in layers for _ in layer)
    return f"{len(layers)} layers, {'some' if features else 'no'} features, {len(warnings)} warnings {warnings or ''}"


def main(path):
    step("read", lambda: read_everything(path))
    dataset = gdal.OpenEx(path, gdal.OF_VECTOR | gdal.OF_UPDATE)
    unit, region, level = (dataset.GetLayerByName(name) for name in ("unit", "region", "level"))
    step("open for changing", lambda: f"{len(warnings)} warnings {warnings or ''}")
    unit_id = next(iter(unit))["uuid"]
    step("insert unit", lambda: add(unit, number="900", kind="cut"))
    step("insert unit without kind", lambda: add(unit, number="901"))
    step("insert region", lambda: add(region, unit=unit_id, drawn_on="plan", wkt="MULTIPOLYGON Z (((0 0 1, 1 0 1, 1 1 1, 0 0 1)))"))
    step("insert level", lambda: add(level, unit=unit_id, z=101.5, wkt="POINT Z (1 2 101.5)"))
    step("change", lambda: change(unit, "number = '900'", title="ditch"))
    step("bad kind", lambda: add(unit, number="902", kind="hole"))
    step("bad key", lambda: add(unit, number="903", area="00000000-0000-0000-0000-000000000000"))
    step("bad height", lambda: add(level, unit=unit_id, z=1e9))
    step("bad uuid", lambda: add(unit, number="904", uuid="X" * 36))
    step("used number", lambda: add(unit, number="900"))
    step("changed uuid", lambda: change(unit, "number = '900'", uuid="00000000-0000-0000-0000-000000000001"))
    step("empty number", lambda: add(unit, number="  "))
    step("emptied number", lambda: change(unit, "number = '900'", number=" "))
    step("bad day", lambda: add(unit, number="905", excavated_on="31.12.2025"))
    step("bad day in a change", lambda: change(unit, "number = '900'", excavated_on="2025-02-30"))
    step("day", lambda: change(unit, "number = '900'", excavated_on="2025-02-28"))
    step("line for a level", lambda: add(level, unit=unit_id, z=1, wkt="LINESTRING Z (1 2 3, 4 5 6)"))
    step("empty level", lambda: add(level, unit=unit_id, z=1, wkt="POINT Z EMPTY"))
    step("flat level", lambda: add(level, unit=unit_id, z=1, wkt="POINT (1 2)"))
    relation = dataset.GetLayerByName("relation")
    ends = {}
    for feature in relation:
        ends[feature["kind"]] = (feature["subject"], feature["object"])
    for kind, (subject, other) in sorted(ends.items()):
        step(f"{kind} twice", lambda: add(relation, subject=subject, kind=kind, object=other))
    step("contemporary", lambda: add(relation, subject=subject, kind="contemporary", object=other))
    step("contemporary the other way round", lambda: add(relation, subject=other, kind="contemporary", object=subject))
    step("delete contemporary", lambda: delete(relation, "kind = 'contemporary'"))
    step("delete change", lambda: delete(dataset.GetLayerByName("planum_change"), None))
    step("delete", lambda: delete(unit, "number = '901'"))
    step("delete referred to", lambda: delete(unit, f"uuid = '{unit_id}'"))
    step("delete project", lambda: delete(dataset.GetLayerByName("project"), None))
    step("delete log", lambda: delete(dataset.GetLayerByName("planum_log"), "fid = 1"))
    step("bad key in a change", lambda: change(unit, "number = '900'", phase="00000000-0000-0000-0000-000000000000"))
    step("index", lambda: "done" if dataset.ExecuteSQL("SELECT CreateSpatialIndex('region', 'geom')") else "nothing")
    dataset = None
    step("read again", lambda: read_everything(path))


if __name__ == "__main__":
    main(sys.argv[1])
