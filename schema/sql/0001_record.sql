-- The record of a dig, schema version 1. Rules that hold for every record table:
--   fid         row number for GeoPackage programs; nothing refers to it
--   uuid        identity; foreign keys go by it, none cascades; filled by a trigger when left empty
--   deleted_at  a deleted row stays, with this mark; unique numbers count the living only
-- Empty text is stored as NULL. Heights and lengths are metres, weights grams, volumes litres.

CREATE TABLE planum_meta (
  key TEXT PRIMARY KEY NOT NULL,
  value TEXT NOT NULL
);
INSERT INTO planum_meta VALUES ('schema_version', '1');

-- Who works just now, for the audit triggers. One row, empty unless Planum is inside a change.
CREATE TABLE planum_context (
  fid INTEGER PRIMARY KEY NOT NULL CHECK (fid = 1),
  author TEXT,
  made_at TEXT,
  change INTEGER
);
INSERT INTO planum_context(fid) VALUES (1);

-- One row a change (one undo step); the rows it touched are a changeset of SQLite's session extension,
-- cut into pieces. state: done, undone (can be made again), dropped (undone and then worked on).
CREATE TABLE planum_change (
  fid INTEGER PRIMARY KEY NOT NULL,
  label TEXT NOT NULL,
  author TEXT,
  made_at TEXT NOT NULL,
  state TEXT NOT NULL CHECK (state IN ('done','undone','dropped'))
);
CREATE TABLE planum_change_chunk (
  fid INTEGER PRIMARY KEY NOT NULL,
  change INTEGER NOT NULL REFERENCES planum_change(fid),
  changeset BLOB NOT NULL
);
CREATE INDEX planum_change_chunk_of ON planum_change_chunk(change);

-- One row an inserted record, one a changed field, whoever made the change.
CREATE TABLE planum_log (
  fid INTEGER PRIMARY KEY NOT NULL,
  made_at TEXT NOT NULL,
  author TEXT NOT NULL,
  action TEXT NOT NULL,
  table_name TEXT NOT NULL,
  record TEXT,
  field TEXT,
  old_value TEXT,
  new_value TEXT,
  change INTEGER
);

CREATE TABLE project (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  name TEXT,
  srs_id INTEGER NOT NULL DEFAULT -1,
  tolerance REAL NOT NULL DEFAULT 0.02 CHECK (tolerance > 0 AND tolerance <= 10),
  method TEXT NOT NULL DEFAULT 'stratigraphic' CHECK (method IN ('stratigraphic','planum','mixed')),
  numbers TEXT NOT NULL DEFAULT 'site' CHECK (numbers IN ('site','area')),
  strictness TEXT NOT NULL DEFAULT 'normal' CHECK (strictness IN ('lenient','normal','strict')),
  deleted_at DATETIME
);

CREATE TABLE area (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  name TEXT NOT NULL CHECK (name <> ''),
  title TEXT,
  method TEXT NOT NULL DEFAULT 'stratigraphic' CHECK (method IN ('stratigraphic','planum','mixed')),
  first_number TEXT,
  last_number TEXT,
  deleted_at DATETIME
);
CREATE UNIQUE INDEX area_name ON area(name) WHERE deleted_at IS NULL;

CREATE TABLE source (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  name TEXT NOT NULL CHECK (name <> ''),
  format TEXT,
  sha256 TEXT,
  imported_at TEXT,
  states_both_sides BOOLEAN NOT NULL DEFAULT 0 CHECK (states_both_sides IN (0,1)),
  deleted_at DATETIME
);
CREATE UNIQUE INDEX source_name ON source(name) WHERE deleted_at IS NULL;

CREATE TABLE import_note (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  source TEXT REFERENCES source(uuid),
  line INTEGER NOT NULL DEFAULT 0,
  code TEXT,
  raw_text TEXT,
  message TEXT,
  deleted_at DATETIME
);

