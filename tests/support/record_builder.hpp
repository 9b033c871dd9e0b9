// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "core/base/uuid.hpp"
#include "core/model/record.hpp"

namespace planum::test {

/// Builds small records in the order a test reads: `a_record().covers("1", "2").same_as("2", "3").record()`.
class RecordBuilder {
  public:
    /// Adds the unit unless it is there.
    RecordBuilder& unit(std::string_view number, model::UnitKind kind = model::UnitKind::Deposit,
                        model::UnitForm form = model::UnitForm::Layer);
    RecordBuilder& relation(std::string_view subject, model::RelationKind kind, std::string_view object,
                            model::Certainty certainty = model::Certainty::Certain);

    RecordBuilder& covers(std::string_view a, std::string_view b) {
        return relation(a, model::RelationKind::Covers, b);
    }

    RecordBuilder& cuts(std::string_view a, std::string_view b) { return relation(a, model::RelationKind::Cuts, b); }

    RecordBuilder& fills(std::string_view a, std::string_view b) { return relation(a, model::RelationKind::Fills, b); }

    RecordBuilder& same_as(std::string_view a, std::string_view b) {
        return relation(a, model::RelationKind::SameAs, b);
    }

    RecordBuilder& level(std::string_view unit, model::LevelRole role, double z);

    /// Sorted, as the project file gives it.
    [[nodiscard]] model::Record record() const;

    /// For what the builder has no words for.
    [[nodiscard]] model::StratigraphicUnit& at(std::string_view number);

    [[nodiscard]] model::Record& raw() noexcept { return record_; }

  private:
    SeededUuids ids_{1};
    model::Record record_;
};

[[nodiscard]] inline RecordBuilder a_record() { return {}; }

} // namespace planum::test
