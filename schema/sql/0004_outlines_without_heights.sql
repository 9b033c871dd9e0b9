-- An outline may have no heights: its polygons then have no z. 2 is what the standard calls optional.
UPDATE gpkg_geometry_columns SET z = 2 WHERE table_name = 'region';

UPDATE planum_meta SET value = '4' WHERE key = 'schema_version';
