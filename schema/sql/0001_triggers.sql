-- Made by schema/make_triggers.py; frozen with schema version 1.
-- One series of unit numbers for the whole site, unless the project says so an area.
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
CREATE TRIGGER project_inserted AFTER INSERT ON project
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  UPDATE project SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'project', (SELECT uuid FROM project WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER project_uuid_stays BEFORE UPDATE OF uuid ON project
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER project_changed AFTER UPDATE OF name, srs_id, tolerance, method, numbers, strictness, deleted_at ON project BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'project', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'name' AS field, OLD.name AS was, NEW.name AS is_now
    UNION ALL SELECT 'srs_id', OLD.srs_id, NEW.srs_id
    UNION ALL SELECT 'tolerance', OLD.tolerance, NEW.tolerance
    UNION ALL SELECT 'method', OLD.method, NEW.method
    UNION ALL SELECT 'numbers', OLD.numbers, NEW.numbers
    UNION ALL SELECT 'strictness', OLD.strictness, NEW.strictness
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER area_inserted AFTER INSERT ON area
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  UPDATE area SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'area', (SELECT uuid FROM area WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER area_uuid_stays BEFORE UPDATE OF uuid ON area
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER area_changed AFTER UPDATE OF name, title, method, first_number, last_number, deleted_at ON area BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'area', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'name' AS field, OLD.name AS was, NEW.name AS is_now
    UNION ALL SELECT 'title', OLD.title, NEW.title
    UNION ALL SELECT 'method', OLD.method, NEW.method
    UNION ALL SELECT 'first_number', OLD.first_number, NEW.first_number
    UNION ALL SELECT 'last_number', OLD.last_number, NEW.last_number
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER area_deleted AFTER DELETE ON area BEGIN
  INSERT INTO area(fid, uuid, name, title, method, first_number, last_number, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.name, OLD.title, OLD.method, OLD.first_number, OLD.last_number,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'area', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
CREATE TRIGGER source_inserted AFTER INSERT ON source
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  UPDATE source SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'source', (SELECT uuid FROM source WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER source_uuid_stays BEFORE UPDATE OF uuid ON source
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER source_changed AFTER UPDATE OF name, format, sha256, imported_at, states_both_sides, deleted_at ON source BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'source', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'name' AS field, OLD.name AS was, NEW.name AS is_now
    UNION ALL SELECT 'format', OLD.format, NEW.format
    UNION ALL SELECT 'sha256', OLD.sha256, NEW.sha256
    UNION ALL SELECT 'imported_at', OLD.imported_at, NEW.imported_at
    UNION ALL SELECT 'states_both_sides', OLD.states_both_sides, NEW.states_both_sides
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER source_deleted AFTER DELETE ON source BEGIN
  INSERT INTO source(fid, uuid, name, format, sha256, imported_at, states_both_sides, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.name, OLD.format, OLD.sha256, OLD.imported_at, OLD.states_both_sides,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'source', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
CREATE TRIGGER import_note_inserted AFTER INSERT ON import_note
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'source: there is no such source') WHERE NEW.source IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM source WHERE uuid = NEW.source);
  UPDATE import_note SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'import_note', (SELECT uuid FROM import_note WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER import_note_uuid_stays BEFORE UPDATE OF uuid ON import_note
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER import_note_refers AFTER UPDATE OF source ON import_note
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'source: there is no such source') WHERE NEW.source IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM source WHERE uuid = NEW.source);
END;
CREATE TRIGGER import_note_changed AFTER UPDATE OF source, line, code, raw_text, message, deleted_at ON import_note BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'import_note', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'source' AS field, OLD.source AS was, NEW.source AS is_now
    UNION ALL SELECT 'line', OLD.line, NEW.line
    UNION ALL SELECT 'code', OLD.code, NEW.code
    UNION ALL SELECT 'raw_text', OLD.raw_text, NEW.raw_text
    UNION ALL SELECT 'message', OLD.message, NEW.message
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER import_note_deleted AFTER DELETE ON import_note BEGIN
  INSERT INTO import_note(fid, uuid, source, line, code, raw_text, message, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.source, OLD.line, OLD.code, OLD.raw_text, OLD.message,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'import_note', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
CREATE TRIGGER period_inserted AFTER INSERT ON period
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  UPDATE period SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'period', (SELECT uuid FROM period WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER period_uuid_stays BEFORE UPDATE OF uuid ON period
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER period_changed AFTER UPDATE OF number, title, description, year_from, year_to, rank, deleted_at ON period BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'period', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'number' AS field, OLD.number AS was, NEW.number AS is_now
    UNION ALL SELECT 'title', OLD.title, NEW.title
    UNION ALL SELECT 'description', OLD.description, NEW.description
    UNION ALL SELECT 'year_from', OLD.year_from, NEW.year_from
    UNION ALL SELECT 'year_to', OLD.year_to, NEW.year_to
    UNION ALL SELECT 'rank', OLD.rank, NEW.rank
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER period_deleted AFTER DELETE ON period BEGIN
  INSERT INTO period(fid, uuid, number, title, description, year_from, year_to, rank, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.number, OLD.title, OLD.description, OLD.year_from, OLD.year_to, OLD.rank,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'period', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
CREATE TRIGGER phase_inserted AFTER INSERT ON phase
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'period: there is no such period') WHERE NEW.period IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM period WHERE uuid = NEW.period);
  UPDATE phase SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'phase', (SELECT uuid FROM phase WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER phase_uuid_stays BEFORE UPDATE OF uuid ON phase
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER phase_refers AFTER UPDATE OF period ON phase
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'period: there is no such period') WHERE NEW.period IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM period WHERE uuid = NEW.period);
END;
CREATE TRIGGER phase_changed AFTER UPDATE OF number, title, description, period, year_from, year_to, rank, deleted_at ON phase BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'phase', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'number' AS field, OLD.number AS was, NEW.number AS is_now
    UNION ALL SELECT 'title', OLD.title, NEW.title
    UNION ALL SELECT 'description', OLD.description, NEW.description
    UNION ALL SELECT 'period', OLD.period, NEW.period
    UNION ALL SELECT 'year_from', OLD.year_from, NEW.year_from
    UNION ALL SELECT 'year_to', OLD.year_to, NEW.year_to
    UNION ALL SELECT 'rank', OLD.rank, NEW.rank
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER phase_deleted AFTER DELETE ON phase BEGIN
  INSERT INTO phase(fid, uuid, number, title, description, period, year_from, year_to, rank, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.number, OLD.title, OLD.description, OLD.period, OLD.year_from, OLD.year_to, OLD.rank,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'phase', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
CREATE TRIGGER unit_inserted AFTER INSERT ON unit
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'area: there is no such area') WHERE NEW.area IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM area WHERE uuid = NEW.area);
  SELECT RAISE(ABORT, 'parent: there is no such unit') WHERE NEW.parent IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.parent);
  SELECT RAISE(ABORT, 'period: there is no such period') WHERE NEW.period IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM period WHERE uuid = NEW.period);
  SELECT RAISE(ABORT, 'phase: there is no such phase') WHERE NEW.phase IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM phase WHERE uuid = NEW.phase);
  UPDATE unit SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'unit', (SELECT uuid FROM unit WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER unit_uuid_stays BEFORE UPDATE OF uuid ON unit
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER unit_refers AFTER UPDATE OF area, parent, period, phase ON unit
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'area: there is no such area') WHERE NEW.area IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM area WHERE uuid = NEW.area);
  SELECT RAISE(ABORT, 'parent: there is no such unit') WHERE NEW.parent IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.parent);
  SELECT RAISE(ABORT, 'period: there is no such period') WHERE NEW.period IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM period WHERE uuid = NEW.period);
  SELECT RAISE(ABORT, 'phase: there is no such phase') WHERE NEW.phase IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM phase WHERE uuid = NEW.phase);
