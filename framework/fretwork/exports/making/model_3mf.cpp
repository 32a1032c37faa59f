// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/provenance.hpp>
#include <fretwork/exports/making/detail/millimetres.hpp>
#include <fretwork/exports/making/detail/zip.hpp>
#include <fretwork/exports/making/making_files.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fretwork::exports {
namespace {

using namespace detail;

constexpr const char* kCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
constexpr const char* kLattice = "http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02";

/// The package around one model.
std::string package(const std::string& model) {
    const std::string start = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    const std::string types =
        start + "<!-- " + std::string(base::kMadeBy) +
        " -->\n<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
        "<Default Extension=\"rels\" "
        "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
        "<Default Extension=\"model\" "
        "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>"
        "</Types>\n";
    const std::string relations =
        start +
        "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
        "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
        "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";
    return zip_archive({{"[Content_Types].xml", types, ZipEntry::Kind::Stored},
                        {"_rels/.rels", relations, ZipEntry::Kind::Compressed},
                        {"3D/3dmodel.model", model, ZipEntry::Kind::Compressed}});
}

void append_attribute(std::string& text, const char* name, double metres) {
    text += ' ';
    text += name;
    text += "=\"";
    append_millimetres(text, metres);
    text += '"';
}

void append_vertex(std::string& text, const std::array<double, 3>& place) {
    text += "<vertex";
    append_attribute(text, "x", place[0]);
    append_attribute(text, "y", place[1]);
    append_attribute(text, "z", place[2]);
    text += "/>\n";
}

std::string model_start(const std::string& extensions) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xml:lang=\"en-US\" "
           "xmlns=\"" +
           std::string(kCore) + "\"" + extensions + ">\n<metadata name=\"Application\">" +
           std::string(base::kMadeBy) +
           "</metadata>\n<resources>\n<object id=\"1\" type=\"model\" "
           "name=\"surface\">\n<mesh>\n<vertices>\n";
}
constexpr const char* kModelEnd =
    "</mesh>\n</object>\n</resources>\n<build>\n<item objectid=\"1\"/>\n</build>\n</model>\n";

}  // namespace

std::string solid_3mf(const fabrication::Solid& solid) {
    std::string model = model_start("");
    for (const auto& place : solid.vertices) append_vertex(model, place);
    model += "</vertices>\n<triangles>\n";
    for (const auto& [a, b, c] : solid.triangles)
        model += "<triangle v1=\"" + std::to_string(a) + "\" v2=\"" + std::to_string(b) + "\" v3=\"" +
                 std::to_string(c) + "\"/>\n";
    model += "</triangles>\n";
    model += kModelEnd;
    return package(model);
}

std::string lattice_3mf(const fabrication::BarPlan& plan) {
    constexpr double kShortest = 1e-7;  // m; readers leave out shorter beams
    std::string model = model_start(" xmlns:b=\"" + std::string(kLattice) + "\" requiredextensions=\"b\"");
    for (const geometry::Point2& node : plan.nodes) append_vertex(model, {node.x, node.y, 0.5 * plan.height});
    const auto radius_of = [&](double width) { return std::sqrt(width * plan.height / std::numbers::pi); };
    model += "</vertices>\n<b:beamlattice";
    append_attribute(model, "radius", radius_of(plan.width));
    append_attribute(model, "minlength", kShortest);
    model += " cap=\"sphere\">\n<b:beams>\n";
    for (const fabrication::Bar& bar : plan.bars) {
        model +=
            "<b:beam v1=\"" + std::to_string(bar.nodes[0]) + "\" v2=\"" + std::to_string(bar.nodes[1]) + "\"";
        if (bar.width != plan.width) append_attribute(model, "r1", radius_of(bar.width));
        model += "/>\n";
    }
    model += "</b:beams>\n</b:beamlattice>\n";
    model += kModelEnd;
    return package(model);
}

}  // namespace fretwork::exports
