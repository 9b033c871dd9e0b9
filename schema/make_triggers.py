#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes schema/sql/0001_triggers.sql from the tables of 0001_record.sql.

Run once while schema version 1 was made; a released migration is frozen, so later versions bring their
own file. Plain built-in SQL only: QGIS and every other program must be able to run these triggers.
"""
import pathlib
import sqlite3

HERE = pathlib.Path(__file__).parent / "sql"

RANDOM_UUID = (
    "lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||\n"
    "      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))"
)
UUID_PATTERN = "-".join("[0-9a-f]" * length for length in (8, 4, 4, 4, 12))
NOW = "strftime('%Y-%m-%dT%H:%M:%fZ','now')"
LOG_COLUMNS = "made_at, author, action, table_name, record"
LOG_SOURCE = f"\n    coalesce(c.made_at, {NOW}), coalesce(c.author, 'outside Planum')"

# What loses its meaning with the record it belongs to and is marked together with it.
TAKEN_ALONG = {
    "unit": [("relation", "subject"), ("relation", "object"), ("group_member", "unit"), ("level", "unit"),
             ("dating", "unit"), ("interpretation_added", "subject"), ("interpretation_added", "object")],
    "relation": [("relation_statement", "relation")],
    "unit_group": [("group_member", "unit_group")],
    "scan": [("scan_pose", "scan")],
    "interpretation": [("interpretation_added", "interpretation"), ("interpretation_dropped", "interpretation")],
}


def record_tables(db):
    names = [row[0] for row in db.execute("SELECT name FROM sqlite_master WHERE type='table' ORDER BY rowid")]
    for name in names:
        columns = [(row[1], row[2]) for row in db.execute(f"PRAGMA table_info({name})")]
        if any(column == "uuid" for column, _ in columns):
            yield name, columns


def changed_value(row, column, kind):
    if kind in ("POINT", "LINESTRING", "MULTIPOLYGON"):
        return f"CASE WHEN OLD.{column} IS NOT NEW.{column} THEN lower(hex({row}.{column})) END"
    return f"{row}.{column}"


def marks(table, uuid, time):
    for child, column in TAKEN_ALONG.get(table, []):
        yield f"  UPDATE {child} SET deleted_at = {time} WHERE {column} = {uuid} AND deleted_at IS NULL;\n"


def check_references(references):
    """GDAL switches foreign keys off, so what they say is said again for programs other than Planum."""
    for column, parent in references:
        yield (f"  SELECT RAISE(ABORT, '{column}: there is no such {parent}') WHERE NEW.{column} IS NOT NULL\n"
               f"    AND NOT EXISTS (SELECT 1 FROM {parent} WHERE uuid = NEW.{column});\n")


def insert_triggers(table, references):
    # Planum gives uuids itself and logs its inserts many at a time: a trigger that only finds out that it has
    # nothing to do saves a fifth of an import.
    yield (f"CREATE TRIGGER {table}_inserted AFTER INSERT ON {table}\n"
           f"  WHEN (SELECT change FROM planum_context) IS NULL BEGIN\n"
           f"  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')\n"
           f"    WHERE NEW.uuid NOT GLOB '{UUID_PATTERN}';\n"
           + "".join(check_references(references)) +
           f"  UPDATE {table} SET uuid = {RANDOM_UUID}\n    WHERE fid = NEW.fid AND uuid IS NULL;\n"
           f"  INSERT INTO planum_log({LOG_COLUMNS}) SELECT{LOG_SOURCE},\n"
           f"    'insert', '{table}', (SELECT uuid FROM {table} WHERE fid = NEW.fid) FROM planum_context c\n"
           f"    WHERE NEW.deleted_at IS NULL;\n"
           f"END;\n")


def update_triggers(table, fields, references):
    names = ", ".join(name for name, _ in fields)
    rows = "\n    UNION ALL ".join(
        f"SELECT '{name}'{' AS field' if i == 0 else ''}, {changed_value('OLD', name, kind)}"
        f"{' AS was' if i == 0 else ''}, {changed_value('NEW', name, kind)}{' AS is_now' if i == 0 else ''}"
        for i, (name, kind) in enumerate(fields))
    yield (f"CREATE TRIGGER {table}_uuid_stays BEFORE UPDATE OF uuid ON {table}\n"
           f"  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN\n"
           f"  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');\n"
           f"END;\n")
    if references:
        yield (f"CREATE TRIGGER {table}_refers AFTER UPDATE OF {', '.join(c for c, _ in references)} ON {table}\n"
               f"  WHEN (SELECT change FROM planum_context) IS NULL BEGIN\n"
               + "".join(check_references(references)) + "END;\n")
    yield (f"CREATE TRIGGER {table}_changed AFTER UPDATE OF {names} ON {table} BEGIN\n"
           f"  INSERT INTO planum_log({LOG_COLUMNS}, field, old_value, new_value, change) SELECT{LOG_SOURCE},\n"
           f"    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'\n"
           f"      ELSE 'delete' END,\n"
           f"    '{table}', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (\n"
           f"    {rows}) f\n"
           f"    WHERE f.was IS NOT f.is_now;\n"
           f"END;\n")


def delete_triggers(table, fields):
    kept = [name for name, _ in fields if name != "deleted_at"]
    time = f"coalesce((SELECT made_at FROM planum_context), {NOW})"
    yield (f"CREATE TRIGGER {table}_deleted AFTER DELETE ON {table} BEGIN\n"
           f"  INSERT INTO {table}(fid, uuid, {', '.join(kept)}, deleted_at)\n"
           f"    VALUES (OLD.fid, OLD.uuid, {', '.join('OLD.' + name for name in kept)},\n"
           f"    coalesce(OLD.deleted_at, {time}));\n"
           f"  INSERT INTO planum_log({LOG_COLUMNS}, field, change) SELECT{LOG_SOURCE},\n"
           f"    'delete', '{table}', OLD.uuid, 'deleted_at', c.change FROM planum_context c\n"
           f"    WHERE OLD.deleted_at IS NULL;\n"
           + "".join(marks(table, "OLD.uuid", time)) + "END;\n")
    if table in TAKEN_ALONG:
        yield (f"CREATE TRIGGER {table}_takes_along AFTER UPDATE OF deleted_at ON {table}\n"
               f"  WHEN OLD.deleted_at IS NULL AND NEW.deleted_at IS NOT NULL BEGIN\n"
               + "".join(marks(table, "NEW.uuid", "NEW.deleted_at")) + "END;\n")


RULES = """-- One series of unit numbers for the whole site, unless the project says so an area.
CREATE TRIGGER unit_number_inserted BEFORE INSERT ON unit
  WHEN NEW.deleted_at IS NULL AND (SELECT numbers FROM project LIMIT 1) = 'site' BEGIN
  SELECT RAISE(ABORT, 'number already used') FROM unit WHERE number = NEW.number AND deleted_at IS NULL;