END;
CREATE TRIGGER unit_changed AFTER UPDATE OF number, area, kind, form, status, origin, title, description, interpretation, excavated_from, excavated_on, recorded_by, recorded_on, phase, period, parent, site_code, sector, square, room, position, formation, criteria_of_distinction, mode_of_formation, consistency, colour, munsell, composition, inclusions, organic_components, inorganic_components, thickness, length, width, depth, shape_in_plan, profile, corners, break_of_slope, sides, base, orientation, borders, truncation, preservation, disturbance, masonry_materials, masonry_coursing, masonry_faces, masonry_bonding, timber_type, timber_conversion, timber_marks, skeleton_position, skeleton_completeness, excavation_method, percent_excavated, conditions, sieving, flotation, reliability, activity, dating_evidence, observations, director, checked_by, checked_on, revised_by, revised_on, custom, deleted_at ON unit BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'unit', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'number' AS field, OLD.number AS was, NEW.number AS is_now
    UNION ALL SELECT 'area', OLD.area, NEW.area
    UNION ALL SELECT 'kind', OLD.kind, NEW.kind
    UNION ALL SELECT 'form', OLD.form, NEW.form
    UNION ALL SELECT 'status', OLD.status, NEW.status
    UNION ALL SELECT 'origin', OLD.origin, NEW.origin
    UNION ALL SELECT 'title', OLD.title, NEW.title
    UNION ALL SELECT 'description', OLD.description, NEW.description
    UNION ALL SELECT 'interpretation', OLD.interpretation, NEW.interpretation
    UNION ALL SELECT 'excavated_from', OLD.excavated_from, NEW.excavated_from
    UNION ALL SELECT 'excavated_on', OLD.excavated_on, NEW.excavated_on
    UNION ALL SELECT 'recorded_by', OLD.recorded_by, NEW.recorded_by
    UNION ALL SELECT 'recorded_on', OLD.recorded_on, NEW.recorded_on
    UNION ALL SELECT 'phase', OLD.phase, NEW.phase
    UNION ALL SELECT 'period', OLD.period, NEW.period
    UNION ALL SELECT 'parent', OLD.parent, NEW.parent
    UNION ALL SELECT 'site_code', OLD.site_code, NEW.site_code
    UNION ALL SELECT 'sector', OLD.sector, NEW.sector
    UNION ALL SELECT 'square', OLD.square, NEW.square
    UNION ALL SELECT 'room', OLD.room, NEW.room
    UNION ALL SELECT 'position', OLD.position, NEW.position
    UNION ALL SELECT 'formation', OLD.formation, NEW.formation
    UNION ALL SELECT 'criteria_of_distinction', OLD.criteria_of_distinction, NEW.criteria_of_distinction
    UNION ALL SELECT 'mode_of_formation', OLD.mode_of_formation, NEW.mode_of_formation
    UNION ALL SELECT 'consistency', OLD.consistency, NEW.consistency
    UNION ALL SELECT 'colour', OLD.colour, NEW.colour
    UNION ALL SELECT 'munsell', OLD.munsell, NEW.munsell
    UNION ALL SELECT 'composition', OLD.composition, NEW.composition
    UNION ALL SELECT 'inclusions', OLD.inclusions, NEW.inclusions
    UNION ALL SELECT 'organic_components', OLD.organic_components, NEW.organic_components
    UNION ALL SELECT 'inorganic_components', OLD.inorganic_components, NEW.inorganic_components
    UNION ALL SELECT 'thickness', OLD.thickness, NEW.thickness
    UNION ALL SELECT 'length', OLD.length, NEW.length
    UNION ALL SELECT 'width', OLD.width, NEW.width
    UNION ALL SELECT 'depth', OLD.depth, NEW.depth
    UNION ALL SELECT 'shape_in_plan', OLD.shape_in_plan, NEW.shape_in_plan
    UNION ALL SELECT 'profile', OLD.profile, NEW.profile
    UNION ALL SELECT 'corners', OLD.corners, NEW.corners
    UNION ALL SELECT 'break_of_slope', OLD.break_of_slope, NEW.break_of_slope
    UNION ALL SELECT 'sides', OLD.sides, NEW.sides
    UNION ALL SELECT 'base', OLD.base, NEW.base
    UNION ALL SELECT 'orientation', OLD.orientation, NEW.orientation
    UNION ALL SELECT 'borders', OLD.borders, NEW.borders
    UNION ALL SELECT 'truncation', OLD.truncation, NEW.truncation
    UNION ALL SELECT 'preservation', OLD.preservation, NEW.preservation
    UNION ALL SELECT 'disturbance', OLD.disturbance, NEW.disturbance
    UNION ALL SELECT 'masonry_materials', OLD.masonry_materials, NEW.masonry_materials
    UNION ALL SELECT 'masonry_coursing', OLD.masonry_coursing, NEW.masonry_coursing
    UNION ALL SELECT 'masonry_faces', OLD.masonry_faces, NEW.masonry_faces
    UNION ALL SELECT 'masonry_bonding', OLD.masonry_bonding, NEW.masonry_bonding
    UNION ALL SELECT 'timber_type', OLD.timber_type, NEW.timber_type
    UNION ALL SELECT 'timber_conversion', OLD.timber_conversion, NEW.timber_conversion
    UNION ALL SELECT 'timber_marks', OLD.timber_marks, NEW.timber_marks
    UNION ALL SELECT 'skeleton_position', OLD.skeleton_position, NEW.skeleton_position
    UNION ALL SELECT 'skeleton_completeness', OLD.skeleton_completeness, NEW.skeleton_completeness
    UNION ALL SELECT 'excavation_method', OLD.excavation_method, NEW.excavation_method
    UNION ALL SELECT 'percent_excavated', OLD.percent_excavated, NEW.percent_excavated
    UNION ALL SELECT 'conditions', OLD.conditions, NEW.conditions
    UNION ALL SELECT 'sieving', OLD.sieving, NEW.sieving
    UNION ALL SELECT 'flotation', OLD.flotation, NEW.flotation
    UNION ALL SELECT 'reliability', OLD.reliability, NEW.reliability
    UNION ALL SELECT 'activity', OLD.activity, NEW.activity
    UNION ALL SELECT 'dating_evidence', OLD.dating_evidence, NEW.dating_evidence
    UNION ALL SELECT 'observations', OLD.observations, NEW.observations
    UNION ALL SELECT 'director', OLD.director, NEW.director
    UNION ALL SELECT 'checked_by', OLD.checked_by, NEW.checked_by
    UNION ALL SELECT 'checked_on', OLD.checked_on, NEW.checked_on
    UNION ALL SELECT 'revised_by', OLD.revised_by, NEW.revised_by
    UNION ALL SELECT 'revised_on', OLD.revised_on, NEW.revised_on
    UNION ALL SELECT 'custom', OLD.custom, NEW.custom
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER unit_deleted AFTER DELETE ON unit BEGIN
  INSERT INTO unit(fid, uuid, number, area, kind, form, status, origin, title, description, interpretation, excavated_from, excavated_on, recorded_by, recorded_on, phase, period, parent, site_code, sector, square, room, position, formation, criteria_of_distinction, mode_of_formation, consistency, colour, munsell, composition, inclusions, organic_components, inorganic_components, thickness, length, width, depth, shape_in_plan, profile, corners, break_of_slope, sides, base, orientation, borders, truncation, preservation, disturbance, masonry_materials, masonry_coursing, masonry_faces, masonry_bonding, timber_type, timber_conversion, timber_marks, skeleton_position, skeleton_completeness, excavation_method, percent_excavated, conditions, sieving, flotation, reliability, activity, dating_evidence, observations, director, checked_by, checked_on, revised_by, revised_on, custom, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.number, OLD.area, OLD.kind, OLD.form, OLD.status, OLD.origin, OLD.title, OLD.description, OLD.interpretation, OLD.excavated_from, OLD.excavated_on, OLD.recorded_by, OLD.recorded_on, OLD.phase, OLD.period, OLD.parent, OLD.site_code, OLD.sector, OLD.square, OLD.room, OLD.position, OLD.formation, OLD.criteria_of_distinction, OLD.mode_of_formation, OLD.consistency, OLD.colour, OLD.munsell, OLD.composition, OLD.inclusions, OLD.organic_components, OLD.inorganic_components, OLD.thickness, OLD.length, OLD.width, OLD.depth, OLD.shape_in_plan, OLD.profile, OLD.corners, OLD.break_of_slope, OLD.sides, OLD.base, OLD.orientation, OLD.borders, OLD.truncation, OLD.preservation, OLD.disturbance, OLD.masonry_materials, OLD.masonry_coursing, OLD.masonry_faces, OLD.masonry_bonding, OLD.timber_type, OLD.timber_conversion, OLD.timber_marks, OLD.skeleton_position, OLD.skeleton_completeness, OLD.excavation_method, OLD.percent_excavated, OLD.conditions, OLD.sieving, OLD.flotation, OLD.reliability, OLD.activity, OLD.dating_evidence, OLD.observations, OLD.director, OLD.checked_by, OLD.checked_on, OLD.revised_by, OLD.revised_on, OLD.custom,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'unit', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
  UPDATE relation SET deleted_at = coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now')) WHERE subject = OLD.uuid AND deleted_at IS NULL;
  UPDATE relation SET deleted_at = coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now')) WHERE object = OLD.uuid AND deleted_at IS NULL;
  UPDATE group_member SET deleted_at = coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now')) WHERE unit = OLD.uuid AND deleted_at IS NULL;
  UPDATE level SET deleted_at = coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now')) WHERE unit = OLD.uuid AND deleted_at IS NULL;
  UPDATE dating SET deleted_at = coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now')) WHERE unit = OLD.uuid AND deleted_at IS NULL;
  UPDATE interpretation_added SET deleted_at = coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now')) WHERE subject = OLD.uuid AND deleted_at IS NULL;
  UPDATE interpretation_added SET deleted_at = coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now')) WHERE object = OLD.uuid AND deleted_at IS NULL;
END;
CREATE TRIGGER unit_takes_along AFTER UPDATE OF deleted_at ON unit
  WHEN OLD.deleted_at IS NULL AND NEW.deleted_at IS NOT NULL BEGIN
  UPDATE relation SET deleted_at = NEW.deleted_at WHERE subject = NEW.uuid AND deleted_at IS NULL;
  UPDATE relation SET deleted_at = NEW.deleted_at WHERE object = NEW.uuid AND deleted_at IS NULL;
  UPDATE group_member SET deleted_at = NEW.deleted_at WHERE unit = NEW.uuid AND deleted_at IS NULL;
  UPDATE level SET deleted_at = NEW.deleted_at WHERE unit = NEW.uuid AND deleted_at IS NULL;
  UPDATE dating SET deleted_at = NEW.deleted_at WHERE unit = NEW.uuid AND deleted_at IS NULL;
  UPDATE interpretation_added SET deleted_at = NEW.deleted_at WHERE subject = NEW.uuid AND deleted_at IS NULL;
  UPDATE interpretation_added SET deleted_at = NEW.deleted_at WHERE object = NEW.uuid AND deleted_at IS NULL;
END;
CREATE TRIGGER relation_inserted AFTER INSERT ON relation
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'object: there is no such unit') WHERE NEW.object IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.object);
  SELECT RAISE(ABORT, 'subject: there is no such unit') WHERE NEW.subject IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.subject);
  UPDATE relation SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'relation', (SELECT uuid FROM relation WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER relation_uuid_stays BEFORE UPDATE OF uuid ON relation
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER relation_refers AFTER UPDATE OF object, subject ON relation
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'object: there is no such unit') WHERE NEW.object IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.object);
  SELECT RAISE(ABORT, 'subject: there is no such unit') WHERE NEW.subject IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.subject);
