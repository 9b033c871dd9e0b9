// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/import/merge.hpp"
#include "core/base/uuid.hpp"

namespace planum::app {

/// Merges single fields of one thing by the rule of imports: empty ones are filled, differing ones reported
/// and kept, or replaced with --update. Remembers whether anything changed.
class FieldMerge {
  public:
    FieldMerge(std::string what, bool update, bool& changed, std::vector<MergeConflict>& conflicts)
        : what_(std::move(what)), update_(update), changed_(changed), conflicts_(conflicts) {}

    void text(const std::string& field, std::string& kept, const std::string& offered) {
        if (offered.empty() || kept == offered) return;
        settle(field, kept, offered, kept.empty(), kept, offered);
    }

    template<class T>
    void optional(const std::string& field, std::optional<T>& kept, const std::optional<T>& offered) {
        if (!offered || kept == offered) return;
        settle(field, kept, offered, !kept.has_value(), kept ? fmt::format("{}", *kept) : "",
               fmt::format("{}", *offered));
    }

    /// `name_of` gives the name by which people know what an id stands for.
    template<class Tag, class NameOf>
    void id(const std::string& field, Id<Tag>& kept, const Id<Tag>& offered, const NameOf& name_of) {
        if (offered.is_nil() || kept == offered) return;
        const bool differs = !kept.is_nil();
        settle(field, kept, offered, !differs, differs ? name_of(kept) : "", differs ? name_of(offered) : "");
    }

    template<class Enum>
    void choice(const std::string& field, Enum& kept, Enum offered, Enum empty) {
        if (offered == empty || kept == offered) return;
        settle(field, kept, offered, kept == empty, std::string(to_word(kept)), std::string(to_word(offered)));
    }

  private:
    template<class T>
    void settle(const std::string& field, T& kept, const T& offered, bool was_empty, const std::string& kept_text,
                const std::string& offered_text) {
        if (!was_empty) conflicts_.push_back({what_, field, kept_text, offered_text, update_});
        if (!was_empty && !update_) return;
        kept = offered;
        changed_ = true;
    }

    std::string what_;
    bool update_;
    bool& changed_;
    std::vector<MergeConflict>& conflicts_;
};

} // namespace planum::app
