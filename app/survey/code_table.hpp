// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace planum::app {

/// What a code of the total station stands for.
enum class SurveyMeaning { Top, Base, Cut, OtherLevel, Find, Ignored };

/// A code taken apart: `OK1042` is the top of unit 1042, `F 17` find 17.
struct ReadCode {
    SurveyMeaning meaning = SurveyMeaning::Ignored;
    std::string number; ///< what follows the letters; may be empty
};

/// Codes and their meanings, without regard to case. The built-in ones stand in docs/survey.md.
class CodeTable {
  public:
    CodeTable();

    /// Adds a table `code,meaning` (top, base, cut, other, find, ignore); its codes come before the built-in ones.
    /// Throws BadInput, naming the line.
    void add_table(std::string_view bytes, std::string_view file_name);

    /// The meaning of a code: the whole text, else its letters before a number. nullopt when nobody knows it.
    [[nodiscard]] std::optional<ReadCode> read(std::string_view code) const;

  private:
    std::map<std::string, SurveyMeaning, std::less<>> meanings_; ///< by folded code
};

} // namespace planum::app