END;
CREATE TRIGGER relation_changed AFTER UPDATE OF subject, kind, object, certainty, correlation, deleted_at ON relation BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'relation', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'subject' AS field, OLD.subject AS was, NEW.subject AS is_now
    UNION ALL SELECT 'kind', OLD.kind, NEW.kind
    UNION ALL SELECT 'object', OLD.object, NEW.object
    UNION ALL SELECT 'certainty', OLD.certainty, NEW.certainty
    UNION ALL SELECT 'correlation', OLD.correlation, NEW.correlation
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER relation_deleted AFTER DELETE ON relation BEGIN
  INSERT INTO relation(fid, uuid, subject, kind, object, certainty, correlation, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.subject, OLD.kind, OLD.object, OLD.certainty, OLD.correlation,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'relation', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
  UPDATE relation_statement SET deleted_at = coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now')) WHERE relation = OLD.uuid AND deleted_at IS NULL;
END;
CREATE TRIGGER relation_takes_along AFTER UPDATE OF deleted_at ON relation
  WHEN OLD.deleted_at IS NULL AND NEW.deleted_at IS NOT NULL BEGIN
  UPDATE relation_statement SET deleted_at = NEW.deleted_at WHERE relation = NEW.uuid AND deleted_at IS NULL;
END;
CREATE TRIGGER relation_statement_inserted AFTER INSERT ON relation_statement
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'relation: there is no such relation') WHERE NEW.relation IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM relation WHERE uuid = NEW.relation);
  SELECT RAISE(ABORT, 'source: there is no such source') WHERE NEW.source IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM source WHERE uuid = NEW.source);
  UPDATE relation_statement SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'relation_statement', (SELECT uuid FROM relation_statement WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER relation_statement_uuid_stays BEFORE UPDATE OF uuid ON relation_statement
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER relation_statement_refers AFTER UPDATE OF relation, source ON relation_statement
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'relation: there is no such relation') WHERE NEW.relation IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM relation WHERE uuid = NEW.relation);
  SELECT RAISE(ABORT, 'source: there is no such source') WHERE NEW.source IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM source WHERE uuid = NEW.source);
