-- What other programs may not do, as Planum itself does not: rules that schema version 1 left to the program. They hold
-- where Planum is not inside a change of its own; undo and redo go past them, since they put back what was there.

CREATE TRIGGER planum_change_stays BEFORE DELETE ON planum_change BEGIN
  SELECT RAISE(ABORT, 'the list of changes cannot be changed');
END;
CREATE TRIGGER planum_change_unchanged BEFORE UPDATE OF fid, label, author, made_at ON planum_change BEGIN
  SELECT RAISE(ABORT, 'the list of changes cannot be changed');
END;
CREATE TRIGGER planum_change_chunk_unchanged BEFORE UPDATE ON planum_change_chunk BEGIN
  SELECT RAISE(ABORT, 'the list of changes cannot be changed');
END;

CREATE TRIGGER unit_number_given BEFORE INSERT ON unit WHEN trim(NEW.number) = '' AND (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'number: it is empty');
END;

CREATE TRIGGER unit_number_kept BEFORE UPDATE OF number ON unit WHEN trim(NEW.number) = '' AND (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'number: it is empty');
END;

-- A relation is stored once; what more is said of it is a statement. Some kinds read the same from both ends.
CREATE TRIGGER relation_once_inserted BEFORE INSERT ON relation
  WHEN NEW.deleted_at IS NULL AND (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'this relation is recorded already') FROM relation
    WHERE kind = NEW.kind AND subject = NEW.subject AND object = NEW.object AND deleted_at IS NULL;
  SELECT RAISE(ABORT, 'this relation is recorded already') FROM relation
    WHERE NEW.kind IN ('bonds_with', 'same_as', 'borders', 'contemporary') AND kind = NEW.kind
      AND subject = NEW.object AND object = NEW.subject AND deleted_at IS NULL;
END;

CREATE TRIGGER relation_once_changed BEFORE UPDATE OF subject, kind, object, deleted_at ON relation
  WHEN NEW.deleted_at IS NULL AND (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'this relation is recorded already') FROM relation
    WHERE kind = NEW.kind AND subject = NEW.subject AND object = NEW.object AND deleted_at IS NULL AND fid <> OLD.fid;
  SELECT RAISE(ABORT, 'this relation is recorded already') FROM relation
    WHERE NEW.kind IN ('bonds_with', 'same_as', 'borders', 'contemporary') AND kind = NEW.kind
      AND subject = NEW.object AND object = NEW.subject AND deleted_at IS NULL AND fid <> OLD.fid;
END;

-- Days are written YYYY-MM-DD, so that they sort; date() of anything else is NULL or, made to reckon, another day.
CREATE TRIGGER unit_days_inserted BEFORE INSERT ON unit WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'excavated_from: a day is written YYYY-MM-DD') WHERE NEW.excavated_from <> '' AND date(NEW.excavated_from, '+0 days') IS NOT NEW.excavated_from;
  SELECT RAISE(ABORT, 'excavated_on: a day is written YYYY-MM-DD') WHERE NEW.excavated_on <> '' AND date(NEW.excavated_on, '+0 days') IS NOT NEW.excavated_on;
  SELECT RAISE(ABORT, 'recorded_on: a day is written YYYY-MM-DD') WHERE NEW.recorded_on <> '' AND date(NEW.recorded_on, '+0 days') IS NOT NEW.recorded_on;
END;
CREATE TRIGGER unit_days_changed BEFORE UPDATE OF excavated_from, excavated_on, recorded_on ON unit WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'excavated_from: a day is written YYYY-MM-DD') WHERE NEW.excavated_from <> '' AND date(NEW.excavated_from, '+0 days') IS NOT NEW.excavated_from;
  SELECT RAISE(ABORT, 'excavated_on: a day is written YYYY-MM-DD') WHERE NEW.excavated_on <> '' AND date(NEW.excavated_on, '+0 days') IS NOT NEW.excavated_on;
  SELECT RAISE(ABORT, 'recorded_on: a day is written YYYY-MM-DD') WHERE NEW.recorded_on <> '' AND date(NEW.recorded_on, '+0 days') IS NOT NEW.recorded_on;
END;

CREATE TRIGGER find_days_inserted BEFORE INSERT ON find WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'found_on: a day is written YYYY-MM-DD') WHERE NEW.found_on <> '' AND date(NEW.found_on, '+0 days') IS NOT NEW.found_on;
END;
CREATE TRIGGER find_days_changed BEFORE UPDATE OF found_on ON find WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'found_on: a day is written YYYY-MM-DD') WHERE NEW.found_on <> '' AND date(NEW.found_on, '+0 days') IS NOT NEW.found_on;
END;

