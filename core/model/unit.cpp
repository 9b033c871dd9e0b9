// SPDX-License-Identifier: MIT
#include "core/model/unit.hpp"

#include <utility>

#include "core/base/text.hpp"
#include "core/model/words.hpp"

namespace planum::model {

namespace {

constexpr std::array kKindWords = {
    std::pair{UnitKind::Unknown, std::string_view{"unknown"}},
    std::pair{UnitKind::Deposit, std::string_view{"deposit"}},
    std::pair{UnitKind::Cut, std::string_view{"cut"}},
    std::pair{UnitKind::Feature, std::string_view{"feature"}},
    std::pair{UnitKind::Structure, std::string_view{"structure"}},
    std::pair{UnitKind::Interface, std::string_view{"interface"}},
    std::pair{UnitKind::Skeleton, std::string_view{"skeleton"}},
    std::pair{UnitKind::Natural, std::string_view{"natural"}},
    std::pair{UnitKind::Void, std::string_view{"void"}},
};

constexpr std::array kFormWords = {
    std::pair{UnitForm::None, std::string_view{""}},         std::pair{UnitForm::Layer, std::string_view{"layer"}},
    std::pair{UnitForm::Fill, std::string_view{"fill"}},     std::pair{UnitForm::Masonry, std::string_view{"masonry"}},
    std::pair{UnitForm::Timber, std::string_view{"timber"}}, std::pair{UnitForm::Burial, std::string_view{"burial"}},
};

constexpr std::array kStatusWords = {
    std::pair{UnitStatus::Open, std::string_view{"open"}},
    std::pair{UnitStatus::PartlyExcavated, std::string_view{"partly-excavated"}},
    std::pair{UnitStatus::Excavated, std::string_view{"excavated"}},
    std::pair{UnitStatus::NotExcavated, std::string_view{"not-excavated"}},
    std::pair{UnitStatus::Void, std::string_view{"void"}},
};

constexpr std::array kOriginWords = {
    std::pair{UnitOrigin::Recorded, std::string_view{"recorded"}},
    std::pair{UnitOrigin::Mentioned, std::string_view{"mentioned"}},
};

struct KindWord {
    std::string_view word;
    KindAndForm meaning;
};

constexpr KindAndForm kDeposit{UnitKind::Deposit, UnitForm::None};
constexpr KindAndForm kLayer{UnitKind::Deposit, UnitForm::Layer};
constexpr KindAndForm kFill{UnitKind::Deposit, UnitForm::Fill};
constexpr KindAndForm kCut{UnitKind::Cut, UnitForm::None};
constexpr KindAndForm kFeature{UnitKind::Feature, UnitForm::None};
constexpr KindAndForm kStructure{UnitKind::Structure, UnitForm::None};
constexpr KindAndForm kMasonry{UnitKind::Structure, UnitForm::Masonry};
constexpr KindAndForm kTimber{UnitKind::Structure, UnitForm::Timber};
constexpr KindAndForm kInterface{UnitKind::Interface, UnitForm::None};
constexpr KindAndForm kSkeleton{UnitKind::Skeleton, UnitForm::None};
constexpr KindAndForm kBurial{UnitKind::Skeleton, UnitForm::Burial};
constexpr KindAndForm kNatural{UnitKind::Natural, UnitForm::None};
constexpr KindAndForm kVoid{UnitKind::Void, UnitForm::None};

// Words of sheets and programs in four languages; whole words, folded.
constexpr std::array kAnyWords = {
    KindWord{"deposit", kDeposit},
    KindWord{"accumulation", kDeposit},
    KindWord{"ablagerung", kDeposit},
    KindWord{"deposito", kDeposit},
    KindWord{"dépôt", kDeposit},
    KindWord{"us positive", kDeposit},
    KindWord{"layer", kLayer},
    KindWord{"topsoil", kLayer},
    KindWord{"floor", kLayer},
    KindWord{"lens", kLayer},
    KindWord{"schicht", kLayer},
    KindWord{"strato", kLayer},
    KindWord{"couche", kLayer},
    KindWord{"spread", kLayer},
    KindWord{"surface deposit", kLayer},
    KindWord{"fill", kFill},
    KindWord{"verfüllung", kFill},
    KindWord{"füllung", kFill},
    KindWord{"riempimento", kFill},
    KindWord{"remplissage", kFill},
    KindWord{"comblement", kFill},
    KindWord{"cut", kCut},
    KindWord{"pit", kCut},
    KindWord{"grube", kCut},
    KindWord{"schnitt", kCut},
    KindWord{"eingriff", kCut},
    KindWord{"taglio", kCut},
    KindWord{"fosse", kCut},
    KindWord{"creusement", kCut},
    KindWord{"us negativa", kCut},
    KindWord{"us négative", kCut},
    KindWord{"us negative", kCut},
    KindWord{"negative", kCut},
    KindWord{"negativa", kCut},
    KindWord{"feature", kFeature},
    KindWord{"befund", kFeature},
    KindWord{"fait", kFeature},
    KindWord{"structure", kStructure},
    KindWord{"architecture", kStructure},
    KindWord{"bauwerk", kStructure},
    KindWord{"struttura", kStructure},
    KindWord{"construction", kStructure},
    KindWord{"us construite", kStructure},
    KindWord{"installation", kStructure},
    KindWord{"masonry", kMasonry},
    KindWord{"wall", kMasonry},
    KindWord{"mauer", kMasonry},
    KindWord{"muro", kMasonry},
    KindWord{"mur", kMasonry},
    KindWord{"usm", kMasonry},
    KindWord{"us muraria", kMasonry},
    KindWord{"timber", kTimber},
    KindWord{"holz", kTimber},
    KindWord{"interface", kInterface},
    KindWord{"surface", kInterface},
    KindWord{"horizon", kInterface},
    KindWord{"top_surface", kInterface},
    KindWord{"oberfläche", kInterface},
    KindWord{"interfaccia", kInterface},
    KindWord{"superficie", kInterface},
    KindWord{"skeleton", kSkeleton},
    KindWord{"skelett", kSkeleton},
    KindWord{"scheletro", kSkeleton},
    KindWord{"squelette", kSkeleton},
    KindWord{"burial", kBurial},
    KindWord{"grab", kBurial},
    KindWord{"grave", kBurial},
    KindWord{"sepoltura", kBurial},
    KindWord{"sépulture", kBurial},
    KindWord{"natural", kNatural},
    KindWord{"geology", kNatural},
    KindWord{"naturale", kNatural},
    KindWord{"anstehender boden", kNatural},
    KindWord{"anstehendes", kNatural},
    KindWord{"geologie", kNatural},
    KindWord{"substrat", kNatural},
    KindWord{"bedrock", kNatural},
    KindWord{"void", kVoid},
    KindWord{"ungültig", kVoid},
    KindWord{"annullata", kVoid},
    KindWord{"annulé", kVoid},
};

} // namespace

std::string_view to_word(UnitKind kind) noexcept { return detail::word_of(kKindWords, kind); }

std::string_view to_word(UnitForm form) noexcept { return detail::word_of(kFormWords, form); }

std::string_view to_word(UnitStatus status) noexcept { return detail::word_of(kStatusWords, status); }

std::string_view to_word(UnitOrigin origin) noexcept { return detail::word_of(kOriginWords, origin); }

template<>
std::optional<UnitKind> from_word<UnitKind>(std::string_view word) noexcept {
    return detail::value_of(kKindWords, word);
}

template<>
std::optional<UnitForm> from_word<UnitForm>(std::string_view word) noexcept {
    return detail::value_of(kFormWords, word);
}

template<>
std::optional<UnitStatus> from_word<UnitStatus>(std::string_view word) noexcept {
    return detail::value_of(kStatusWords, word);
}

template<>
std::optional<UnitOrigin> from_word<UnitOrigin>(std::string_view word) noexcept {
    return detail::value_of(kOriginWords, word);
}

std::optional<KindAndForm> kind_from_any_word(std::string_view word) {
    const std::string folded = text::fold_case(text::trim(word));
    if (const auto kind = from_word<UnitKind>(folded)) return KindAndForm{*kind, UnitForm::None};
    for (const KindWord& entry : kAnyWords) {
        if (entry.word == folded) return entry.meaning;
    }
    return std::nullopt;
}

} // namespace planum::model