END;
CREATE TRIGGER relation_statement_changed AFTER UPDATE OF relation, side, source, line, person, raw_text, stated_at, deleted_at ON relation_statement BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'relation_statement', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'relation' AS field, OLD.relation AS was, NEW.relation AS is_now
    UNION ALL SELECT 'side', OLD.side, NEW.side
    UNION ALL SELECT 'source', OLD.source, NEW.source
    UNION ALL SELECT 'line', OLD.line, NEW.line
    UNION ALL SELECT 'person', OLD.person, NEW.person
    UNION ALL SELECT 'raw_text', OLD.raw_text, NEW.raw_text
    UNION ALL SELECT 'stated_at', OLD.stated_at, NEW.stated_at
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER relation_statement_deleted AFTER DELETE ON relation_statement BEGIN
  INSERT INTO relation_statement(fid, uuid, relation, side, source, line, person, raw_text, stated_at, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.relation, OLD.side, OLD.source, OLD.line, OLD.person, OLD.raw_text, OLD.stated_at,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'relation_statement', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
CREATE TRIGGER unit_group_inserted AFTER INSERT ON unit_group
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'parent: there is no such unit_group') WHERE NEW.parent IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit_group WHERE uuid = NEW.parent);
  UPDATE unit_group SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'unit_group', (SELECT uuid FROM unit_group WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER unit_group_uuid_stays BEFORE UPDATE OF uuid ON unit_group
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER unit_group_refers AFTER UPDATE OF parent ON unit_group
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'parent: there is no such unit_group') WHERE NEW.parent IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit_group WHERE uuid = NEW.parent);
END;
CREATE TRIGGER unit_group_changed AFTER UPDATE OF number, type, title, description, parent, deleted_at ON unit_group BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'unit_group', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'number' AS field, OLD.number AS was, NEW.number AS is_now
    UNION ALL SELECT 'type', OLD.type, NEW.type
    UNION ALL SELECT 'title', OLD.title, NEW.title
    UNION ALL SELECT 'description', OLD.description, NEW.description
    UNION ALL SELECT 'parent', OLD.parent, NEW.parent
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER unit_group_deleted AFTER DELETE ON unit_group BEGIN
  INSERT INTO unit_group(fid, uuid, number, type, title, description, parent, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.number, OLD.type, OLD.title, OLD.description, OLD.parent,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'unit_group', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
  UPDATE group_member SET deleted_at = coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now')) WHERE unit_group = OLD.uuid AND deleted_at IS NULL;
END;
CREATE TRIGGER unit_group_takes_along AFTER UPDATE OF deleted_at ON unit_group
  WHEN OLD.deleted_at IS NULL AND NEW.deleted_at IS NOT NULL BEGIN
  UPDATE group_member SET deleted_at = NEW.deleted_at WHERE unit_group = NEW.uuid AND deleted_at IS NULL;
END;
CREATE TRIGGER group_member_inserted AFTER INSERT ON group_member
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'unit: there is no such unit') WHERE NEW.unit IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.unit);
  SELECT RAISE(ABORT, 'unit_group: there is no such unit_group') WHERE NEW.unit_group IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit_group WHERE uuid = NEW.unit_group);
  UPDATE group_member SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'group_member', (SELECT uuid FROM group_member WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER group_member_uuid_stays BEFORE UPDATE OF uuid ON group_member
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER group_member_refers AFTER UPDATE OF unit, unit_group ON group_member
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'unit: there is no such unit') WHERE NEW.unit IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.unit);
  SELECT RAISE(ABORT, 'unit_group: there is no such unit_group') WHERE NEW.unit_group IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit_group WHERE uuid = NEW.unit_group);
