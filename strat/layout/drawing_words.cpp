// SPDX-License-Identifier: MIT
#include "strat/layout/drawing_words.hpp"

namespace planum::strat {

DrawingWords german_words() {
    DrawingWords words;
    words.shapes = {"Ablagerung", "Eingriff",    "Struktur", "Grenzfläche",       "Komplex",
                    "Skelett",    "Anstehendes", "Leerraum", "Art nicht erfasst", "zusammengefasst"};
    words.marks = {"", "neu", "entfallen", "geändert", "Problem"};
    words.marked_orders = {"", "neue Abfolge", "entfallene Abfolge", "geänderte Abfolge", ""};
    words.mentioned_only = "nur in Beziehungen genannt";
    words.with_finds = "mit Funden";
    words.inner_cycle = "Widerspruch, den keine Linie zeigt";
    words.uncertain = "unsicher";
    words.through = "über nicht gezeichnete Befunde";
    words.in_cycle = "in einem Kreis";
    words.against_bands = "gegen die Streifen";
    words.isolated = "Ohne gezeichnete Abfolge ({})";
    words.untitled = "Harris-Matrix";
    words.one_unit = "1 Befund";
    words.units = "{} Befunde";
    words.some_units = "{} von {} Befunden";
    words.area = "Schnitt {}";
    words.around = "um Befund {}";
    words.problems = "Probleme";
    words.changed_since = "geändert seit {}";
    words.compared = "{}, verglichen mit {}";
    words.record = "die Aufnahme";
    words.description = "Harris-Matrix: {} in {}, {}; jüngere Befunde stehen über älteren.";
    words.one_box = "1 Kasten";
    words.boxes = "{} Kästen";
    words.one_order = "1 unmittelbare Abfolge";
    words.orders = "{} unmittelbare Abfolgen";
    words.cycles = "{} der Abfolgen liegen in Kreisen.";
    words.scale = "Maßstab {} %";
    words.sheet = "Blatt {}";
    words.page = "Seite {} von {}";
    words.sheets = "Blätter";
    words.map = "Blattübersicht";
    words.index = "Verzeichnis";
    words.unit_and_sheet = "Befund und Blatt";
    return words;
}

DrawingWords words_in(std::string_view language) { return language == "de" ? german_words() : DrawingWords{}; }

std::string with_number(std::string_view word, std::size_t number) { return with_word(word, std::to_string(number)); }

std::string with_word(std::string_view word, std::string_view inside) {
    std::string filled(word);
    const std::size_t at = filled.find("{}");
    if (at != std::string::npos) filled.replace(at, 2, inside);
    return filled;
}

} // namespace planum::strat
