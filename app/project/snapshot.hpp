// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/model/record.hpp"
#include "core/store/project_file.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::app {

class Project;

/// The record at one moment, with its index, its matrix and the list of changes: what a window shows while
/// another thread holds the file. Never changes once made, so any number of threads may read it.
class Snapshot {
  public:
    explicit Snapshot(model::Record record);
    Snapshot(const Snapshot&) = delete;
    Snapshot& operator=(const Snapshot&) = delete;

    [[nodiscard]] const model::Record& record() const noexcept { return record_; }

    [[nodiscard]] const model::RecordIndex& index() const noexcept { return index_; }

    [[nodiscard]] const strat::HarrisMatrix& matrix() const noexcept { return matrix_; }

    /// Positions in record().relations of those the unit takes part in, ascending.
    [[nodiscard]] const std::vector<std::uint32_t>& relations_of(model::UnitIndex unit) const {
        return relations_of_.at(unit);
    }

    /// Position in record().statements of the first statement of a relation; that of the next one ends them.
    [[nodiscard]] std::uint32_t statements_begin(std::size_t relation) const { return statements_begin_.at(relation); }

    std::vector<store::ChangeEntry> changes; ///< newest first, the last few hundred

  private:
    model::Record record_;
    model::RecordIndex index_;
    strat::HarrisMatrix matrix_;
    std::vector<std::vector<std::uint32_t>> relations_of_;
    std::vector<std::uint32_t> statements_begin_;
};

/// What the project holds now. Throws as reading does.
[[nodiscard]] std::shared_ptr<const Snapshot> take_snapshot(Project& project);

} // namespace planum::app