END;
CREATE TRIGGER group_member_changed AFTER UPDATE OF unit_group, unit, deleted_at ON group_member BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'group_member', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'unit_group' AS field, OLD.unit_group AS was, NEW.unit_group AS is_now
    UNION ALL SELECT 'unit', OLD.unit, NEW.unit
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER group_member_deleted AFTER DELETE ON group_member BEGIN
  INSERT INTO group_member(fid, uuid, unit_group, unit, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.unit_group, OLD.unit,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'group_member', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
CREATE TRIGGER level_inserted AFTER INSERT ON level
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'unit: there is no such unit') WHERE NEW.unit IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.unit);
  UPDATE level SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'level', (SELECT uuid FROM level WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER level_uuid_stays BEFORE UPDATE OF uuid ON level
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER level_refers AFTER UPDATE OF unit ON level
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'unit: there is no such unit') WHERE NEW.unit IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.unit);
END;
CREATE TRIGGER level_changed AFTER UPDATE OF geom, unit, x, y, z, role, label, deleted_at ON level BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'level', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'geom' AS field, CASE WHEN OLD.geom IS NOT NEW.geom THEN lower(hex(OLD.geom)) END AS was, CASE WHEN OLD.geom IS NOT NEW.geom THEN lower(hex(NEW.geom)) END AS is_now
    UNION ALL SELECT 'unit', OLD.unit, NEW.unit
    UNION ALL SELECT 'x', OLD.x, NEW.x
    UNION ALL SELECT 'y', OLD.y, NEW.y
    UNION ALL SELECT 'z', OLD.z, NEW.z
    UNION ALL SELECT 'role', OLD.role, NEW.role
    UNION ALL SELECT 'label', OLD.label, NEW.label
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER level_deleted AFTER DELETE ON level BEGIN
  INSERT INTO level(fid, uuid, geom, unit, x, y, z, role, label, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.geom, OLD.unit, OLD.x, OLD.y, OLD.z, OLD.role, OLD.label,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'level', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
CREATE TRIGGER find_inserted AFTER INSERT ON find
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'unit: there is no such unit') WHERE NEW.unit IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.unit);
  UPDATE find SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'find', (SELECT uuid FROM find WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER find_uuid_stays BEFORE UPDATE OF uuid ON find
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER find_refers AFTER UPDATE OF unit ON find
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'unit: there is no such unit') WHERE NEW.unit IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.unit);
END;
CREATE TRIGGER find_changed AFTER UPDATE OF geom, number, unit, x, y, z, type, material, count, weight, condition, box, found_on, description, deleted_at ON find BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'find', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'geom' AS field, CASE WHEN OLD.geom IS NOT NEW.geom THEN lower(hex(OLD.geom)) END AS was, CASE WHEN OLD.geom IS NOT NEW.geom THEN lower(hex(NEW.geom)) END AS is_now
    UNION ALL SELECT 'number', OLD.number, NEW.number
    UNION ALL SELECT 'unit', OLD.unit, NEW.unit
    UNION ALL SELECT 'x', OLD.x, NEW.x
    UNION ALL SELECT 'y', OLD.y, NEW.y
    UNION ALL SELECT 'z', OLD.z, NEW.z
    UNION ALL SELECT 'type', OLD.type, NEW.type
    UNION ALL SELECT 'material', OLD.material, NEW.material
    UNION ALL SELECT 'count', OLD.count, NEW.count
    UNION ALL SELECT 'weight', OLD.weight, NEW.weight
    UNION ALL SELECT 'condition', OLD.condition, NEW.condition
    UNION ALL SELECT 'box', OLD.box, NEW.box
    UNION ALL SELECT 'found_on', OLD.found_on, NEW.found_on
    UNION ALL SELECT 'description', OLD.description, NEW.description
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER find_deleted AFTER DELETE ON find BEGIN
  INSERT INTO find(fid, uuid, geom, number, unit, x, y, z, type, material, count, weight, condition, box, found_on, description, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.geom, OLD.number, OLD.unit, OLD.x, OLD.y, OLD.z, OLD.type, OLD.material, OLD.count, OLD.weight, OLD.condition, OLD.box, OLD.found_on, OLD.description,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'find', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
CREATE TRIGGER dating_inserted AFTER INSERT ON dating
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'find: there is no such find') WHERE NEW.find IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM find WHERE uuid = NEW.find);
  SELECT RAISE(ABORT, 'unit: there is no such unit') WHERE NEW.unit IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.unit);
  UPDATE dating SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'dating', (SELECT uuid FROM dating WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER dating_uuid_stays BEFORE UPDATE OF uuid ON dating
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER dating_refers AFTER UPDATE OF find, unit ON dating
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'find: there is no such find') WHERE NEW.find IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM find WHERE uuid = NEW.find);
  SELECT RAISE(ABORT, 'unit: there is no such unit') WHERE NEW.unit IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.unit);
END;
CREATE TRIGGER dating_changed AFTER UPDATE OF label, unit, find, kind, year_from, year_to, bp, bp_error, association, notes, deleted_at ON dating BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'dating', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'label' AS field, OLD.label AS was, NEW.label AS is_now
    UNION ALL SELECT 'unit', OLD.unit, NEW.unit
    UNION ALL SELECT 'find', OLD.find, NEW.find
    UNION ALL SELECT 'kind', OLD.kind, NEW.kind
    UNION ALL SELECT 'year_from', OLD.year_from, NEW.year_from
    UNION ALL SELECT 'year_to', OLD.year_to, NEW.year_to
    UNION ALL SELECT 'bp', OLD.bp, NEW.bp
    UNION ALL SELECT 'bp_error', OLD.bp_error, NEW.bp_error
    UNION ALL SELECT 'association', OLD.association, NEW.association
    UNION ALL SELECT 'notes', OLD.notes, NEW.notes
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER dating_deleted AFTER DELETE ON dating BEGIN
  INSERT INTO dating(fid, uuid, label, unit, find, kind, year_from, year_to, bp, bp_error, association, notes, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.label, OLD.unit, OLD.find, OLD.kind, OLD.year_from, OLD.year_to, OLD.bp, OLD.bp_error, OLD.association, OLD.notes,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'dating', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
CREATE TRIGGER sample_inserted AFTER INSERT ON sample
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'unit: there is no such unit') WHERE NEW.unit IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.unit);
  UPDATE sample SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'sample', (SELECT uuid FROM sample WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER sample_uuid_stays BEFORE UPDATE OF uuid ON sample
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER sample_refers AFTER UPDATE OF unit ON sample
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'unit: there is no such unit') WHERE NEW.unit IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.unit);
END;
CREATE TRIGGER sample_changed AFTER UPDATE OF number, unit, type, volume, weight, laboratory_number, state, description, deleted_at ON sample BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'sample', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'number' AS field, OLD.number AS was, NEW.number AS is_now
    UNION ALL SELECT 'unit', OLD.unit, NEW.unit
    UNION ALL SELECT 'type', OLD.type, NEW.type
    UNION ALL SELECT 'volume', OLD.volume, NEW.volume
    UNION ALL SELECT 'weight', OLD.weight, NEW.weight
    UNION ALL SELECT 'laboratory_number', OLD.laboratory_number, NEW.laboratory_number
    UNION ALL SELECT 'state', OLD.state, NEW.state
    UNION ALL SELECT 'description', OLD.description, NEW.description
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER sample_deleted AFTER DELETE ON sample BEGIN
  INSERT INTO sample(fid, uuid, number, unit, type, volume, weight, laboratory_number, state, description, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.number, OLD.unit, OLD.type, OLD.volume, OLD.weight, OLD.laboratory_number, OLD.state, OLD.description,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'sample', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
CREATE TRIGGER document_inserted AFTER INSERT ON document
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'unit: there is no such unit') WHERE NEW.unit IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.unit);
  UPDATE document SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'document', (SELECT uuid FROM document WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER document_uuid_stays BEFORE UPDATE OF uuid ON document
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER document_refers AFTER UPDATE OF unit ON document
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'unit: there is no such unit') WHERE NEW.unit IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.unit);
END;
CREATE TRIGGER document_changed AFTER UPDATE OF number, type, title, unit, path, made_on, author, deleted_at ON document BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'document', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'number' AS field, OLD.number AS was, NEW.number AS is_now
    UNION ALL SELECT 'type', OLD.type, NEW.type
    UNION ALL SELECT 'title', OLD.title, NEW.title
    UNION ALL SELECT 'unit', OLD.unit, NEW.unit
    UNION ALL SELECT 'path', OLD.path, NEW.path
    UNION ALL SELECT 'made_on', OLD.made_on, NEW.made_on
    UNION ALL SELECT 'author', OLD.author, NEW.author
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER document_deleted AFTER DELETE ON document BEGIN
  INSERT INTO document(fid, uuid, number, type, title, unit, path, made_on, author, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.number, OLD.type, OLD.title, OLD.unit, OLD.path, OLD.made_on, OLD.author,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'document', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
CREATE TRIGGER surface_inserted AFTER INSERT ON surface
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'area: there is no such area') WHERE NEW.area IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM area WHERE uuid = NEW.area);
  UPDATE surface SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'surface', (SELECT uuid FROM surface WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER surface_uuid_stays BEFORE UPDATE OF uuid ON surface
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER surface_refers AFTER UPDATE OF area ON surface
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'area: there is no such area') WHERE NEW.area IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM area WHERE uuid = NEW.area);
END;
CREATE TRIGGER surface_changed AFTER UPDATE OF area, name, method, first_day, last_day, place, deleted_at ON surface BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'surface', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'area' AS field, OLD.area AS was, NEW.area AS is_now
    UNION ALL SELECT 'name', OLD.name, NEW.name
    UNION ALL SELECT 'method', OLD.method, NEW.method
    UNION ALL SELECT 'first_day', OLD.first_day, NEW.first_day
    UNION ALL SELECT 'last_day', OLD.last_day, NEW.last_day
    UNION ALL SELECT 'place', OLD.place, NEW.place
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER surface_deleted AFTER DELETE ON surface BEGIN
  INSERT INTO surface(fid, uuid, area, name, method, first_day, last_day, place, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.area, OLD.name, OLD.method, OLD.first_day, OLD.last_day, OLD.place,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'surface', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
CREATE TRIGGER section_inserted AFTER INSERT ON section
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'area: there is no such area') WHERE NEW.area IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM area WHERE uuid = NEW.area);
  UPDATE section SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'section', (SELECT uuid FROM section WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER section_uuid_stays BEFORE UPDATE OF uuid ON section
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER section_refers AFTER UPDATE OF area ON section
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'area: there is no such area') WHERE NEW.area IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM area WHERE uuid = NEW.area);
END;
CREATE TRIGGER section_changed AFTER UPDATE OF geom, area, name, day, deleted_at ON section BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'section', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'geom' AS field, CASE WHEN OLD.geom IS NOT NEW.geom THEN lower(hex(OLD.geom)) END AS was, CASE WHEN OLD.geom IS NOT NEW.geom THEN lower(hex(NEW.geom)) END AS is_now
    UNION ALL SELECT 'area', OLD.area, NEW.area
    UNION ALL SELECT 'name', OLD.name, NEW.name
    UNION ALL SELECT 'day', OLD.day, NEW.day
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER section_deleted AFTER DELETE ON section BEGIN
  INSERT INTO section(fid, uuid, geom, area, name, day, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.geom, OLD.area, OLD.name, OLD.day,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'section', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
CREATE TRIGGER region_inserted AFTER INSERT ON region
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'section: there is no such section') WHERE NEW.section IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM section WHERE uuid = NEW.section);
  SELECT RAISE(ABORT, 'seen_in: there is no such unit') WHERE NEW.seen_in IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.seen_in);
  SELECT RAISE(ABORT, 'surface: there is no such surface') WHERE NEW.surface IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM surface WHERE uuid = NEW.surface);
  SELECT RAISE(ABORT, 'unit: there is no such unit') WHERE NEW.unit IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.unit);
  UPDATE region SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'region', (SELECT uuid FROM region WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER region_uuid_stays BEFORE UPDATE OF uuid ON region
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER region_refers AFTER UPDATE OF section, seen_in, surface, unit ON region
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'section: there is no such section') WHERE NEW.section IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM section WHERE uuid = NEW.section);
  SELECT RAISE(ABORT, 'seen_in: there is no such unit') WHERE NEW.seen_in IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.seen_in);
  SELECT RAISE(ABORT, 'surface: there is no such surface') WHERE NEW.surface IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM surface WHERE uuid = NEW.surface);
  SELECT RAISE(ABORT, 'unit: there is no such unit') WHERE NEW.unit IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.unit);