CREATE TABLE period (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  number TEXT NOT NULL CHECK (number <> ''),
  title TEXT,
  description TEXT,
  year_from INTEGER CHECK (typeof(year_from) IN ('integer','null')),
  year_to INTEGER CHECK (typeof(year_to) IN ('integer','null')),
  rank INTEGER,
  deleted_at DATETIME
);
CREATE UNIQUE INDEX period_number ON period(number) WHERE deleted_at IS NULL;

CREATE TABLE phase (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  number TEXT NOT NULL CHECK (number <> ''),
  title TEXT,
  description TEXT,
  period TEXT REFERENCES period(uuid),
  year_from INTEGER CHECK (typeof(year_from) IN ('integer','null')),
  year_to INTEGER CHECK (typeof(year_to) IN ('integer','null')),
  rank INTEGER,
  deleted_at DATETIME
);
CREATE UNIQUE INDEX phase_number ON phase(number, coalesce(period, '')) WHERE deleted_at IS NULL;

CREATE TABLE unit (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  number TEXT NOT NULL CHECK (number <> ''),
  area TEXT REFERENCES area(uuid),
  kind TEXT NOT NULL DEFAULT 'unknown'
    CHECK (kind IN ('unknown','deposit','cut','feature','structure','interface','skeleton','natural','void')),
  form TEXT CHECK (form IN ('layer','fill','masonry','timber','burial')),
  status TEXT NOT NULL DEFAULT 'open'
    CHECK (status IN ('open','partly-excavated','excavated','not-excavated','void')),
  origin TEXT NOT NULL DEFAULT 'recorded' CHECK (origin IN ('recorded','mentioned')),
  title TEXT,
  description TEXT,
  interpretation TEXT,
  excavated_from TEXT,
  excavated_on TEXT,
  recorded_by TEXT,
  recorded_on TEXT,
  phase TEXT REFERENCES phase(uuid),
  period TEXT REFERENCES period(uuid),
  parent TEXT REFERENCES unit(uuid),
  site_code TEXT,
  sector TEXT,
  square TEXT,
  room TEXT,
  position TEXT,
  formation TEXT,
  criteria_of_distinction TEXT,
  mode_of_formation TEXT,
  consistency TEXT,
  colour TEXT,
  munsell TEXT,
  composition TEXT,
  inclusions TEXT,
  organic_components TEXT,
  inorganic_components TEXT,
  thickness TEXT,
  length TEXT,
  width TEXT,
  depth TEXT,
  shape_in_plan TEXT,
  profile TEXT,
  corners TEXT,
  break_of_slope TEXT,
  sides TEXT,
  base TEXT,
  orientation TEXT,
  borders TEXT,
  truncation TEXT,
  preservation TEXT,
  disturbance TEXT,
  masonry_materials TEXT,
  masonry_coursing TEXT,
  masonry_faces TEXT,
  masonry_bonding TEXT,
  timber_type TEXT,
  timber_conversion TEXT,
  timber_marks TEXT,
  skeleton_position TEXT,
  skeleton_completeness TEXT,
  excavation_method TEXT,
  percent_excavated TEXT,
  conditions TEXT,
  sieving TEXT,
  flotation TEXT,
  reliability TEXT,
  activity TEXT,
  dating_evidence TEXT,
  observations TEXT,
  director TEXT,
  checked_by TEXT,
  checked_on TEXT,
  revised_by TEXT,
  revised_on TEXT,
  custom TEXT,
  deleted_at DATETIME
);
-- Number first: the trigger for sites with one series looks numbers up by it alone.
CREATE UNIQUE INDEX unit_number ON unit(number, coalesce(area, '')) WHERE deleted_at IS NULL;

CREATE TABLE relation (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  subject TEXT NOT NULL REFERENCES unit(uuid),
  kind TEXT NOT NULL CHECK (kind IN ('covers','cuts','fills','abuts','bonds_with','same_as','borders',
                                     'later','contemporary')),
  object TEXT NOT NULL REFERENCES unit(uuid),
  certainty TEXT NOT NULL DEFAULT 'certain' CHECK (certainty IN ('certain','uncertain')),
  correlation BOOLEAN NOT NULL DEFAULT 0 CHECK (correlation IN (0,1)),
  deleted_at DATETIME
);