CREATE TRIGGER document_days_inserted BEFORE INSERT ON document WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'made_on: a day is written YYYY-MM-DD') WHERE NEW.made_on <> '' AND date(NEW.made_on, '+0 days') IS NOT NEW.made_on;
END;
CREATE TRIGGER document_days_changed BEFORE UPDATE OF made_on ON document WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'made_on: a day is written YYYY-MM-DD') WHERE NEW.made_on <> '' AND date(NEW.made_on, '+0 days') IS NOT NEW.made_on;
END;

CREATE TRIGGER surface_days_inserted BEFORE INSERT ON surface WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'first_day: a day is written YYYY-MM-DD') WHERE NEW.first_day <> '' AND date(NEW.first_day, '+0 days') IS NOT NEW.first_day;
  SELECT RAISE(ABORT, 'last_day: a day is written YYYY-MM-DD') WHERE NEW.last_day <> '' AND date(NEW.last_day, '+0 days') IS NOT NEW.last_day;
END;
CREATE TRIGGER surface_days_changed BEFORE UPDATE OF first_day, last_day ON surface WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'first_day: a day is written YYYY-MM-DD') WHERE NEW.first_day <> '' AND date(NEW.first_day, '+0 days') IS NOT NEW.first_day;
  SELECT RAISE(ABORT, 'last_day: a day is written YYYY-MM-DD') WHERE NEW.last_day <> '' AND date(NEW.last_day, '+0 days') IS NOT NEW.last_day;
END;

CREATE TRIGGER section_days_inserted BEFORE INSERT ON section WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'day: a day is written YYYY-MM-DD') WHERE NEW.day <> '' AND date(NEW.day, '+0 days') IS NOT NEW.day;
END;
CREATE TRIGGER section_days_changed BEFORE UPDATE OF day ON section WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'day: a day is written YYYY-MM-DD') WHERE NEW.day <> '' AND date(NEW.day, '+0 days') IS NOT NEW.day;
END;

CREATE TRIGGER scan_days_inserted BEFORE INSERT ON scan WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'day: a day is written YYYY-MM-DD') WHERE NEW.day <> '' AND date(NEW.day, '+0 days') IS NOT NEW.day;
END;
CREATE TRIGGER scan_days_changed BEFORE UPDATE OF day ON scan WHEN (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'day: a day is written YYYY-MM-DD') WHERE NEW.day <> '' AND date(NEW.day, '+0 days') IS NOT NEW.day;
END;

-- The layers of points hold points with height, as gpkg_geometry_columns says: a header without envelope, then the
-- type in either byte order.
CREATE TRIGGER level_place_inserted BEFORE INSERT ON level WHEN NEW.geom IS NOT NULL AND (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'geom: it is no point with a height')
    WHERE substr(hex(NEW.geom), 7, 1) <> '0' OR substr(hex(NEW.geom), 8, 1) NOT IN ('0', '1')
      OR substr(hex(NEW.geom), 17, 10) NOT IN ('01E9030000', '00000003E9');
END;

CREATE TRIGGER level_place_changed BEFORE UPDATE OF geom ON level WHEN NEW.geom IS NOT NULL AND (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'geom: it is no point with a height')
    WHERE substr(hex(NEW.geom), 7, 1) <> '0' OR substr(hex(NEW.geom), 8, 1) NOT IN ('0', '1')
      OR substr(hex(NEW.geom), 17, 10) NOT IN ('01E9030000', '00000003E9');
END;

CREATE TRIGGER find_place_inserted BEFORE INSERT ON find WHEN NEW.geom IS NOT NULL AND (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'geom: it is no point with a height')
    WHERE substr(hex(NEW.geom), 7, 1) <> '0' OR substr(hex(NEW.geom), 8, 1) NOT IN ('0', '1')
      OR substr(hex(NEW.geom), 17, 10) NOT IN ('01E9030000', '00000003E9');
END;

CREATE TRIGGER find_place_changed BEFORE UPDATE OF geom ON find WHEN NEW.geom IS NOT NULL AND (SELECT change FROM planum_context) IS NULL BEGIN
  SELECT RAISE(ABORT, 'geom: it is no point with a height')
    WHERE substr(hex(NEW.geom), 7, 1) <> '0' OR substr(hex(NEW.geom), 8, 1) NOT IN ('0', '1')
      OR substr(hex(NEW.geom), 17, 10) NOT IN ('01E9030000', '00000003E9');
END;

UPDATE planum_meta SET value = '3' WHERE key = 'schema_version';