END;
CREATE TRIGGER region_changed AFTER UPDATE OF geom, surface, section, unit, unit_as_drawn, part, category, shows, sigma, drawn_on, seen_in, notes, deleted_at ON region BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'region', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'geom' AS field, CASE WHEN OLD.geom IS NOT NEW.geom THEN lower(hex(OLD.geom)) END AS was, CASE WHEN OLD.geom IS NOT NEW.geom THEN lower(hex(NEW.geom)) END AS is_now
    UNION ALL SELECT 'surface', OLD.surface, NEW.surface
    UNION ALL SELECT 'section', OLD.section, NEW.section
    UNION ALL SELECT 'unit', OLD.unit, NEW.unit
    UNION ALL SELECT 'unit_as_drawn', OLD.unit_as_drawn, NEW.unit_as_drawn
    UNION ALL SELECT 'part', OLD.part, NEW.part
    UNION ALL SELECT 'category', OLD.category, NEW.category
    UNION ALL SELECT 'shows', OLD.shows, NEW.shows
    UNION ALL SELECT 'sigma', OLD.sigma, NEW.sigma
    UNION ALL SELECT 'drawn_on', OLD.drawn_on, NEW.drawn_on
    UNION ALL SELECT 'seen_in', OLD.seen_in, NEW.seen_in
    UNION ALL SELECT 'notes', OLD.notes, NEW.notes
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER region_deleted AFTER DELETE ON region BEGIN
  INSERT INTO region(fid, uuid, geom, surface, section, unit, unit_as_drawn, part, category, shows, sigma, drawn_on, seen_in, notes, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.geom, OLD.surface, OLD.section, OLD.unit, OLD.unit_as_drawn, OLD.part, OLD.category, OLD.shows, OLD.sigma, OLD.drawn_on, OLD.seen_in, OLD.notes,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'region', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
CREATE TRIGGER scan_inserted AFTER INSERT ON scan
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'surface: there is no such surface') WHERE NEW.surface IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM surface WHERE uuid = NEW.surface);
  UPDATE scan SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'scan', (SELECT uuid FROM scan WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER scan_uuid_stays BEFORE UPDATE OF uuid ON scan
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER scan_refers AFTER UPDATE OF surface ON scan
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'surface: there is no such surface') WHERE NEW.surface IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM surface WHERE uuid = NEW.surface);
END;
CREATE TRIGGER scan_changed AFTER UPDATE OF name, day, surface, path, sha256, format, cloud, points, rows, columns, sensor, acquired_at, header_pose, deleted_at ON scan BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'scan', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'name' AS field, OLD.name AS was, NEW.name AS is_now
    UNION ALL SELECT 'day', OLD.day, NEW.day
    UNION ALL SELECT 'surface', OLD.surface, NEW.surface
    UNION ALL SELECT 'path', OLD.path, NEW.path
    UNION ALL SELECT 'sha256', OLD.sha256, NEW.sha256
    UNION ALL SELECT 'format', OLD.format, NEW.format
    UNION ALL SELECT 'cloud', OLD.cloud, NEW.cloud
    UNION ALL SELECT 'points', OLD.points, NEW.points
    UNION ALL SELECT 'rows', OLD.rows, NEW.rows
    UNION ALL SELECT 'columns', OLD.columns, NEW.columns
    UNION ALL SELECT 'sensor', OLD.sensor, NEW.sensor
    UNION ALL SELECT 'acquired_at', OLD.acquired_at, NEW.acquired_at
    UNION ALL SELECT 'header_pose', OLD.header_pose, NEW.header_pose
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER scan_deleted AFTER DELETE ON scan BEGIN
  INSERT INTO scan(fid, uuid, name, day, surface, path, sha256, format, cloud, points, rows, columns, sensor, acquired_at, header_pose, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.name, OLD.day, OLD.surface, OLD.path, OLD.sha256, OLD.format, OLD.cloud, OLD.points, OLD.rows, OLD.columns, OLD.sensor, OLD.acquired_at, OLD.header_pose,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'scan', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
  UPDATE scan_pose SET deleted_at = coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now')) WHERE scan = OLD.uuid AND deleted_at IS NULL;
END;
CREATE TRIGGER scan_takes_along AFTER UPDATE OF deleted_at ON scan
  WHEN OLD.deleted_at IS NULL AND NEW.deleted_at IS NOT NULL BEGIN
  UPDATE scan_pose SET deleted_at = NEW.deleted_at WHERE scan = NEW.uuid AND deleted_at IS NULL;
END;
CREATE TRIGGER registration_run_inserted AFTER INSERT ON registration_run
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  UPDATE registration_run SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'registration_run', (SELECT uuid FROM registration_run WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER registration_run_uuid_stays BEFORE UPDATE OF uuid ON registration_run
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER registration_run_changed AFTER UPDATE OF name, made_at, method, state, report, deleted_at ON registration_run BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'registration_run', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'name' AS field, OLD.name AS was, NEW.name AS is_now
    UNION ALL SELECT 'made_at', OLD.made_at, NEW.made_at
    UNION ALL SELECT 'method', OLD.method, NEW.method
    UNION ALL SELECT 'state', OLD.state, NEW.state
    UNION ALL SELECT 'report', OLD.report, NEW.report
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER registration_run_deleted AFTER DELETE ON registration_run BEGIN
  INSERT INTO registration_run(fid, uuid, name, made_at, method, state, report, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.name, OLD.made_at, OLD.method, OLD.state, OLD.report,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'registration_run', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
CREATE TRIGGER scan_pose_inserted AFTER INSERT ON scan_pose
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'run: there is no such registration_run') WHERE NEW.run IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM registration_run WHERE uuid = NEW.run);
  SELECT RAISE(ABORT, 'scan: there is no such scan') WHERE NEW.scan IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM scan WHERE uuid = NEW.scan);
  UPDATE scan_pose SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'scan_pose', (SELECT uuid FROM scan_pose WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER scan_pose_uuid_stays BEFORE UPDATE OF uuid ON scan_pose
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER scan_pose_refers AFTER UPDATE OF run, scan ON scan_pose
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'run: there is no such registration_run') WHERE NEW.run IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM registration_run WHERE uuid = NEW.run);
  SELECT RAISE(ABORT, 'scan: there is no such scan') WHERE NEW.scan IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM scan WHERE uuid = NEW.scan);