END;
CREATE TRIGGER unit_number_changed BEFORE UPDATE OF number, deleted_at ON unit
  WHEN NEW.deleted_at IS NULL AND (SELECT numbers FROM project LIMIT 1) = 'site' BEGIN
  SELECT RAISE(ABORT, 'number already used') FROM unit
    WHERE number = NEW.number AND deleted_at IS NULL AND fid <> OLD.fid;
END;
CREATE TRIGGER project_numbers_changed BEFORE UPDATE OF numbers ON project
  WHEN NEW.numbers = 'site' AND OLD.numbers <> 'site' BEGIN
  SELECT RAISE(ABORT, 'some unit numbers are used in several areas: numbers stay unique per area')
    WHERE EXISTS (SELECT 1 FROM unit WHERE deleted_at IS NULL GROUP BY number HAVING count(*) > 1);
END;
CREATE TRIGGER project_stays BEFORE DELETE ON project BEGIN
  SELECT RAISE(ABORT, 'the project itself cannot be deleted');
END;
CREATE TRIGGER project_is_one BEFORE INSERT ON project WHEN EXISTS (SELECT 1 FROM project) BEGIN
  SELECT RAISE(ABORT, 'a file holds one project');
END;
CREATE TRIGGER planum_context_stays BEFORE DELETE ON planum_context BEGIN
  SELECT RAISE(ABORT, 'this row is needed by the log');
END;
CREATE TRIGGER planum_log_stays BEFORE DELETE ON planum_log BEGIN
  SELECT RAISE(ABORT, 'the log cannot be changed');
END;
CREATE TRIGGER planum_log_unchanged BEFORE UPDATE ON planum_log BEGIN
  SELECT RAISE(ABORT, 'the log cannot be changed');
END;
"""


def main():
    db = sqlite3.connect(":memory:")
    for name in ("0001_geopackage.sql", "0001_record.sql"):
        db.executescript((HERE / name).read_text(encoding="utf-8"))
    parts = ["-- Made by schema/make_triggers.py; frozen with schema version 1.\n", RULES]
    for table, columns in record_tables(db):
        fields = [(name, kind) for name, kind in columns if name not in ("fid", "uuid")]
        references = sorted((row[3], row[2]) for row in db.execute(f"PRAGMA foreign_key_list({table})"))
        parts.extend(insert_triggers(table, references))
        parts.extend(update_triggers(table, fields, references))
        if table != "project":
            parts.extend(delete_triggers(table, fields))
    text = "".join(parts)
    db.executescript(text)
    (HERE / "0001_triggers.sql").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