CREATE TABLE relation_statement (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  relation TEXT NOT NULL REFERENCES relation(uuid),
  side TEXT NOT NULL DEFAULT 'subject' CHECK (side IN ('subject','object','neither')),
  source TEXT REFERENCES source(uuid),
  line INTEGER NOT NULL DEFAULT 0,
  person TEXT,
  raw_text TEXT,
  stated_at TEXT,
  deleted_at DATETIME
);

CREATE TABLE unit_group (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  number TEXT NOT NULL CHECK (number <> ''),
  type TEXT,
  title TEXT,
  description TEXT,
  parent TEXT REFERENCES unit_group(uuid),
  deleted_at DATETIME
);

CREATE TABLE group_member (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  unit_group TEXT NOT NULL REFERENCES unit_group(uuid),
  unit TEXT NOT NULL REFERENCES unit(uuid),
  deleted_at DATETIME
);
CREATE UNIQUE INDEX group_member_once ON group_member(unit_group, unit) WHERE deleted_at IS NULL;

-- x and y are filled only where there is no geometry; z is the height itself.
CREATE TABLE level (
  fid INTEGER PRIMARY KEY NOT NULL,
  geom POINT CHECK (substr(geom, 1, 2) = x'4750'),
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  unit TEXT NOT NULL REFERENCES unit(uuid),
  x REAL CHECK (x BETWEEN -1e9 AND 1e9),
  y REAL CHECK (y BETWEEN -1e9 AND 1e9),
  z REAL NOT NULL CHECK (z BETWEEN -100000 AND 100000),
  role TEXT NOT NULL DEFAULT 'top' CHECK (role IN ('top','base','cut','other')),
  label TEXT,
  deleted_at DATETIME
);

CREATE TABLE find (
  fid INTEGER PRIMARY KEY NOT NULL,
  geom POINT CHECK (substr(geom, 1, 2) = x'4750'),
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  number TEXT,
  unit TEXT REFERENCES unit(uuid),
  x REAL CHECK (x BETWEEN -1e9 AND 1e9),
  y REAL CHECK (y BETWEEN -1e9 AND 1e9),
  z REAL CHECK (z BETWEEN -100000 AND 100000),
  type TEXT,
  material TEXT,
  count INTEGER CHECK (typeof(count) IN ('integer','null')),
  weight REAL CHECK (weight BETWEEN -1e12 AND 1e12),
  condition TEXT,
  box TEXT,
  found_on TEXT,
  description TEXT,
  deleted_at DATETIME
);

CREATE TABLE dating (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  label TEXT,
  unit TEXT REFERENCES unit(uuid),
  find TEXT REFERENCES find(uuid),
  kind TEXT NOT NULL DEFAULT 'typed'
    CHECK (kind IN ('typed','find','coin','radiocarbon','post-quem','ante-quem')),
  year_from INTEGER CHECK (typeof(year_from) IN ('integer','null')),
  year_to INTEGER CHECK (typeof(year_to) IN ('integer','null')),
  bp REAL CHECK (bp BETWEEN -1e9 AND 1e9),
  bp_error REAL CHECK (bp_error BETWEEN -1e9 AND 1e9),
  association TEXT,
  notes TEXT,
  deleted_at DATETIME,
  CHECK (unit IS NOT NULL OR find IS NOT NULL)
);

CREATE TABLE sample (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  number TEXT,
  unit TEXT REFERENCES unit(uuid),
  type TEXT,
  volume REAL CHECK (volume BETWEEN -1e12 AND 1e12),
  weight REAL CHECK (weight BETWEEN -1e12 AND 1e12),
  laboratory_number TEXT,
  state TEXT,
  description TEXT,
  deleted_at DATETIME
);

CREATE TABLE document (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  number TEXT,
  type TEXT,
  title TEXT,
  unit TEXT REFERENCES unit(uuid),
  path TEXT,
  made_on TEXT,
  author TEXT,
  deleted_at DATETIME
);

