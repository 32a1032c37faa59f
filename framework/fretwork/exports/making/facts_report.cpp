// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/provenance.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/exports/detail/markup.hpp>
#include <fretwork/exports/making/making_files.hpp>

#include <algorithm>
#include <numbers>

namespace fretwork::exports {
namespace {

using base::Json;
using fabrication::Facts;
using fabrication::NarrowPlace;

constexpr double kDegrees = 180.0 / std::numbers::pi;

struct Row {
    std::string name;
    std::string value;
};

std::string shown(double value) {
    return base::format_number(value, 4);
}

std::string place_of(int tile, int node) {
    return "tile " + std::to_string(tile) + ", node " + std::to_string(node);
}

std::string mass_text(const Facts& facts) {
    if (facts.mass <= 0.0) return "the setting has no density";
    return shown(1e3 * facts.mass) + " g (the model's beams: " + shown(1e3 * facts.beam_mass) +
           (facts.mass < facts.beam_mass ? " g; they overlap in joints)"
                                         : " g; round ends, fillets and a frame add to them)");
}

std::vector<Row> rows(const Facts& facts) {
    const auto mm = [](double metres) { return shown(1e3 * metres) + " mm"; };
    std::vector<Row> table = {
        {"tiles, bars", std::to_string(facts.tiles) + ", " + std::to_string(facts.bars)},
        {"joints of the model", std::string(reduction::joints_name(facts.joints))},
        {"pieces, openings", std::to_string(facts.pieces) + ", " + std::to_string(facts.openings)},
        {"size", mm(facts.box.width()) + " x " + mm(facts.box.height()) + " x " + mm(facts.height)},
        {"area of material", shown(1e4 * facts.area) + " cm2"},
        {"volume", shown(1e6 * facts.volume) + " cm3"},
        {"mass", mass_text(facts)},
        {"length of cut", shown(facts.cut_length) + " m, " + std::to_string(facts.pierces) + " contours"},
        {"print", std::to_string(facts.layers) + " layers, walls of " + shown(facts.wall_length) + " m"},
        {"sharpest angle", shown(facts.sharpest_angle * kDegrees) + " degrees"},
        {"smallest inner radius",
         facts.smallest_radius > 0.0 ? mm(facts.smallest_radius) : "0: sharp corners"}};
    if (facts.narrowest)
        table.push_back(
            {facts.narrowest->kind == NarrowPlace::Kind::Gap ? "narrowest gap" : "narrowest opening",
             mm(facts.narrowest->width) + ", " + place_of(facts.narrowest->tile, facts.narrowest->node)});
    if (facts.sag)
        table.push_back(
            {"sag, own weight",
             mm(facts.sag->deflection) + " under " + shown(facts.sag->weight) + " N on the supports of " +
                 facts.sag->load_case +
                 " (large displacements of corotational tiles; weight of the outline: all beams' times " +
                 shown(facts.mass / facts.beam_mass) + ")"});
    if (facts.stress)
        table.push_back({"largest von Mises stress", shown(1e-6 * facts.stress->value) + " MPa, " +
                                                         facts.stress->source + ", " +
                                                         place_of(facts.stress->tile, facts.stress->node)});
    if (facts.stress && facts.strength)
        table.push_back({"share of strength", shown(100.0 * facts.stress->value / *facts.strength) +
                                                  " % of " + shown(1e-6 * *facts.strength) + " MPa"});
    return table;
}

Json place_json(const geometry::Point2& place) {
    return Json::array({place.x, place.y});
}

/// The outline with a circle around every warning, as an element of a page.
std::string marked_picture(const FactsOfScene& scene) {
    fabrication::CutSheet sheet = scene.sheet;
    const double radius = 0.012 * std::max(scene.facts.box.width(), scene.facts.box.height());
    for (const fabrication::Warning& warning : scene.facts.warnings) {
        if (warning.place) sheet.guides.push_back(fabrication::circle(*warning.place, radius));
    }
    std::string svg = cut_svg(sheet);
    // The page fills the material, so circles and numbers must come after it.
    const std::size_t cut = svg.find("<g id=\"cut\"");
    const std::string material = svg.substr(cut, svg.rfind("</svg>") - cut);
    svg.erase(cut, material.size());
    svg.insert(svg.find("<g id=\"guides\""), material);
    return svg.substr(svg.find("<svg"));
}

}  // namespace

std::string facts_text(const Facts& facts) {
    constexpr std::size_t kColumn = 24;
    std::string text = "Facts for making, " + std::string(base::kMadeBy) + "\n";
    for (const Row& row : rows(facts))
        text +=
            row.name + std::string(kColumn - std::min(kColumn - 1, row.name.size()), ' ') + row.value + "\n";
    text += facts.warnings.empty() ? "no warnings\n" : "warnings:\n";
    for (const fabrication::Warning& warning : facts.warnings) text += "- " + warning.message + "\n";
    return text;
}

std::string facts_json(const Facts& facts) {
    Json document = {{"format", "fretwork/facts/3"},
                     {"joints", reduction::joints_name(facts.joints)},
                     {"tiles", facts.tiles},
                     {"bars", facts.bars},
                     {"pieces", facts.pieces},
                     {"openings", facts.openings},
                     {"size", {facts.box.width(), facts.box.height(), facts.height}},
                     {"area", facts.area},
                     {"volume", facts.volume},
                     {"mass", facts.mass},
                     {"beam_mass", facts.beam_mass},
                     {"cut_length", facts.cut_length},
                     {"contours", facts.pierces},
                     {"layers", facts.layers},
                     {"wall_length", facts.wall_length},
                     {"sharpest_angle", facts.sharpest_angle},
                     {"smallest_inner_radius", facts.smallest_radius}};
    if (facts.narrowest)
        document["narrowest"] = {
            {"kind", facts.narrowest->kind == NarrowPlace::Kind::Gap ? "gap" : "opening"},
            {"width", facts.narrowest->width},
            {"tile", facts.narrowest->tile.value},
            {"node", facts.narrowest->node.value},
            {"place", place_json(facts.narrowest->place)}};
    if (facts.sag)
        document["sag"] = {{"load_case", facts.sag->load_case},
                           {"weight", facts.sag->weight},
                           {"deflection", facts.sag->deflection},
                           {"place", place_json(facts.sag->place)}};
    if (facts.stress)
        document["stress"] = {{"source", facts.stress->source},
                              {"value", facts.stress->value},
                              {"tile", facts.stress->tile.value},
                              {"node", facts.stress->node.value}};
    if (facts.strength) document["strength"] = *facts.strength;
    document["warnings"] = Json::array();
    for (const fabrication::Warning& warning : facts.warnings)
        document["warnings"].push_back(
            {{"message", warning.message}, {"place", base::or_null(warning.place, place_json)}});
    return base::json_text(document);
}

std::string facts_html(const FactsOfScene& scene) {
    std::string page =
        "<!doctype html>\n<!-- " + std::string(base::kMadeBy) +
        " -->\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
        "'unsafe-inline'\"><title>Facts for making</title><style>\n"
        "body{font:16px/1.5 system-ui,sans-serif;margin:2rem auto;max-width:70rem;padding:0 "
        "1rem;color:#222}\n"
        "td,th{text-align:left;padding:.2rem 1.2rem .2rem 0;vertical-align:top;border-bottom:1px solid "
        "#ddd}\n"
        "th{font-weight:500;color:#666}svg{width:100%;height:auto;max-height:80vh}\n"
        "#cut{fill:#8fa9c9;fill-rule:evenodd;stroke:#35527a;stroke-width:.15}\n"
        "#guides{stroke:#c8102e;stroke-width:.8}#labels{opacity:.5}\nli{margin:.2rem 0}\n"
        "</style></head><body>\n<h1>Facts for making</h1>\n<table>\n";
    for (const Row& row : rows(scene.facts))
        page += "<tr><th>" + detail::escaped(row.name) + "</th><td>" + detail::escaped(row.value) +
                "</td></tr>\n";
    page += "</table>\n";
    if (scene.facts.warnings.empty()) {
        page += "<p>No warnings.</p>\n";
    } else {
        page += "<h2>Warnings</h2>\n<ul>\n";
        for (const fabrication::Warning& warning : scene.facts.warnings)
            page += "<li>" + detail::escaped(warning.message) + "</li>\n";
        page += "</ul>\n";
    }
    return page +
           "<h2>Outline</h2>\n<p>Circles mark the places of warnings; numbers are those of tiles.</p>\n" +
           marked_picture(scene) + "</body></html>\n";
}

}  // namespace fretwork::exports