END;
CREATE TRIGGER scan_pose_changed AFTER UPDATE OF geom, scan, run, site_from_scan, covariance, rms, overlap, verdict, deleted_at ON scan_pose BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'scan_pose', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'geom' AS field, CASE WHEN OLD.geom IS NOT NEW.geom THEN lower(hex(OLD.geom)) END AS was, CASE WHEN OLD.geom IS NOT NEW.geom THEN lower(hex(NEW.geom)) END AS is_now
    UNION ALL SELECT 'scan', OLD.scan, NEW.scan
    UNION ALL SELECT 'run', OLD.run, NEW.run
    UNION ALL SELECT 'site_from_scan', OLD.site_from_scan, NEW.site_from_scan
    UNION ALL SELECT 'covariance', OLD.covariance, NEW.covariance
    UNION ALL SELECT 'rms', OLD.rms, NEW.rms
    UNION ALL SELECT 'overlap', OLD.overlap, NEW.overlap
    UNION ALL SELECT 'verdict', OLD.verdict, NEW.verdict
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER scan_pose_deleted AFTER DELETE ON scan_pose BEGIN
  INSERT INTO scan_pose(fid, uuid, geom, scan, run, site_from_scan, covariance, rms, overlap, verdict, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.geom, OLD.scan, OLD.run, OLD.site_from_scan, OLD.covariance, OLD.rms, OLD.overlap, OLD.verdict,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'scan_pose', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
CREATE TRIGGER decision_inserted AFTER INSERT ON decision
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  UPDATE decision SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'decision', (SELECT uuid FROM decision WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER decision_uuid_stays BEFORE UPDATE OF uuid ON decision
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER decision_changed AFTER UPDATE OF subject_id, kind, verdict, because, evidence_hash, area, author, made_at, deleted_at ON decision BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'decision', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'subject_id' AS field, OLD.subject_id AS was, NEW.subject_id AS is_now
    UNION ALL SELECT 'kind', OLD.kind, NEW.kind
    UNION ALL SELECT 'verdict', OLD.verdict, NEW.verdict
    UNION ALL SELECT 'because', OLD.because, NEW.because
    UNION ALL SELECT 'evidence_hash', OLD.evidence_hash, NEW.evidence_hash
    UNION ALL SELECT 'area', OLD.area, NEW.area
    UNION ALL SELECT 'author', OLD.author, NEW.author
    UNION ALL SELECT 'made_at', OLD.made_at, NEW.made_at
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER decision_deleted AFTER DELETE ON decision BEGIN
  INSERT INTO decision(fid, uuid, subject_id, kind, verdict, because, evidence_hash, area, author, made_at, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.subject_id, OLD.kind, OLD.verdict, OLD.because, OLD.evidence_hash, OLD.area, OLD.author, OLD.made_at,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'decision', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
CREATE TRIGGER interpretation_inserted AFTER INSERT ON interpretation
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'parent: there is no such interpretation') WHERE NEW.parent IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM interpretation WHERE uuid = NEW.parent);
  UPDATE interpretation SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'interpretation', (SELECT uuid FROM interpretation WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER interpretation_uuid_stays BEFORE UPDATE OF uuid ON interpretation
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER interpretation_refers AFTER UPDATE OF parent ON interpretation
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'parent: there is no such interpretation') WHERE NEW.parent IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM interpretation WHERE uuid = NEW.parent);
END;
CREATE TRIGGER interpretation_changed AFTER UPDATE OF name, parent, author, made_at, deleted_at ON interpretation BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'interpretation', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'name' AS field, OLD.name AS was, NEW.name AS is_now
    UNION ALL SELECT 'parent', OLD.parent, NEW.parent
    UNION ALL SELECT 'author', OLD.author, NEW.author
    UNION ALL SELECT 'made_at', OLD.made_at, NEW.made_at
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER interpretation_deleted AFTER DELETE ON interpretation BEGIN
  INSERT INTO interpretation(fid, uuid, name, parent, author, made_at, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.name, OLD.parent, OLD.author, OLD.made_at,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'interpretation', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
  UPDATE interpretation_added SET deleted_at = coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now')) WHERE interpretation = OLD.uuid AND deleted_at IS NULL;
  UPDATE interpretation_dropped SET deleted_at = coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now')) WHERE interpretation = OLD.uuid AND deleted_at IS NULL;
END;
CREATE TRIGGER interpretation_takes_along AFTER UPDATE OF deleted_at ON interpretation
  WHEN OLD.deleted_at IS NULL AND NEW.deleted_at IS NOT NULL BEGIN
  UPDATE interpretation_added SET deleted_at = NEW.deleted_at WHERE interpretation = NEW.uuid AND deleted_at IS NULL;
  UPDATE interpretation_dropped SET deleted_at = NEW.deleted_at WHERE interpretation = NEW.uuid AND deleted_at IS NULL;
END;
CREATE TRIGGER interpretation_added_inserted AFTER INSERT ON interpretation_added
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'interpretation: there is no such interpretation') WHERE NEW.interpretation IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM interpretation WHERE uuid = NEW.interpretation);
  SELECT RAISE(ABORT, 'object: there is no such unit') WHERE NEW.object IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.object);
  SELECT RAISE(ABORT, 'subject: there is no such unit') WHERE NEW.subject IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.subject);
  UPDATE interpretation_added SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'interpretation_added', (SELECT uuid FROM interpretation_added WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER interpretation_added_uuid_stays BEFORE UPDATE OF uuid ON interpretation_added
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER interpretation_added_refers AFTER UPDATE OF interpretation, object, subject ON interpretation_added
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'interpretation: there is no such interpretation') WHERE NEW.interpretation IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM interpretation WHERE uuid = NEW.interpretation);
  SELECT RAISE(ABORT, 'object: there is no such unit') WHERE NEW.object IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.object);
  SELECT RAISE(ABORT, 'subject: there is no such unit') WHERE NEW.subject IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM unit WHERE uuid = NEW.subject);
