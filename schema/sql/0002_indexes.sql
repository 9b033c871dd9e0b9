-- Deleting a unit marks its relations, their statements and what else belongs to it: found by index, not by reading
-- the whole table for each.
CREATE INDEX relation_subject ON relation(subject) WHERE deleted_at IS NULL;
CREATE INDEX relation_object ON relation(object) WHERE deleted_at IS NULL;
CREATE INDEX relation_statement_of ON relation_statement(relation) WHERE deleted_at IS NULL;
CREATE INDEX group_member_unit ON group_member(unit) WHERE deleted_at IS NULL;
CREATE INDEX level_unit ON level(unit) WHERE deleted_at IS NULL;
CREATE INDEX dating_unit ON dating(unit) WHERE deleted_at IS NULL;

-- GDAL warns of an extension of the whole file that it does not know when it opens it for changing; of one that belongs
-- to a table it does not.
UPDATE gpkg_extensions SET table_name = 'project' WHERE extension_name = 'planum_project';

UPDATE planum_meta SET value = '2' WHERE key = 'schema_version';
