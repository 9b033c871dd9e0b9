// SPDX-License-Identifier: MIT
#include "gui/viewmodels/log_words.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/text.hpp"
#include "core/model/unit.hpp"
#include "gui/viewmodels/record_words.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

namespace {

using Word = std::pair<std::string_view, const char*>;

constexpr std::array kActions = {
    Word{"insert", QT_TRANSLATE_NOOP("log", "recorded")}, Word{"update", QT_TRANSLATE_NOOP("log", "changed")},
    Word{"delete", QT_TRANSLATE_NOOP("log", "deleted")},  Word{"undo", QT_TRANSLATE_NOOP("log", "taken back")},
    Word{"redo", QT_TRANSLATE_NOOP("log", "done again")}, Word{"restore", QT_TRANSLATE_NOOP("log", "brought back")},
};

// Columns of a unit that the first screen of its card shows under another name.
constexpr std::array kColumns = {
    Word{"kind", QT_TRANSLATE_NOOP("card", "Kind")},
    Word{"form", QT_TRANSLATE_NOOP("card", "Kind, more closely")},
    Word{"status", QT_TRANSLATE_NOOP("card", "Status")},
    Word{"number", QT_TRANSLATE_NOOP("card", "Number")},
    Word{"title", QT_TRANSLATE_NOOP("card", "Short definition")},
    Word{"description", QT_TRANSLATE_NOOP("card", "Description")},
    Word{"interpretation", QT_TRANSLATE_NOOP("card", "Interpretation")},
    Word{"area", QT_TRANSLATE_NOOP("card", "Trench")},
    Word{"excavated_on", QT_TRANSLATE_NOOP("card", "Dug away on")},
    Word{"excavated_from", QT_TRANSLATE_NOOP("card", "Digging began on")},
    Word{"recorded_by", QT_TRANSLATE_NOOP("card", "Recorded by")},
    Word{"recorded_on", QT_TRANSLATE_NOOP("card", "Recorded on")},
    Word{"phase", QT_TRANSLATE_NOOP("card", "Phase")},
    Word{"period", QT_TRANSLATE_NOOP("card", "Period")},
    Word{"parent", QT_TRANSLATE_NOOP("card", "Part of feature")},
};

template<class Words>
const char* find_in(const Words& words, std::string_view key) {
    const auto it = std::find_if(words.begin(), words.end(), [&](const Word& word) { return word.first == key; });
    return it == words.end() ? nullptr : it->second;
}

} // namespace

QString log_action_word(std::string_view action) {
    const char* word = find_in(kActions, action);
    return word == nullptr ? qt(action) : QCoreApplication::translate("log", word);
}

QString author_word(const std::string& author) {
    if (author != "outside Planum") return qt(author);
    return QCoreApplication::translate("log", "another program");
}

QString stored_field_label(const std::string& column) {
    if (const char* word = find_in(kColumns, column)) return QCoreApplication::translate("card", word);
    for (const model::UnitFieldInfo& info : model::kUnitFields) {
        if (info.name == column) return QCoreApplication::translate("card", std::string(info.label).c_str());
    }
    return record_field_label(qt(text::replace_all(column, "_", "-")));
}

QString stored_value_word(const std::string& column, const std::string& value) {
    if (column == "kind") {
        if (const auto kind = model::from_word<model::UnitKind>(value)) return kind_word(*kind, model::UnitForm::None);
    }
    if (column == "form") {
        if (const auto form = model::from_word<model::UnitForm>(value))
            return kind_word(model::UnitKind::Unknown, *form);
    }
    if (column == "status") {
        if (const auto status = model::from_word<model::UnitStatus>(value)) return status_word(*status);
    }
    return qt(value);
}

} // namespace planum::gui
