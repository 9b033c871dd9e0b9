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

template<class Words>
QString word_for(const Words& words, const QString& name) {
    const std::string key = name.toStdString();
    const auto it = std::find_if(words.begin(), words.end(), [&](const Word& word) { return word.first == key; });
    return it == words.end() ? name : QCoreApplication::translate("records", it->second);
}

} // namespace

QString record_list_title(const QString& kind) { return word_for(kTitles, kind); }

QString record_field_label(const QString& field) { return word_for(kLabels, field); }

} // namespace planum::gui