END;
CREATE TRIGGER interpretation_added_changed AFTER UPDATE OF interpretation, subject, kind, object, certainty, correlation, deleted_at ON interpretation_added BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'interpretation_added', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'interpretation' AS field, OLD.interpretation AS was, NEW.interpretation AS is_now
    UNION ALL SELECT 'subject', OLD.subject, NEW.subject
    UNION ALL SELECT 'kind', OLD.kind, NEW.kind
    UNION ALL SELECT 'object', OLD.object, NEW.object
    UNION ALL SELECT 'certainty', OLD.certainty, NEW.certainty
    UNION ALL SELECT 'correlation', OLD.correlation, NEW.correlation
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER interpretation_added_deleted AFTER DELETE ON interpretation_added BEGIN
  INSERT INTO interpretation_added(fid, uuid, interpretation, subject, kind, object, certainty, correlation, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.interpretation, OLD.subject, OLD.kind, OLD.object, OLD.certainty, OLD.correlation,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'interpretation_added', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
CREATE TRIGGER interpretation_dropped_inserted AFTER INSERT ON interpretation_dropped
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'a uuid is written in lower-case hexadecimal digits with four hyphens')
    WHERE NEW.uuid NOT GLOB '[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f]-[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]';
  SELECT RAISE(ABORT, 'interpretation: there is no such interpretation') WHERE NEW.interpretation IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM interpretation WHERE uuid = NEW.interpretation);
  UPDATE interpretation_dropped SET uuid = lower(hex(randomblob(4)) || '-' || hex(randomblob(2)) || '-4' || substr(hex(randomblob(2)), 2) || '-' ||
      substr('89ab', 1 + (random() & 3), 1) || substr(hex(randomblob(2)), 2) || '-' || hex(randomblob(6)))
    WHERE fid = NEW.fid AND uuid IS NULL;
  INSERT INTO planum_log(made_at, author, action, table_name, record) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'insert', 'interpretation_dropped', (SELECT uuid FROM interpretation_dropped WHERE fid = NEW.fid) FROM planum_context c
    WHERE NEW.deleted_at IS NULL;
END;
CREATE TRIGGER interpretation_dropped_uuid_stays BEFORE UPDATE OF uuid ON interpretation_dropped
  WHEN OLD.uuid IS NOT NULL AND NEW.uuid IS NOT OLD.uuid BEGIN
  SELECT RAISE(ABORT, 'the uuid of a record stays as it is');
END;
CREATE TRIGGER interpretation_dropped_refers AFTER UPDATE OF interpretation ON interpretation_dropped
  WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'interpretation: there is no such interpretation') WHERE NEW.interpretation IS NOT NULL
    AND NOT EXISTS (SELECT 1 FROM interpretation WHERE uuid = NEW.interpretation);
END;
CREATE TRIGGER interpretation_dropped_changed AFTER UPDATE OF interpretation, relation, deleted_at ON interpretation_dropped BEGIN
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    CASE WHEN f.field <> 'deleted_at' THEN 'update' WHEN NEW.deleted_at IS NULL THEN 'restore'
      ELSE 'delete' END,
    'interpretation_dropped', NEW.uuid, f.field, f.was, f.is_now, c.change FROM planum_context c, (
    SELECT 'interpretation' AS field, OLD.interpretation AS was, NEW.interpretation AS is_now
    UNION ALL SELECT 'relation', OLD.relation, NEW.relation
    UNION ALL SELECT 'deleted_at', OLD.deleted_at, NEW.deleted_at) f
    WHERE f.was IS NOT f.is_now;
END;
CREATE TRIGGER interpretation_dropped_deleted AFTER DELETE ON interpretation_dropped BEGIN
  INSERT INTO interpretation_dropped(fid, uuid, interpretation, relation, deleted_at)
    VALUES (OLD.fid, OLD.uuid, OLD.interpretation, OLD.relation,
    coalesce(OLD.deleted_at, coalesce((SELECT made_at FROM planum_context), strftime('%Y-%m-%dT%H:%M:%fZ','now'))));
  INSERT INTO planum_log(made_at, author, action, table_name, record, field, change) SELECT
    coalesce(c.made_at, strftime('%Y-%m-%dT%H:%M:%fZ','now')), coalesce(c.author, 'outside Planum'),
    'delete', 'interpretation_dropped', OLD.uuid, 'deleted_at', c.change FROM planum_context c
    WHERE OLD.deleted_at IS NULL;
END;