-- place: among the surfaces of its area, ascending in time.
CREATE TABLE surface (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  area TEXT REFERENCES area(uuid),
  name TEXT,
  method TEXT NOT NULL DEFAULT 'stratigraphic' CHECK (method IN ('stratigraphic','planum','mixed')),
  first_day TEXT,
  last_day TEXT,
  place INTEGER NOT NULL DEFAULT 0,
  deleted_at DATETIME
);

CREATE TABLE section (
  fid INTEGER PRIMARY KEY NOT NULL,
  geom LINESTRING CHECK (substr(geom, 1, 2) = x'4750'),
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  area TEXT REFERENCES area(uuid),
  name TEXT,
  day TEXT,
  deleted_at DATETIME
);

CREATE TABLE region (
  fid INTEGER PRIMARY KEY NOT NULL,
  geom MULTIPOLYGON CHECK (substr(geom, 1, 2) = x'4750'),
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  surface TEXT REFERENCES surface(uuid),
  section TEXT REFERENCES section(uuid),
  unit TEXT REFERENCES unit(uuid),
  unit_as_drawn TEXT,
  part INTEGER NOT NULL DEFAULT 1,
  category TEXT NOT NULL DEFAULT 'unit'
    CHECK (category IN ('unit','spoil','slump','backfill','water','equipment','baulk','unexcavated')),
  shows TEXT NOT NULL DEFAULT 'top'
    CHECK (shows IN ('top','level','cut','overdug','machine','face','nothing')),
  sigma REAL NOT NULL DEFAULT 0.03 CHECK (sigma >= 0 AND sigma <= 100),
  drawn_on TEXT,
  seen_in TEXT REFERENCES unit(uuid),
  notes TEXT,
  deleted_at DATETIME
);

CREATE TABLE scan (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  name TEXT NOT NULL CHECK (name <> ''),
  day TEXT,
  surface TEXT REFERENCES surface(uuid),
  path TEXT,
  sha256 TEXT,
  format TEXT,
  cloud INTEGER NOT NULL DEFAULT 0,
  points INTEGER NOT NULL DEFAULT 0,
  rows INTEGER NOT NULL DEFAULT 0,
  columns INTEGER NOT NULL DEFAULT 0,
  sensor TEXT,
  acquired_at TEXT,
  header_pose TEXT,
  deleted_at DATETIME
);
CREATE UNIQUE INDEX scan_name ON scan(name) WHERE deleted_at IS NULL;

CREATE TABLE registration_run (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  name TEXT,
  made_at TEXT,
  method TEXT,
  state TEXT,
  report TEXT,
  deleted_at DATETIME
);

-- The point is the scanner's station; it follows site_from_scan and is only for showing.
-- Matrices are numbers between blanks, row by row.
CREATE TABLE scan_pose (
  fid INTEGER PRIMARY KEY NOT NULL,
  geom POINT CHECK (substr(geom, 1, 2) = x'4750'),
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  scan TEXT NOT NULL REFERENCES scan(uuid),
  run TEXT REFERENCES registration_run(uuid),
  site_from_scan TEXT NOT NULL,
  covariance TEXT,
  rms REAL,
  overlap REAL,
  verdict TEXT,
  deleted_at DATETIME
);
CREATE UNIQUE INDEX scan_pose_once ON scan_pose(scan, coalesce(run, '')) WHERE deleted_at IS NULL;

CREATE TABLE decision (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  subject_id TEXT,
  kind TEXT,
  verdict TEXT,
  because TEXT,
  evidence_hash TEXT,
  area REAL,
  author TEXT,
  made_at TEXT,
  deleted_at DATETIME
);

CREATE TABLE interpretation (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  name TEXT NOT NULL CHECK (name <> ''),
  parent TEXT REFERENCES interpretation(uuid),
  author TEXT,
  made_at TEXT,
  deleted_at DATETIME
);
CREATE UNIQUE INDEX interpretation_name ON interpretation(name) WHERE deleted_at IS NULL;

