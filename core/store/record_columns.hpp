// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <string_view>
#include <type_traits>

#include "core/model/record.hpp"

namespace planum::store {

/// Which column holds which member, said once for writing, reading and the SQL itself: every
/// describe_columns() walks a value in the order of its columns and hands each member to a visitor
/// (ColumnNames, RowBinder, RowReader). The id is not walked; it is the row's uuid.
template<class A, class B>
concept Is = std::same_as<std::remove_const_t<A>, B>;

/// Table of a type, and what its records are called in messages.
template<class Value>
struct TableOf;

#define PLANUM_STORE_TABLE(Type, table, noun_text)                                                                     \
    template<>                                                                                                         \
    struct TableOf<model::Type> {                                                                                      \
        static constexpr std::string_view name = table;                                                                \
        static constexpr std::string_view noun = noun_text;                                                            \
    };

PLANUM_STORE_TABLE(ProjectSettings, "project", "project")
PLANUM_STORE_TABLE(Area, "area", "area")
PLANUM_STORE_TABLE(StratigraphicUnit, "unit", "unit")
PLANUM_STORE_TABLE(PhysicalRelation, "relation", "relation")
PLANUM_STORE_TABLE(RelationStatement, "relation_statement", "statement")
PLANUM_STORE_TABLE(Source, "source", "source")
PLANUM_STORE_TABLE(ImportNote, "import_note", "import note")
PLANUM_STORE_TABLE(Period, "period", "period")
PLANUM_STORE_TABLE(Phase, "phase", "phase")
PLANUM_STORE_TABLE(UnitGroup, "unit_group", "group")
PLANUM_STORE_TABLE(Dating, "dating", "dating")
PLANUM_STORE_TABLE(Level, "level", "level")
PLANUM_STORE_TABLE(Find, "find", "find")
PLANUM_STORE_TABLE(Sample, "sample", "sample")
PLANUM_STORE_TABLE(Document, "document", "document")
PLANUM_STORE_TABLE(Surface, "surface", "surface")
PLANUM_STORE_TABLE(Section, "section", "section")
PLANUM_STORE_TABLE(Region, "region", "region")
PLANUM_STORE_TABLE(Scan, "scan", "scan")
PLANUM_STORE_TABLE(ScanPose, "scan_pose", "pose")
PLANUM_STORE_TABLE(RegistrationRun, "registration_run", "registration run")
PLANUM_STORE_TABLE(Decision, "decision", "decision")
PLANUM_STORE_TABLE(Interpretation, "interpretation", "interpretation")

#undef PLANUM_STORE_TABLE

template<class Visitor, Is<model::ProjectSettings> T>
void describe_columns(Visitor& v, T& p) {
    v.text("name", p.name);
    v.integer("srs_id", p.srs_id);
    v.real("tolerance", p.tolerance);
    v.word("method", p.method);
    v.word("numbers", p.numbers);
    v.word("strictness", p.strictness);
}

template<class Visitor, Is<model::Area> T>
void describe_columns(Visitor& v, T& a) {
    v.text("name", a.name);
    v.text("title", a.title);
    v.word("method", a.method);
    v.text("first_number", a.first_number);
    v.text("last_number", a.last_number);
}

template<class Visitor, Is<model::StratigraphicUnit> T>
void describe_columns(Visitor& v, T& u) {
    v.text("number", u.number);
    v.reference("area", u.area);
    v.word("kind", u.kind);
    v.word("form", u.form);
    v.word("status", u.status);
    v.word("origin", u.origin);
    v.text("title", u.title);
    v.text("description", u.description);
    v.text("interpretation", u.interpretation);
    v.text("excavated_from", u.excavated_from);
    v.text("excavated_on", u.excavated_on);
    v.text("recorded_by", u.recorded_by);
    v.text("recorded_on", u.recorded_on);
    v.reference("phase", u.phase);
    v.reference("period", u.period);
    v.reference("parent", u.parent);
    v.details(u.details);
}

template<class Visitor, Is<model::PhysicalRelation> T>
void describe_columns(Visitor& v, T& r) {
    v.reference("subject", r.subject);
    v.word("kind", r.kind);
    v.reference("object", r.object);
    v.word("certainty", r.certainty);
    v.boolean("correlation", r.correlation);
}

template<class Visitor, Is<model::RelationStatement> T>
void describe_columns(Visitor& v, T& s) {
    v.reference("relation", s.relation);
    v.word("side", s.side);
    v.reference("source", s.source);
    v.integer("line", s.line);
    v.text("person", s.person);
    v.text("raw_text", s.raw_text);
    v.text("stated_at", s.stated_at);
}

template<class Visitor, Is<model::Source> T>
void describe_columns(Visitor& v, T& s) {
    v.text("name", s.name);
    v.text("format", s.format);
    v.text("sha256", s.sha256);
    v.text("imported_at", s.imported_at);
    v.boolean("states_both_sides", s.states_both_sides);
}

template<class Visitor, Is<model::ImportNote> T>
void describe_columns(Visitor& v, T& n) {
    v.reference("source", n.source);
    v.integer("line", n.line);
    v.text("code", n.code);
    v.text("raw_text", n.raw_text);
    v.text("message", n.message);
}

template<class Visitor, Is<model::Period> T>
void describe_columns(Visitor& v, T& p) {
    v.text("number", p.number);
    v.text("title", p.title);
    v.text("description", p.description);
    v.integer("year_from", p.from);
    v.integer("year_to", p.to);
    v.integer("rank", p.rank);
}

template<class Visitor, Is<model::Phase> T>
void describe_columns(Visitor& v, T& p) {
    v.text("number", p.number);
    v.text("title", p.title);
    v.text("description", p.description);
    v.reference("period", p.period);
    v.integer("year_from", p.from);
    v.integer("year_to", p.to);
    v.integer("rank", p.rank);
}

/// Members live in a table of their own.
template<class Visitor, Is<model::UnitGroup> T>
void describe_columns(Visitor& v, T& g) {
    v.text("number", g.number);
    v.text("type", g.type);
    v.text("title", g.title);
    v.text("description", g.description);
    v.reference("parent", g.parent);
}

template<class Visitor, Is<model::Dating> T>
void describe_columns(Visitor& v, T& d) {
    v.text("label", d.label);
    v.reference("unit", d.unit);
    v.reference("find", d.find);
    v.word("kind", d.kind);
    v.integer("year_from", d.from);
    v.integer("year_to", d.to);
    v.real("bp", d.bp);
    v.real("bp_error", d.bp_error);
    v.text("association", d.association);
    v.text("notes", d.notes);
}

template<class Visitor, Is<model::Level> T>
void describe_columns(Visitor& v, T& l) {
    v.reference("unit", l.unit);
    v.position(l.x, l.y, l.z);
    v.word("role", l.role);
    v.text("label", l.label);
}

template<class Visitor, Is<model::Find> T>
void describe_columns(Visitor& v, T& f) {
    v.text("number", f.number);
    v.reference("unit", f.unit);
    v.position(f.x, f.y, f.z);
    v.text("type", f.type);
    v.text("material", f.material);
    v.integer("count", f.count);
    v.real("weight", f.weight);
    v.text("condition", f.condition);
    v.text("box", f.box);
    v.text("found_on", f.found_on);
    v.text("description", f.description);
}

template<class Visitor, Is<model::Sample> T>
void describe_columns(Visitor& v, T& s) {
    v.text("number", s.number);
    v.reference("unit", s.unit);
    v.text("type", s.type);
    v.real("volume", s.volume);
    v.real("weight", s.weight);
    v.text("laboratory_number", s.laboratory_number);
    v.text("state", s.state);
    v.text("description", s.description);
}

template<class Visitor, Is<model::Document> T>
void describe_columns(Visitor& v, T& d) {
    v.text("number", d.number);
    v.text("type", d.type);
    v.text("title", d.title);
    v.reference("unit", d.unit);
    v.text("path", d.path);
    v.text("made_on", d.made_on);
    v.text("author", d.author);
}

template<class Visitor, Is<model::Surface> T>
void describe_columns(Visitor& v, T& s) {
    v.reference("area", s.area);
    v.text("name", s.name);
    v.word("method", s.method);
    v.text("first_day", s.first_day);
    v.text("last_day", s.last_day);
    v.integer("place", s.order);
}

template<class Visitor, Is<model::Section> T>
void describe_columns(Visitor& v, T& s) {
    v.reference("area", s.area);
    v.text("name", s.name);
    v.line(s.from_in_site, s.to_in_site);
    v.text("day", s.day);
}

template<class Visitor, Is<model::Region> T>
void describe_columns(Visitor& v, T& r) {
    v.reference("surface", r.surface);
    v.reference("section", r.section);
    v.reference("unit", r.unit);
    v.text("unit_as_drawn", r.unit_as_drawn);
    v.integer("part", r.part);
    v.word("category", r.category);
    v.word("shows", r.shows);
    v.real("sigma", r.sigma);
    v.text("drawn_on", r.drawn_on);
    v.outline(r.outline, r.has_heights);
    v.reference("seen_in", r.seen_in);
    v.text("notes", r.notes);
}

template<class Visitor, Is<model::Scan> T>
void describe_columns(Visitor& v, T& s) {
    v.text("name", s.name);
    v.text("day", s.day);
    v.reference("surface", s.surface);
    v.text("path", s.path);
    v.text("sha256", s.sha256);
    v.text("format", s.format);
    v.integer("cloud", s.cloud);
    v.integer("points", s.points);
    v.integer("rows", s.rows);
    v.integer("columns", s.columns);
    v.text("sensor", s.sensor);
    v.text("acquired_at", s.acquired_at);
    v.numbers("header_pose", s.header_pose);
}

template<class Visitor, Is<model::ScanPose> T>
void describe_columns(Visitor& v, T& p) {
    v.reference("scan", p.scan);
    v.reference("run", p.run);
    v.station(p.site_from_scan);
    v.numbers("site_from_scan", p.site_from_scan);
    v.numbers("covariance", p.covariance);
    v.real("rms", p.rms);
    v.real("overlap", p.overlap);
    v.text("verdict", p.verdict);
}

template<class Visitor, Is<model::RegistrationRun> T>
void describe_columns(Visitor& v, T& r) {
    v.text("name", r.name);
    v.text("made_at", r.made_at);
    v.text("method", r.method);
    v.text("state", r.state);
    v.text("report", r.report);
}

template<class Visitor, Is<model::Decision> T>
void describe_columns(Visitor& v, T& d) {
    v.text("subject_id", d.subject_id);
    v.text("kind", d.kind);
    v.text("verdict", d.verdict);
    v.text("because", d.because);
    v.text("evidence_hash", d.evidence_hash);
    v.real("area", d.area);
    v.text("author", d.author);
    v.text("made_at", d.made_at);
}

/// Added and dropped relations live in tables of their own.
template<class Visitor, Is<model::Interpretation> T>
void describe_columns(Visitor& v, T& i) {
    v.text("name", i.name);
    v.reference("parent", i.parent);
    v.text("author", i.author);
    v.text("made_at", i.made_at);
}

} // namespace planum::store
