// SPDX-License-Identifier: MIT
#include "gui/viewmodels/sentences.hpp"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "gui/viewmodels/sentence_form.hpp"

namespace planum::gui {

namespace {

constexpr int kDeepest = 6; // sentences within sentences

// The sentences of strat/checks, app/suggestions, app/regions/ready_patches and core/model/relation.cpp; `%1` stands
// where they put something in. tests/gui/gui_viewmodels/sentences_test.cpp holds them to what checks say.
constexpr std::array kSentences = {
    QT_TRANSLATE_NOOP("sentences", "%1 covers %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 cuts %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 fills %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 abuts %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 bonds with %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 is the same as %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 borders %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 is later than %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 is contemporary with %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 and %2 more"),
    QT_TRANSLATE_NOOP("sentences", "%1 and %2 steps more"),
    QT_TRANSLATE_NOOP("sentences", "%1 BCE"),
    QT_TRANSLATE_NOOP("sentences", "%1 CE"),
    QT_TRANSLATE_NOOP("sentences", "terminus post quem"),
    QT_TRANSLATE_NOOP("sentences", "terminus ante quem"),
    QT_TRANSLATE_NOOP("sentences", "terminus post quem %1"),
    QT_TRANSLATE_NOOP("sentences", "terminus ante quem %1"),
    QT_TRANSLATE_NOOP("sentences", "phase %1"),
    QT_TRANSLATE_NOOP("sentences", "period %1"),
    QT_TRANSLATE_NOOP("sentences", "phase %1 of period %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 (%2 to %3)"),
    QT_TRANSLATE_NOOP("sentences", "%1 (from %2)"),
    QT_TRANSLATE_NOOP("sentences", "%1 (until %2)"),
    QT_TRANSLATE_NOOP("sentences", "%1 (%2 for %3?)"),
    QT_TRANSLATE_NOOP("sentences", "%1 (two units under one number?)"),
    QT_TRANSLATE_NOOP("sentences", "%1 units lie above one another in a circle: %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 units lie above one another in a circle once same-as is applied: %2"),
    QT_TRANSLATE_NOOP("sentences", "%1; nothing in the record tells which of these is wrong"),
    QT_TRANSLATE_NOOP("sentences", "%1; most suspect: %2"),
    QT_TRANSLATE_NOOP("sentences",
                      "the outline of %1 on %2 near %3 %4 reaches %5 away from all set-ups of the scanner: "
                      "plans leave it out and nothing is concluded from it; is it in other coordinates "
                      "than the site?"),
    QT_TRANSLATE_NOOP("sentences", "%1 and %2 both claim %3 m² near %4 %5: neither gets that ground, and nothing is "
                                   "concluded from it until one of the outlines is redrawn"),
    QT_TRANSLATE_NOOP("sentences", "%1, yet same-as makes the two one unit"),
    QT_TRANSLATE_NOOP("sentences", "without it the two are two units"),
    QT_TRANSLATE_NOOP("sentences", "a unit cannot lie above itself"),
    QT_TRANSLATE_NOOP("sentences", "in its favour: %1"),
    QT_TRANSLATE_NOOP("sentences", "every circle passes through %1, and no single relation breaks them all: probably "
                                   "two units under one number, to be split"),
    QT_TRANSLATE_NOOP("sentences", "no circle is left when %1 and %2 are two units"),
    QT_TRANSLATE_NOOP("sentences", "without it some circles are gone, but not all"),
    QT_TRANSLATE_NOOP("sentences", "without it no circle is left"),
    QT_TRANSLATE_NOOP("sentences", "it is one of %1 relations without which no circle is left"),
    QT_TRANSLATE_NOOP("sentences", "doubting it instead would do as well"),
    QT_TRANSLATE_NOOP("sentences", "doubting it instead would also break a circle"),
    QT_TRANSLATE_NOOP("sentences", "%1 is probably meant instead of %2: %3"),
    QT_TRANSLATE_NOOP("sentences", "the sheet of %1 states this relation with %2, whose own sheet names %3 instead"),
    QT_TRANSLATE_NOOP("sentences", "%1, one slip of the pen away, lies nearer to %2 and would close no circle"),
    QT_TRANSLATE_NOOP("sentences", "both sheets state it"),
    QT_TRANSLATE_NOOP("sentences", "only one of the two sheets states it, where most relations stand on both"),
    QT_TRANSLATE_NOOP("sentences", "only one of the two sheets states it"),
    QT_TRANSLATE_NOOP("sentences", "the upper unit was dug first"),
    QT_TRANSLATE_NOOP("sentences", "the lower unit was dug before the upper one"),
    QT_TRANSLATE_NOOP("sentences", "numbers of this site grow downwards as a rule, here it is the other way round"),
    QT_TRANSLATE_NOOP("sentences", "the numbers follow each other as on the rest of the site"),
    QT_TRANSLATE_NOOP("sentences", "the levels lie the other way round than between such units as a rule"),
    QT_TRANSLATE_NOOP("sentences", "the levels lie as they should"),
    QT_TRANSLATE_NOOP("sentences", "the two units lie far apart in plan"),
    QT_TRANSLATE_NOOP("sentences", "the two units lie close together in plan"),
    QT_TRANSLATE_NOOP("sentences", "the two numbers are further apart than those of units that touch as a rule"),
    QT_TRANSLATE_NOOP("sentences", "the two numbers are close together"),
    QT_TRANSLATE_NOOP("sentences", "a cut or fill is hard to see the wrong way round"),
    QT_TRANSLATE_NOOP("sentences", "which of two deposits leans on the other is easily mistaken"),
    QT_TRANSLATE_NOOP("sentences", "leaning and age alone are weaker observations than covering"),
    QT_TRANSLATE_NOOP("sentences", "it is marked as uncertain"),
    QT_TRANSLATE_NOOP("sentences", "the kinds of the two units do not fit it"),
    QT_TRANSLATE_NOOP("sentences", "the levels of the two units exclude it"),
    QT_TRANSLATE_NOOP("sentences", "the levels of the two units confirm it"),
    QT_TRANSLATE_NOOP("sentences", "the dates of the two units exclude it"),
    QT_TRANSLATE_NOOP("sentences", "the dates of the two units agree with it"),
    QT_TRANSLATE_NOOP("sentences", "the phases of the two units exclude it"),
    QT_TRANSLATE_NOOP("sentences", "the phases of the two units agree with it"),
    QT_TRANSLATE_NOOP("sentences", "the recorded surfaces show it"),
    QT_TRANSLATE_NOOP("sentences", "the recorded surfaces show the opposite"),
    QT_TRANSLATE_NOOP("sentences", "another sheet, one slip of the pen away, states what this one seems to mean"),
    QT_TRANSLATE_NOOP("sentences", "it is a correlation across a gap, not one unit seen twice"),
    QT_TRANSLATE_NOOP("sentences", "the two units lie in different areas"),
    QT_TRANSLATE_NOOP("sentences", "the two units are of different kinds"),
    QT_TRANSLATE_NOOP("sentences", "the dates of the two units exclude each other"),
    QT_TRANSLATE_NOOP("sentences", "%1: a unit cannot lie above itself; probably another number was meant"),
    QT_TRANSLATE_NOOP("sentences", "%1, and %2: one of the two is wrong"),
    QT_TRANSLATE_NOOP("sentences", "%1, yet %2 puts one after the other"),
    QT_TRANSLATE_NOOP("sentences", "%1: one contact stated as two kinds; the order is the same"),
    QT_TRANSLATE_NOOP("sentences", "%1 is written twice on one sheet (lines %2 and %3)"),
    QT_TRANSLATE_NOOP("sentences",
                      "%1 follows from other relations; it is kept as evidence and left out of the drawing"),
    QT_TRANSLATE_NOOP("sentences",
                      "%1 relations follow from others; they are kept as evidence and left out of the drawing"),
    QT_TRANSLATE_NOOP("sentences", "%1: its base at %2 lies %3 above its top at %4"),
    QT_TRANSLATE_NOOP("sentences", "%1, measured at the same place"),
    QT_TRANSLATE_NOOP("sentences", "%1, but the %2 of %3 (%4) is %5 higher than the %6 of %7 (%8)"),
    QT_TRANSLATE_NOOP("sentences", "%1, but the %2 of %3 (%4) is %5 lower than the %6 of %7 (%8)"),
    QT_TRANSLATE_NOOP("sentences", "highest level on top"),
    QT_TRANSLATE_NOOP("sentences", "lowest level at the base"),
    QT_TRANSLATE_NOOP("sentences", "deepest level"),
    QT_TRANSLATE_NOOP("sentences",
                      "find %1 is recorded in %2, which is a cut and can hold nothing; it belongs to a fill"),
    QT_TRANSLATE_NOOP("sentences", "find %1 at %2 lies %3 above the top of %4 (%5)"),
    QT_TRANSLATE_NOOP("sentences", "find %1 at %2 lies %3 below the base of %4 (%5)"),
    QT_TRANSLATE_NOOP("sentences", "%1, but in the section %2 lies on %3 along %4 m: the relation is the wrong way "
                                   "round, or an outline carries the wrong number"),
    QT_TRANSLATE_NOOP("sentences", "%1, but over %2 m² %3 lay above %4, which came out %5 m lower: the relation is the "
                                   "wrong way round, or an outline carries the wrong number, or %6 was dug before %7"),
    QT_TRANSLATE_NOOP("sentences", "levels do not decide it"),
    QT_TRANSLATE_NOOP("sentences", "levels agree, which proves nothing for a cut or a fill"),
    QT_TRANSLATE_NOOP("sentences", "no levels of one of the units"),
    QT_TRANSLATE_NOOP("sentences", "no levels of either unit"),
    QT_TRANSLATE_NOOP("sentences", "abutting says nothing about heights"),
    QT_TRANSLATE_NOOP("sentences", "stated in time only"),
    QT_TRANSLATE_NOOP("sentences", "the levels of one unit contradict themselves"),
    QT_TRANSLATE_NOOP("sentences", "the find may be intrusive, or the relation wrong"),
    QT_TRANSLATE_NOOP("sentences", "the sample may be intrusive, or the relation wrong"),
    QT_TRANSLATE_NOOP("sentences", "one of the dates or the relation is wrong"),
    QT_TRANSLATE_NOOP("sentences", "%1, but %2 is not later than %3 (%4) and %5 not earlier than %6 (%7): %8"),
    QT_TRANSLATE_NOOP("sentences",
                      "%1 holds dates that exclude each other: not earlier than %2 (%3), not later than %4 (%5); %6"),
    QT_TRANSLATE_NOOP("sentences", "%1, but %2 belongs to %3 and %4 to %5, which is later"),
    QT_TRANSLATE_NOOP("sentences", "%1, but %2 was dug out on %3, before %4 was dug on %5: the relation, a date or the "
                                   "sequence of digging is wrong"),
    QT_TRANSLATE_NOOP("sentences", "%1, but %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 is recorded as %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 is recorded as %2 and %3 as %4"),
    QT_TRANSLATE_NOOP("sentences", "%1; only a cut or a feature cuts"),
    QT_TRANSLATE_NOOP("sentences", "%1; a cut fills nothing"),
    QT_TRANSLATE_NOOP("sentences", "%1; only cuts, features and structures are filled"),
    QT_TRANSLATE_NOOP("sentences", "%1; only what was built bonds"),
    QT_TRANSLATE_NOOP("sentences", "%1; a cut has no body that could lie or lean on anything"),
    QT_TRANSLATE_NOOP("sentences", "deposit"),
    QT_TRANSLATE_NOOP("sentences", "cut"),
    QT_TRANSLATE_NOOP("sentences", "feature"),
    QT_TRANSLATE_NOOP("sentences", "structure"),
    QT_TRANSLATE_NOOP("sentences", "interface"),
    QT_TRANSLATE_NOOP("sentences", "skeleton"),
    QT_TRANSLATE_NOOP("sentences", "natural"),
    QT_TRANSLATE_NOOP("sentences", "void"),
    QT_TRANSLATE_NOOP("sentences", "%1 is a fill, but no cut is named that it fills"),
    QT_TRANSLATE_NOOP("sentences", "%1 is a cut, but nothing is recorded that fills it"),
    QT_TRANSLATE_NOOP("sentences", "%1 is a cut, but nothing is recorded that it cuts"),
    QT_TRANSLATE_NOOP("sentences",
                      "%1, but %2 is natural ground; nothing made by people lies below it unless it was moved"),
    QT_TRANSLATE_NOOP("sentences", "number %1 is given to %2 units (%3), though numbers are unique on this site"),
    QT_TRANSLATE_NOOP("sentences", "%1 stands in area %2, whose numbers run from %3 to %4"),
    QT_TRANSLATE_NOOP("sentences", "%1: %2 of %3 relations stand on one of the two sheets only, among them: %4"),
    QT_TRANSLATE_NOOP("sentences", "%1: one of %2 relations stands on one of the two sheets only: %3"),
    QT_TRANSLATE_NOOP("sentences", "%1 is named in a relation (%2) but has no sheet of its own"),
    QT_TRANSLATE_NOOP("sentences", "%1: the %2 of %3 is %4 here and was %5 before; the first is kept"),
    QT_TRANSLATE_NOOP("sentences", "%1 stands in no order to any other unit"),
    QT_TRANSLATE_NOOP("sentences", "%1 units stand in no order to any other unit, among them %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 scans are placed poorly, among them %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 units are named in relations but have no sheet of their own, among them %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 stands where it does only to %2 mm and %3 degrees: %4"),
    QT_TRANSLATE_NOOP("sentences", "the run says no more"),
    QT_TRANSLATE_NOOP("sentences", "%1 patches of ground on which scans of one surface disagree, among them %2"),
    QT_TRANSLATE_NOOP(
        "sentences",
        "%1, but over %2 m² the bare cut %3 came out where %4 had been, %5 m lower: %6, or %7 cuts %8 from "
        "beside"),
    QT_TRANSLATE_NOOP("sentences", "%1 patches of ground rose, among them %2"),
    QT_TRANSLATE_NOOP("sentences", "ground without a unit"),
    QT_TRANSLATE_NOOP(
        "sentences", "on %1 scans disagree over %2 m² of %3 near %4 at %5 to %6 m: %7 shows it %8 m higher than %9; it "
                     "changed between the two, or one of them is misplaced"),
    QT_TRANSLATE_NOOP("sentences",
                      "on %1 %2 m² of %3 near %4 at %5 to %6 m lay %7 m higher than on %8: heaped up, filled in, or a "
                      "scan is misplaced; nothing is concluded there until it is below its former height"),
    QT_TRANSLATE_NOOP("sentences", "on %1 %2 of %3 lay bare where %4 had been on %5, %6 lower"),
    QT_TRANSLATE_NOOP("sentences", "on %1 %2 of the cut %3 lay bare where %4 had been on %5, %6 lower"),
    QT_TRANSLATE_NOOP("sentences", "the cut %1 was empty on %2; on %3 %4 of %5 lay %6 below its bottom"),
    QT_TRANSLATE_NOOP("sentences",
                      "on %1 %2 of %3 lay bare where %4 had been on %5, too little lower for the heights to tell"),
    QT_TRANSLATE_NOOP("sentences", "from %1 to %2 the line between %3 and %4 moved into %5 over %6 while the ground "
                                   "went down %7: %8 dips flat under %9"),
    QT_TRANSLATE_NOOP("sentences", "where %1 was on %2, %3 of %4 came out on %5, %6 lower"),
    QT_TRANSLATE_NOOP("sentences", "%1 lies inside %2 and became smaller by %3 from %4 to %5, %6 lower"),
    QT_TRANSLATE_NOOP("sentences", "on %1 %2 of the natural ground %3 lay bare where %4 had been on %5, %6 lower"),
    QT_TRANSLATE_NOOP("sentences", "%1 first showed on %2, in %3 where %4 had been on %5: was it covered by %6, or was "
                                   "it there already and seen too late? Look at the section"),
    QT_TRANSLATE_NOOP(
        "sentences",
        "%1 grew into %2 by %3 from %4 to %5: is it covered by %6, or undercut into it? Look at the section"),
    QT_TRANSLATE_NOOP(
        "sentences",
        "on %1 %2 of %3 came out where %4 had been on %5, and one of the two is built: which was there first?"),
    QT_TRANSLATE_NOOP("sentences", "on %1 %2 of the cut %3 lay below where %4 had been on %5: did %6 lie in or over "
                                   "it, or was it the roof of a hollow that reaches under it?"),
    QT_TRANSLATE_NOOP("sentences",
                      "on %1 %2 of %3 lay where %4 had been on %5, but only along the outlines: did they touch there?"),
    QT_TRANSLATE_NOOP("sentences", "%1; the record puts %2 above %3: one of the two is wrong"),
    QT_TRANSLATE_NOOP("sentences", "%1; the record has %2 above %3 and %4 above %5: one of the two is wrong"),
    QT_TRANSLATE_NOOP("sentences", "%1 January %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 February %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 March %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 April %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 May %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 June %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 July %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 August %2"),
    QT_TRANSLATE_NOOP("sentences", "the ground came up by %1 m: spoil, backfill, a slump or something put down"),
    QT_TRANSLATE_NOOP("sentences", "no unit was outlined here before, so the record says nothing of what lies below"),
    QT_TRANSLATE_NOOP("sentences", "%1 is outlined beside it and goes on without a step along %2 % of its edge"),
    QT_TRANSLATE_NOOP("sentences", "%1 was dug away here, and %2 is the only unit recorded below it that goes on "
                                   "beside it without a step"),
    QT_TRANSLATE_NOOP("sentences", "%1 was dug away here, and %2 is the only unit recorded below it that was not "
                                   "outlined yet"),
    QT_TRANSLATE_NOOP("sentences", "%1 was dug away here, and %2 is the only unit recorded below it"),
    QT_TRANSLATE_NOOP("sentences", "%1 was dug away here; the record has no unit below it"),
    QT_TRANSLATE_NOOP("sentences", "%1 was dug away here; recorded below it are %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 September %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 October %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 November %2"),
    QT_TRANSLATE_NOOP("sentences", "%1 December %2"),
};

// Sentences that send people to the command line, and what the window says instead.
struct Reworded {
    const char* said;
    const char* here;
};

constexpr std::array kReworded = {
    Reworded{"%1 scans are not on the site grid (planum register), among them %2",
             QT_TRANSLATE_NOOP("sentences", "%1 scans are not on the site grid, among them %2")},
    Reworded{"%1 is not on the site grid, so nothing can be concluded from it; planum register SITE says why",
             QT_TRANSLATE_NOOP("sentences", "%1 is not on the site grid, so nothing can be concluded from it; Register "
                                            "in the list of scans says why")},
    Reworded{"surface %1 of %2 stands before %3 of %4 in the order of surfaces, though its day is later: nothing is "
             "concluded from either until they are put in their order (planum surface set --order)",
             QT_TRANSLATE_NOOP("sentences",
                               "surface %1 of %2 stands before %3 of %4 in the order of surfaces, though its day is "
                               "later: nothing is concluded from either until they are put in their order (Finds and "
                               "lists › Surfaces › Place in time)")},
};

constexpr std::array kEvidence = {
    std::pair{"above_dug", QT_TRANSLATE_NOOP("evidence", "upper one dug")},
    std::pair{"area_m2", QT_TRANSLATE_NOOP("evidence", "area [m²]")},
    std::pair{"base_m", QT_TRANSLATE_NOOP("evidence", "base [m]")},
    std::pair{"below_dug", QT_TRANSLATE_NOOP("evidence", "lower one dug")},
    std::pair{"by_years", QT_TRANSLATE_NOOP("evidence", "by years")},
    std::pair{"cannot_tell", QT_TRANSLATE_NOOP("evidence", "cannot tell")},
    std::pair{"count", QT_TRANSLATE_NOOP("evidence", "number")},
    std::pair{"difference_m", QT_TRANSLATE_NOOP("evidence", "difference [m]")},
    std::pair{"direct", QT_TRANSLATE_NOOP("evidence", "direct")},
    std::pair{"earlier_not_before", QT_TRANSLATE_NOOP("evidence", "earlier one not before")},
    std::pair{"exact", QT_TRANSLATE_NOOP("evidence", "exact")},
    std::pair{"file", QT_TRANSLATE_NOOP("evidence", "file")},
    std::pair{"find", QT_TRANSLATE_NOOP("evidence", "find")},
    std::pair{"later_not_after", QT_TRANSLATE_NOOP("evidence", "later one not after")},
    std::pair{"length_m", QT_TRANSLATE_NOOP("evidence", "length [m]")},
    std::pair{"line", QT_TRANSLATE_NOOP("evidence", "line")},
    std::pair{"near", QT_TRANSLATE_NOOP("evidence", "close together")},
    std::pair{"not_after", QT_TRANSLATE_NOOP("evidence", "not after")},
    std::pair{"not_before", QT_TRANSLATE_NOOP("evidence", "not before")},
    std::pair{"note", QT_TRANSLATE_NOOP("evidence", "note")},
    std::pair{"of", QT_TRANSLATE_NOOP("evidence", "of")},
    std::pair{"orders", QT_TRANSLATE_NOOP("evidence", "orders")},
    std::pair{"other_m", QT_TRANSLATE_NOOP("evidence", "other unit [m]")},
    std::pair{"removals", QT_TRANSLATE_NOOP("evidence", "to be removed")},
    std::pair{"scan", QT_TRANSLATE_NOOP("evidence", "scan")},
    std::pair{"sigma_position_m", QT_TRANSLATE_NOOP("evidence", "σ of the place [m]")},
    std::pair{"sigma_rotation_deg", QT_TRANSLATE_NOOP("evidence", "σ of the turn [°]")},
    std::pair{"source", QT_TRANSLATE_NOOP("evidence", "source")},
    std::pair{"steps", QT_TRANSLATE_NOOP("evidence", "steps")},
    std::pair{"text", QT_TRANSLATE_NOOP("evidence", "text")},
    std::pair{"thickness_m", QT_TRANSLATE_NOOP("evidence", "thickness [m]")},
    std::pair{"times", QT_TRANSLATE_NOOP("evidence", "times")},
    std::pair{"tolerance_m", QT_TRANSLATE_NOOP("evidence", "tolerance [m]")},
    std::pair{"top_m", QT_TRANSLATE_NOOP("evidence", "top [m]")},
    std::pair{"unit_m", QT_TRANSLATE_NOOP("evidence", "unit [m]")},
    std::pair{"units", QT_TRANSLATE_NOOP("evidence", "units")},
    std::pair{"years", QT_TRANSLATE_NOOP("evidence", "years")},
};

QString translated(const char* context, const QString& english) {
    return QCoreApplication::translate(context, english.toUtf8().constData());
}

struct KnownForm {
    SentenceForm said;
    QString here;
};

const std::vector<KnownForm>& forms() {
    static const std::vector<KnownForm> all = [] {
        std::vector<KnownForm> made;
        for (const char* english : kSentences) made.push_back({SentenceForm(english), QString::fromUtf8(english)});
        for (const Reworded& one : kReworded) made.push_back({SentenceForm(one.said), QString::fromUtf8(one.here)});
        std::stable_sort(made.begin(), made.end(),
                         [](const KnownForm& a, const KnownForm& b) { return a.said.letters() > b.said.letters(); });
        return made;
    }();
    return all;
}

std::optional<QString> known(const QString& text, int depth);

// `1 covers 2, 2 cuts 3 and 4`: each a sentence or the number of a unit, else it is somebody's own text.
std::optional<QString> known_list(const QString& text, int depth) {
    static const QRegularExpression joint(QStringLiteral(", | and "));
    QString said;
    qsizetype at = 0;
    const auto add = [&](const QString& piece) {
        const auto here = known(piece, depth + 1);
        const bool number = !piece.contains(QLatin1Char(' ')) &&
                            std::any_of(piece.begin(), piece.end(), [](QChar c) { return c.isDigit(); });
        if (!here && !number) return false;
        said += here.value_or(piece);
        return true;
    };
    for (auto it = joint.globalMatch(text); it.hasNext();) {
        const auto found = it.next();
        if (!add(text.mid(at, found.capturedStart() - at))) return std::nullopt;
        said += found.captured() == QLatin1String(", ")
                    ? found.captured()
                    : QLatin1Char(' ') + QCoreApplication::translate("sentences", "and") + QLatin1Char(' ');
        at = found.capturedEnd();
    }
    if (at == 0 || !add(text.mid(at))) return std::nullopt;
    return said;
}

std::optional<QString> known(const QString& text, int depth) {
    if (text.isEmpty() || depth > kDeepest) return std::nullopt;
    for (const KnownForm& form : forms()) {
        auto parts = form.said.fit(text);
        if (!parts) continue;
        for (auto& [place, words] : *parts) {
            auto inner = known_list(words, depth);
            if (!inner) inner = known(words, depth + 1);
            words = inner.value_or(words);
        }
        return filled(translated("sentences", form.here), *parts);
    }
    return std::nullopt;
}

} // namespace

QString in_window_language(const QString& english) {
    const auto said = known(english, 0);
    return said ? with_window_numbers(*said) : english;
}

QString in_window_language(const std::string& english) { return in_window_language(QString::fromStdString(english)); }

QString evidence_word(const std::string& name) {
    for (const auto& [key, english] : kEvidence) {
        if (name == key) return QCoreApplication::translate("evidence", english);
    }
    const QString key = QString::fromStdString(name);
    if (key.startsWith(QLatin1String("cycle_")))
        return QCoreApplication::translate("evidence", "circle %1").arg(key.mid(6));
    return key;
}

} // namespace planum::gui