CREATE TABLE interpretation_added (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  interpretation TEXT NOT NULL REFERENCES interpretation(uuid),
  subject TEXT NOT NULL REFERENCES unit(uuid),
  kind TEXT NOT NULL CHECK (kind IN ('covers','cuts','fills','abuts','bonds_with','same_as','borders',
                                     'later','contemporary')),
  object TEXT NOT NULL REFERENCES unit(uuid),
  certainty TEXT NOT NULL DEFAULT 'certain' CHECK (certainty IN ('certain','uncertain')),
  correlation BOOLEAN NOT NULL DEFAULT 0 CHECK (correlation IN (0,1)),
  deleted_at DATETIME
);

-- relation: of the field record or one that a parent interpretation added, so not a foreign key.
CREATE TABLE interpretation_dropped (
  fid INTEGER PRIMARY KEY NOT NULL,
  uuid TEXT UNIQUE CHECK (length(uuid) = 36),
  interpretation TEXT NOT NULL REFERENCES interpretation(uuid),
  relation TEXT NOT NULL CHECK (length(relation) = 36),
  deleted_at DATETIME
);

INSERT INTO gpkg_contents(table_name, data_type, identifier, description, srs_id) VALUES
  ('region', 'features', 'Regions', 'labelled outlines on surfaces and sections', -1),
  ('find', 'features', 'Finds', 'found things, measured where possible', -1),
  ('level', 'features', 'Levels', 'measured heights of units', -1),
  ('section', 'features', 'Sections', 'vertical planes through two surveyed points', -1),
  ('scan_pose', 'features', 'Scan stations', 'where the scanner stood', -1),
  ('project', 'attributes', 'Project', 'what the project as a whole says', NULL),
  ('area', 'attributes', 'Areas', 'trenches', NULL),
  ('unit', 'attributes', 'Units', 'stratigraphic units', NULL),
  ('relation', 'attributes', 'Relations', 'what was observed between two units', NULL),
  ('relation_statement', 'attributes', 'Relation statements', 'who said it, and where it stands', NULL),
  ('source', 'attributes', 'Sources', 'files that were imported', NULL),
  ('import_note', 'attributes', 'Import notes', 'what could not be understood in them', NULL),
  ('period', 'attributes', 'Periods', '', NULL),
  ('phase', 'attributes', 'Phases', '', NULL),
  ('unit_group', 'attributes', 'Groups', 'units taken together', NULL),
  ('group_member', 'attributes', 'Group members', '', NULL),
  ('dating', 'attributes', 'Datings', '', NULL),
  ('sample', 'attributes', 'Samples', '', NULL),
  ('document', 'attributes', 'Documents', 'photos, drawings, sheets', NULL),
  ('surface', 'attributes', 'Surfaces', 'recorded states of areas', NULL),
  ('scan', 'attributes', 'Scans', 'set-ups of the scanner', NULL),
  ('registration_run', 'attributes', 'Registration runs', '', NULL),
  ('decision', 'attributes', 'Decisions', 'on diagnostics and suggestions', NULL),
  ('interpretation', 'attributes', 'Interpretations', 'readings of the record', NULL),
  ('interpretation_added', 'attributes', 'Relations added by interpretations', '', NULL),
  ('interpretation_dropped', 'attributes', 'Relations dropped by interpretations', '', NULL),
  ('planum_change', 'attributes', 'Changes', 'one row a change', NULL),
  ('planum_log', 'attributes', 'Log', 'one row an inserted record or changed field', NULL),
  ('layer_styles', 'attributes', 'Layer styles', 'how QGIS draws the layers', NULL);

INSERT INTO gpkg_geometry_columns(table_name, column_name, geometry_type_name, srs_id, z, m) VALUES
  ('region', 'geom', 'MULTIPOLYGON', -1, 1, 0),
  ('find', 'geom', 'POINT', -1, 1, 0),
  ('level', 'geom', 'POINT', -1, 1, 0),
  ('section', 'geom', 'LINESTRING', -1, 1, 0),
  ('scan_pose', 'geom', 'POINT', -1, 1, 0);

INSERT INTO gpkg_extensions(table_name, column_name, extension_name, definition, scope) VALUES
  (NULL, NULL, 'planum_project', 'docs/project-file.md of Planum', 'write-only');
