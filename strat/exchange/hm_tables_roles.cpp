// SPDX-License-Identifier: MIT
#include "strat/exchange/hm_tables_roles.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/json_support.hpp"
#include "strat/exchange/record_builder.hpp"

namespace planum::strat {

namespace {

constexpr std::size_t kMaxConfiguration = 1U << 20U; // bytes; real ones have 8 kB

const std::array<HmRoleInfo, 7>& roles() {
    static const std::array<HmRoleInfo, 7> table = {
        HmRoleInfo{HmRole::Contexts,
                   {"contexts", "context", ""},
                   {"label", "unit_type", "position", "period", "phase", "url"}},
        HmRoleInfo{HmRole::Observations, {"observations", "observation", ""}, {"younger", "older", "url"}},
        HmRoleInfo{HmRole::Inferences, {"inferences", "inference", ""}, {"first", "second"}},
        HmRoleInfo{HmRole::Periods, {"periods", "period", ""}, {"id", "label", "attribute", "url"}},
        HmRoleInfo{HmRole::Phases, {"phases", "phase", ""}, {"id", "label", "attribute", "url"}},
        // Before events, whose words are part of these.
        HmRoleInfo{HmRole::EventOrder, {"event-order", "date-order", "event_order"}, {"older", "younger"}},
        HmRoleInfo{HmRole::Events, {"events", "radiocarbon", "dates"}, {"theta", "context", "lab", "association"}},
    };
    return table;
}

std::optional<HmRole> role_from_word(std::string_view word) {
    for (const HmRoleInfo& role : roles()) {
        for (const std::string_view candidate : role.words) {
            if (!candidate.empty() && candidate == word) return role.role;
        }
    }
    return std::nullopt;
}

void read_configuration(std::string_view bytes, HmConfiguration& configuration) {
    std::string section;
    const DecodedText decoded = decode_text(bytes, {});
    for (const std::string_view line : text::split(decoded.text, '\n')) {
        const std::string_view trimmed = text::trim(line);
        if (trimmed.starts_with('[')) {
            section = text::fold_case(trimmed);
            configuration.found = configuration.found || section == "[input files]";
            continue;
        }
        const std::size_t equals = trimmed.find('=');
        if (equals == std::string_view::npos) continue;
        const auto role = role_from_word(text::fold_case(text::trim(trimmed.substr(0, equals))));
        const std::string_view value = text::trim(trimmed.substr(equals + 1));
        if (!role || value.empty()) continue;
        if (section == "[input files]") {
            const std::size_t slash = value.find_last_of("/\\");
            configuration.files[std::string{value.substr(slash == std::string_view::npos ? 0 : slash + 1)}] = *role;
        } else if (section == "[input file headers]") {
            const std::string word = text::fold_case(value);
            const bool yes = word == "yes" || word == "true" || word == "1" || word == "on";
            configuration.headers[*role] = yes ? HeaderLine::Yes : HeaderLine::No;
        }
    }
}

bool is_configuration(const InputFile& file) {
    if (file.bytes.size() > kMaxConfiguration) return false;
    if (text::fold_case(file.path.extension().string()) != ".ini" || !is_probably_text(file.bytes)) return false;
    HmConfiguration configuration;
    read_configuration(file.bytes, configuration);
    return configuration.found;
}

bool is_package(const InputFile& file) {
    return file.name == "datapackage.json" && file.bytes.find("\"resources\"") != std::string::npos;
}

// Frictionless Data: resources with a name and a path. A damaged one says nothing; the tables may do
// without it.
void read_package(const InputFile& file, HmConfiguration& configuration) {
    Json root;
    try {
        root = parse_json(decode_text(file.bytes, file.name).text);
    } catch (const Error&) {
        return;
    }
    const Json* resources = json_member(root, "resources");
    if (resources == nullptr || !resources->is_array()) return;
    for (const Json& resource : *resources) {
        const auto role = role_from_word(text::fold_case(json_text(resource, "name")));
        const std::string path = json_text(resource, "path");
        if (role && !path.empty()) configuration.files[path.substr(path.find_last_of('/') + 1)] = *role;
    }
}

std::optional<HmRole> role_from_name(const InputFile& file) {
    const std::string name = text::fold_case(file.path.stem().string());
    for (const HmRoleInfo& role : roles()) {
        for (const std::string_view word : role.words) {
            if (!word.empty() && name.find(word) != std::string::npos) return role.role;
        }
    }
    return std::nullopt;
}

} // namespace

const HmRoleInfo& hm_role_info(HmRole role) {
    return *std::find_if(roles().begin(), roles().end(), [&](const HmRoleInfo& r) { return r.role == role; });
}

bool is_hm_guide(const InputFile& file) { return is_configuration(file) || is_package(file); }

void read_hm_guide(const InputFile& file, HmConfiguration& configuration) {
    if (is_package(file)) return read_package(file, configuration);
    read_configuration(file.bytes, configuration);
}

std::optional<HmRole> hm_role_from_header(const InputFile& file, const DelimitedTable& table) {
    if (table.rows.empty()) return std::nullopt;
    const TableHeader header(table.rows.front());
    if (header.has("label") && header.has("unit_type")) return HmRole::Contexts;
    if (header.has("theta") && header.has("context")) return HmRole::Events;
    if (header.has("first") && header.has("second") && header.names().size() == 2) return HmRole::Inferences;
    if (header.has("younger") && header.has("older")) {
        return *header.find("older") < *header.find("younger") ? HmRole::EventOrder : HmRole::Observations;
    }
    if (header.has("id") && header.has("label") && header.has("attribute")) {
        return role_from_name(file) == HmRole::Phases ? HmRole::Phases : HmRole::Periods;
    }
    return std::nullopt;
}

std::optional<HmAssigned> assign_hm_role(const InputFile& file, const DelimitedTable& table,
                                         const HmConfiguration& configuration) {
    const auto by_header = hm_role_from_header(file, table);
    const auto by_ini = configuration.files.find(file.name);
    std::optional<HmRole> role = by_header;
    if (by_ini != configuration.files.end()) role = by_ini->second;
    if (!role) role = role_from_name(file);
    if (!role) return std::nullopt;
    HeaderLine header = by_header ? HeaderLine::Yes : HeaderLine::Unsaid;
    const auto said = configuration.headers.find(*role);
    if (!by_header && said != configuration.headers.end()) header = said->second;
    return HmAssigned{*role, header};
}

} // namespace planum::strat
