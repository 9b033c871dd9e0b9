// SPDX-License-Identifier: MIT
#include "gui/viewmodels/record_words.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace planum::gui {

namespace {

using Word = std::pair<std::string_view, const char*>;

constexpr std::array kTitles = {
    Word{"area", QT_TRANSLATE_NOOP("records", "Trenches")},
    Word{"dating", QT_TRANSLATE_NOOP("records", "Dates")},
    Word{"document", QT_TRANSLATE_NOOP("records", "Documents")},
    Word{"find", QT_TRANSLATE_NOOP("records", "Finds")},
    Word{"group", QT_TRANSLATE_NOOP("records", "Groups")},
    Word{"interpretation", QT_TRANSLATE_NOOP("records", "Readings")},
    Word{"level", QT_TRANSLATE_NOOP("records", "Levels")},
    Word{"period", QT_TRANSLATE_NOOP("records", "Periods")},
    Word{"phase", QT_TRANSLATE_NOOP("records", "Phases")},
    Word{"region", QT_TRANSLATE_NOOP("records", "Outlines")},
    Word{"sample", QT_TRANSLATE_NOOP("records", "Samples")},
    Word{"surface", QT_TRANSLATE_NOOP("records", "Surfaces")},
};

constexpr std::array kThings = {
    Word{"area", QT_TRANSLATE_NOOP("records", "trench")},
    Word{"dating", QT_TRANSLATE_NOOP("records", "date")},
    Word{"document", QT_TRANSLATE_NOOP("records", "document")},
    Word{"find", QT_TRANSLATE_NOOP("records", "find")},
    Word{"group", QT_TRANSLATE_NOOP("records", "group")},
    Word{"interpretation", QT_TRANSLATE_NOOP("records", "reading")},
    Word{"level", QT_TRANSLATE_NOOP("records", "level")},
    Word{"period", QT_TRANSLATE_NOOP("records", "period")},
    Word{"phase", QT_TRANSLATE_NOOP("records", "phase")},
    Word{"region", QT_TRANSLATE_NOOP("records", "outline")},
    Word{"sample", QT_TRANSLATE_NOOP("records", "sample")},
    Word{"surface", QT_TRANSLATE_NOOP("records", "surface")},
};

constexpr std::array kLabels = {
    Word{"adds", QT_TRANSLATE_NOOP("records", "Adds")},
    Word{"area", QT_TRANSLATE_NOOP("records", "Trench")},
    Word{"association", QT_TRANSLATE_NOOP("records", "Association")},
    Word{"author", QT_TRANSLATE_NOOP("records", "Author")},
    Word{"box", QT_TRANSLATE_NOOP("records", "Box or bag")},
    Word{"bp", QT_TRANSLATE_NOOP("records", "Radiocarbon age [BP]")},
    Word{"bp-error", QT_TRANSLATE_NOOP("records", "σ of the age [years]")},
    Word{"category", QT_TRANSLATE_NOOP("records", "Category")},
    Word{"condition", QT_TRANSLATE_NOOP("records", "Condition")},
    Word{"count", QT_TRANSLATE_NOOP("records", "How many")},
    Word{"description", QT_TRANSLATE_NOOP("records", "Description")},
    Word{"drops", QT_TRANSLATE_NOOP("records", "Leaves out")},
    Word{"find", QT_TRANSLATE_NOOP("records", "Find")},
    Word{"first-day", QT_TRANSLATE_NOOP("records", "First day")},
    Word{"first-number", QT_TRANSLATE_NOOP("records", "First unit number")},
    Word{"found-on", QT_TRANSLATE_NOOP("records", "Found on")},
    Word{"from", QT_TRANSLATE_NOOP("records", "From [year]")},
    Word{"kind", QT_TRANSLATE_NOOP("records", "Kind")},
    Word{"label", QT_TRANSLATE_NOOP("records", "Label")},
    Word{"laboratory-number", QT_TRANSLATE_NOOP("records", "Laboratory number")},
    Word{"last-day", QT_TRANSLATE_NOOP("records", "Last day")},
    Word{"last-number", QT_TRANSLATE_NOOP("records", "Last unit number")},
    Word{"made-on", QT_TRANSLATE_NOOP("records", "Made on")},
    Word{"material", QT_TRANSLATE_NOOP("records", "Material")},
    Word{"members", QT_TRANSLATE_NOOP("records", "Units")},
    Word{"method", QT_TRANSLATE_NOOP("records", "Method")},
    Word{"notes", QT_TRANSLATE_NOOP("records", "Notes")},
    Word{"order", QT_TRANSLATE_NOOP("records", "Place in time")},
    Word{"outline", QT_TRANSLATE_NOOP("records", "Outline")},
    Word{"parent", QT_TRANSLATE_NOOP("records", "Part of")},
    Word{"path", QT_TRANSLATE_NOOP("records", "File")},
    Word{"period", QT_TRANSLATE_NOOP("records", "Period")},
    Word{"rank", QT_TRANSLATE_NOOP("records", "Rank (1 = earliest)")},
    Word{"role", QT_TRANSLATE_NOOP("records", "Role")},
    Word{"seen-in", QT_TRANSLATE_NOOP("records", "Seen in the side of")},
    Word{"shows", QT_TRANSLATE_NOOP("records", "Shows")},
    Word{"sigma", QT_TRANSLATE_NOOP("records", "σ [m]")},
    Word{"state", QT_TRANSLATE_NOOP("records", "State")},
    Word{"title", QT_TRANSLATE_NOOP("records", "Title")},
    Word{"to", QT_TRANSLATE_NOOP("records", "To [year]")},
    Word{"type", QT_TRANSLATE_NOOP("records", "Type")},
    Word{"unit", QT_TRANSLATE_NOOP("records", "Unit")},
    Word{"volume", QT_TRANSLATE_NOOP("records", "Volume [l]")},
    Word{"weight", QT_TRANSLATE_NOOP("records", "Weight [g]")},
    Word{"z", QT_TRANSLATE_NOOP("records", "Height [m]")},
};

constexpr std::array kNameForms = {
    Word{"area", QT_TRANSLATE_NOOP("records", "name of the trench")},
    Word{"dating", QT_TRANSLATE_NOOP("records", "label of the date")},
    Word{"document", QT_TRANSLATE_NOOP("records", "number of the document")},
    Word{"find", QT_TRANSLATE_NOOP("records", "number of the find")},
    Word{"group", QT_TRANSLATE_NOOP("records", "number of the group")},
    Word{"interpretation", QT_TRANSLATE_NOOP("records", "name of the reading")},
    Word{"level", QT_TRANSLATE_NOOP("records", "unit that was levelled")},
    Word{"period", QT_TRANSLATE_NOOP("records", "number of the period")},
    Word{"phase", QT_TRANSLATE_NOOP("records", "number of the phase")},
    Word{"region", QT_TRANSLATE_NOOP("records", "surface/unit")},
    Word{"sample", QT_TRANSLATE_NOOP("records", "number of the sample")},
    Word{"surface", QT_TRANSLATE_NOOP("records", "name of the surface")},
};

constexpr std::array kValues = {
    Word{"analysed", QT_TRANSLATE_NOOP("records", "analysed")},
    Word{"ante-quem", QT_TRANSLATE_NOOP("records", "terminus ante quem")},
    Word{"backfill", QT_TRANSLATE_NOOP("records", "backfill")},
    Word{"base", QT_TRANSLATE_NOOP("records", "base")},
    Word{"baulk", QT_TRANSLATE_NOOP("records", "baulk")},
    Word{"certain", QT_TRANSLATE_NOOP("records", "certain")},
    Word{"charcoal", QT_TRANSLATE_NOOP("records", "charcoal")},
    Word{"coin", QT_TRANSLATE_NOOP("records", "coin")},
    Word{"cut", QT_TRANSLATE_NOOP("records", "bare cut")},
    Word{"discarded", QT_TRANSLATE_NOOP("records", "discarded")},
    Word{"drawing", QT_TRANSLATE_NOOP("records", "drawing")},
    Word{"equipment", QT_TRANSLATE_NOOP("records", "equipment")},
    Word{"face", QT_TRANSLATE_NOOP("records", "face")},
    Word{"find", QT_TRANSLATE_NOOP("records", "find")},
    Word{"level", QT_TRANSLATE_NOOP("records", "level inside it")},
    Word{"machine", QT_TRANSLATE_NOOP("records", "dug by machine")},
    Word{"mixed", QT_TRANSLATE_NOOP("records", "mixed")},
    Word{"nothing", QT_TRANSLATE_NOOP("records", "nothing of it")},
    Word{"other", QT_TRANSLATE_NOOP("records", "other")},
    Word{"overdug", QT_TRANSLATE_NOOP("records", "dug too deep")},
    Word{"photo", QT_TRANSLATE_NOOP("records", "photo")},
    Word{"planum", QT_TRANSLATE_NOOP("records", "in plana")},
    Word{"pollen", QT_TRANSLATE_NOOP("records", "pollen")},
    Word{"post-quem", QT_TRANSLATE_NOOP("records", "terminus post quem")},
    Word{"radiocarbon", QT_TRANSLATE_NOOP("records", "radiocarbon")},
    Word{"sheet", QT_TRANSLATE_NOOP("records", "sheet")},
    Word{"slump", QT_TRANSLATE_NOOP("records", "slump")},
    Word{"soil", QT_TRANSLATE_NOOP("records", "soil")},
    Word{"spoil", QT_TRANSLATE_NOOP("records", "spoil")},
    Word{"stored", QT_TRANSLATE_NOOP("records", "stored")},
    Word{"stratigraphic", QT_TRANSLATE_NOOP("records", "by stratigraphic units")},
    Word{"submitted", QT_TRANSLATE_NOOP("records", "submitted")},
    Word{"top", QT_TRANSLATE_NOOP("records", "top")},
    Word{"typed", QT_TRANSLATE_NOOP("records", "date of the unit itself")},
    Word{"uncertain", QT_TRANSLATE_NOOP("records", "uncertain")},
    Word{"unexcavated", QT_TRANSLATE_NOOP("records", "not excavated yet")},
    Word{"unit", QT_TRANSLATE_NOOP("records", "unit")},
    Word{"water", QT_TRANSLATE_NOOP("records", "water")},
};

template<class Words>
QString word_for(const Words& words, const QString& name) {
    const std::string key = name.toStdString();
    const auto it = std::find_if(words.begin(), words.end(), [&](const Word& word) { return word.first == key; });
    return it == words.end() ? name : QCoreApplication::translate("records", it->second);
}

} // namespace

QString record_list_title(const QString& kind) { return word_for(kTitles, kind); }

QString record_thing_word(const QString& kind) { return word_for(kThings, kind); }

QString record_field_label(const QString& field) { return word_for(kLabels, field); }

QString record_name_form(const QString& kind) { return word_for(kNameForms, kind); }

QString record_value_word(const QString& kind, const QString& field, const QString& stored) {
    // One word that means two things: the bottom of a cut was levelled, a bare cut was drawn.
    if (kind == QLatin1String("level") && field == QLatin1String("role") && stored == QLatin1String("cut"))
        return QCoreApplication::translate("records", "bottom of the cut");
    return word_for(kValues, stored);
}

} // namespace planum::gui
