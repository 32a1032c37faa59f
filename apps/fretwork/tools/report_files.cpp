// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report_files.hpp"

#include <fretwork/base/json_reader.hpp>

#include <limits>

namespace fretwork::app {
namespace {

using base::JsonReader;

void check_count(const JsonReader& value) {
    (void)value.integer(0, std::numeric_limits<int>::max());
}

void check_not_negative(const JsonReader& value) {
    if (value.number() < 0.0) value.fail("is " + value.text() + ", where a number >= 0 is needed");
}

/// Every key of the list must be there.
void check_each(const JsonReader& json, std::initializer_list<std::string_view> keys,
                void (*check)(const JsonReader&)) {
    for (const std::string_view key : keys) check(json.at(key));
}

void check_beam_end(const JsonReader& end) {
    end.allow_only({"node", "place", "N", "V2", "V3", "T", "M2", "M3", "stress", "von_mises"});
    check_count(end.at("node"));
    (void)end.at("place").numbers(3);
    check_each(end, {"N", "V2", "V3", "T", "M2", "M3", "stress"},
               [](const JsonReader& v) { (void)v.number(); });
    check_not_negative(end.at("von_mises"));
}

void check_beam(const JsonReader& beam, bool has_strength) {
    beam.allow_only(
        {"beam", "tile", "pattern", "length", "ends", "largest_stress", "largest_von_mises", "utilization"});
    check_each(beam, {"beam", "tile"}, check_count);
    (void)beam.at("pattern").string();
    (void)beam.at("length").positive_number();
    for (const JsonReader& end : beam.at("ends").elements(2)) check_beam_end(end);
    (void)beam.at("largest_stress").number();
    check_not_negative(beam.at("largest_von_mises"));
    const JsonReader utilization = beam.at("utilization");
    if (has_strength)
        check_not_negative(utilization);
    else if (!utilization.is_null())
        utilization.fail("is " + utilization.text() + ", where null is needed: the file has no strength");
}

void check_narrowest(const JsonReader& place) {
    place.allow_only({"kind", "width", "tile", "node", "place"});
    (void)place.at("kind").choice({"gap", "opening"});
    check_not_negative(place.at("width"));
    check_each(place, {"tile", "node"}, check_count);
    (void)place.at("place").numbers(2);
}

void check_sag(const JsonReader& sag) {
    sag.allow_only({"load_case", "weight", "deflection", "place"});
    (void)sag.at("load_case").string();
    check_each(sag, {"weight", "deflection"}, check_not_negative);
    (void)sag.at("place").numbers(2);
}

void check_stress(const JsonReader& stress) {
    stress.allow_only({"source", "value", "tile", "node"});
    (void)stress.at("source").string();
    check_not_negative(stress.at("value"));
    check_each(stress, {"tile", "node"}, check_count);
}

/// The place of a warning about the whole surface is null.
void check_warnings(const JsonReader& warnings) {
    for (const JsonReader& warning : warnings.elements()) {
        warning.allow_only({"message", "place"});
        (void)warning.at("message").string();
        const JsonReader place = warning.at("place");
        if (!place.is_null()) (void)place.numbers(2);
    }
}

}  // namespace

void check_beam_table(const std::string& text, const std::string& source) {
    const JsonReader json = JsonReader::from_text(text, source);
    json.expect_format("beams", 2, 2);
    json.allow_only({"format", "joints", "strength", "utilization_formula", "unknown_beams", "beams"});
    (void)json.at("joints").choice({"centreline", "stiff"});
    const bool has_strength = !json.at("strength").is_null();
    if (has_strength) (void)json.at("strength").positive_number();
    (void)json.at("utilization_formula").string();
    check_count(json.at("unknown_beams"));
    for (const JsonReader& beam : json.at("beams").elements()) check_beam(beam, has_strength);
}

void check_facts(const std::string& text, const std::string& source) {
    const JsonReader json = JsonReader::from_text(text, source);
    json.expect_format("facts", 3, 2);
    json.allow_only({"format",      "joints",
                     "tiles",       "bars",
                     "pieces",      "openings",
                     "size",        "area",
                     "volume",      "mass",
                     "beam_mass",   "cut_length",
                     "contours",    "layers",
                     "wall_length", "sharpest_angle",
                     "narrowest",   "sag",
                     "stress",      "strength",
                     "warnings",    "smallest_inner_radius"});
    (void)json.at("joints").choice({"centreline", "stiff"});
    check_each(json, {"tiles", "bars", "pieces", "openings", "contours", "layers"}, check_count);
    (void)json.at("size").numbers(3);
    check_each(json,
               {"area", "volume", "mass", "beam_mass", "cut_length", "wall_length", "sharpest_angle",
                "smallest_inner_radius"},
               check_not_negative);
    if (const auto place = json.find("narrowest")) check_narrowest(*place);
    if (const auto sag = json.find("sag")) check_sag(*sag);
    if (const auto stress = json.find("stress")) check_stress(*stress);
    if (const auto strength = json.find("strength")) (void)strength->positive_number();
    check_warnings(json.at("warnings"));
}

}  // namespace fretwork::app
