// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace planum {

/// 128 bits of identity (RFC 9562), written `xxxxxxxx-xxxx-xxxx-xxxx-xxxxxxxxxxxx` in lower case.
/// All zero means "none".
struct Uuid {
    std::uint64_t high = 0;
    std::uint64_t low = 0;

    [[nodiscard]] bool is_nil() const noexcept { return high == 0 && low == 0; }

    [[nodiscard]] std::string to_string() const;

    /// Accepts upper and lower case, with the four hyphens; anything else is nullopt.
    [[nodiscard]] static std::optional<Uuid> parse(std::string_view text) noexcept;

    friend auto operator<=>(const Uuid&, const Uuid&) = default;
};

/// Where new ids come from. Injected, so that tests and the demo repeat themselves.
class UuidSource {
  public:
    virtual ~UuidSource() = default;
    [[nodiscard]] virtual Uuid next() = 0;
};

/// Version 7 ids: time in front, so that new rows stand together in the indexes of the project
/// file (random ids make an import three times slower). Random part from the operating system.
class TimeOrderedUuids final : public UuidSource {
  public:
    TimeOrderedUuids();
    [[nodiscard]] Uuid next() override;

  private:
    std::array<std::uint64_t, 2> state_{};
    std::uint64_t last_ = 0;
};

/// The same ids for the same seed.
class SeededUuids final : public UuidSource {
  public:
    explicit SeededUuids(std::uint64_t seed) : state_(seed) {}

    [[nodiscard]] Uuid next() override;

  private:
    std::uint64_t state_;
    std::uint64_t counter_ = 0;
};

/// A Uuid that knows what it identifies: `void assign(RegionId region, UnitId unit)`.
template<class Tag>
struct Id {
    Uuid value;

    [[nodiscard]] bool is_nil() const noexcept { return value.is_nil(); }

    [[nodiscard]] std::string to_string() const { return value.to_string(); }

    friend auto operator<=>(const Id&, const Id&) = default;
};

} // namespace planum

template<>
struct std::hash<planum::Uuid> {
    std::size_t operator()(const planum::Uuid& id) const noexcept {
        return static_cast<std::size_t>(id.low ^ (id.high * 0x9E3779B97F4A7C15ULL));
    }
};

template<class Tag>
struct std::hash<planum::Id<Tag>> {
    std::size_t operator()(const planum::Id<Tag>& id) const noexcept { return std::hash<planum::Uuid>{}(id.value); }
};
