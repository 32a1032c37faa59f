// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_identity.hpp"
#include "tools/file_kinds.hpp"
#include "tools/report_files.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/design/target/target_file.hpp>
#include <fretwork/library/library.hpp>
#include <fretwork/mechanics/decks/calculix_file.hpp>
#include <fretwork/mechanics/frame/frame_file.hpp>
#include <fretwork/mechanics/results/result_file.hpp>
#include <fretwork/outlines/flat_mesh.hpp>
#include <fretwork/outlines/outline.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/reduction/scenarios/scenario.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/project/project_check.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/results/surface_result.hpp>
#include <fretwork/simulation/stages.hpp>
#include <fretwork/tiling/painting/field.hpp>
#include <fretwork/tiling/painting/painting.hpp>
#include <studio/document/autosave.hpp>

#include <fstream>
#include <string_view>
#include <vector>

namespace fretwork::app {
namespace {

namespace fs = std::filesystem;

struct JsonText {
    std::string text;
    std::string source;
    std::string layout;  ///< that of paintings, as check_file() takes it
};

struct JsonKind {
    std::string_view name;  ///< the K of "fretwork/K/N"
    void (*read)(const JsonText& file);
};

/// A painting names its layout by the layout's name. It is never taken for a path, because a stranger's
/// painting may name any file of this machine.
pattern::NodeLayout layout_of(const JsonText& painting) {
    constexpr std::size_t kMostShown = 60;
    if (!painting.layout.empty()) return pattern::find_node_layout(painting.layout);
    const auto named = base::JsonReader::from_text(painting.text, painting.source).at("layout");
    if (!pattern::is_layout_name(named.string()))
        named.fail("is " + base::shortened(named.text(), kMostShown) +
                   ", where a built-in layout is needed (" + base::join(pattern::layout_names(), ", ") +
                   "); for a layout of your own, add --layout FILE.json");
    return pattern::find_node_layout(named.string());
}

void read_painting_text(const JsonText& file) {
    (void)tiling::parse_painting(file.text, file.source, layout_of(file));
}

/// Results of surfaces say more than those of frames: their subject.
void read_result_text(const JsonText& file) {
    if (base::JsonReader::from_text(file.text, file.source).find("subject"))
        simulation::check_subject(*simulation::parse_surface_result(file.text, file.source).subject,
                                  file.source);
    else
        (void)mechanics::parse_result(file.text, file.source);
}

constexpr JsonKind kJsonKinds[] = {
    {"layout", [](const JsonText& f) { (void)pattern::parse_node_layout(f.text, f.source); }},
    {"frame", [](const JsonText& f) { (void)mechanics::parse_frame(f.text, f.source); }},
    {"scenario", [](const JsonText& f) { (void)reduction::parse_scenario(f.text, f.source); }},
    {"setting", [](const JsonText& f) { (void)reduction::parse_setting(f.text, f.source); }},
    {"load-case", [](const JsonText& f) { (void)simulation::parse_load_case(f.text, f.source); }},
    {"painting", read_painting_text},
    {"project",
     [](const JsonText& f) {
         simulation::check_project(simulation::parse_project(f.text, f.source), f.source);
     }},
    {"result", read_result_text},
    {"stages", [](const JsonText& f) { (void)simulation::parse_stages(f.text, f.source); }},
    {"target", [](const JsonText& f) { (void)design::parse_target(f.text, f.source); }},
    {"outline", [](const JsonText& f) { (void)outlines::parse_outline(f.text, f.source); }},
    {"beams", [](const JsonText& f) { check_beam_table(f.text, f.source); }},
    {"facts", [](const JsonText& f) { check_facts(f.text, f.source); }},
    {"autosave", [](const JsonText& f) { (void)studio::parse_autosave(f.text, f.source); }},
};

struct EndingKind {
    std::string_view ending;
    std::string_view name;
    void (*read)(const fs::path& path);
};

void read_outlines(const fs::path& path) {
    (void)outlines::read_outline_file(path);
}

/// A mesh may be an outline or a surface in space that a design is to take: any mesh is valid.
void read_mesh(const fs::path& path) {
    (void)outlines::read_space_mesh(path);
}

/// Paintings and fields take their values from images.
void read_image(const fs::path& path) {
    (void)tiling::image_values(path, {}, {});
}

constexpr EndingKind kEndingKinds[] = {
    {".svg", "outline", read_outlines},
    {".dxf", "outline", read_outlines},
    {".obj", "mesh", read_mesh},
    {".ply", "mesh", read_mesh},
    {".off", "mesh", read_mesh},
    {".png", "image", read_image},
    {".inp", "deck", [](const fs::path& p) { (void)mechanics::read_calculix(p); }},
};

std::string check_json(const fs::path& path, const std::string& layout) {
    const JsonText file{base::read_text_file(path), path.string(), layout};
    const base::JsonReader format = base::JsonReader::from_text(file.text, file.source).at("format");
    std::string name = format.string();
    std::vector<std::string> known;
    for (const JsonKind& kind : kJsonKinds) {
        known.emplace_back(kind.name);
        if (!name.starts_with("fretwork/" + known.back() + "/")) continue;
        kind.read(file);
        return name;
    }
    format.fail("is " + format.text() + ", where \"fretwork/KIND/N\" is needed, with KIND one of " +
                base::join(known, ", "));
}

bool is_database(const fs::path& path) {
    constexpr std::string_view kStart("SQLite format 3\0", 16);
    std::string start(kStart.size(), '\0');
    std::ifstream(path, std::ios::binary).read(start.data(), static_cast<std::streamsize>(start.size()));
    return start == kStart;
}

/// JSON readers do not look at endings, so a file that begins as an object is JSON.
bool begins_as_json(const fs::path& path) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  // JSON readers skip it, too
    std::ifstream stream(path, std::ios::binary);
    std::string start(kByteOrderMark.size(), '\0');
    stream.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (start != kByteOrderMark) {
        stream.clear();  // the file may be shorter
        stream.seekg(0);
    }
    char first = '\0';
    stream >> first;
    return first == '{';
}

/// Reading a pipe or a terminal would wait for input.
void require_regular(const fs::path& path) {
    if (!is_device(path)) return;
    throw base::InputError(path.string(), "", "is a pipe or a device, where a file is needed");
}

std::string check_library(const fs::path& path) {
    (void)library::Library::open(path).summaries();
    return "library";
}

}  // namespace

std::string check_file(const fs::path& path, const std::string& layout) {
    require_regular(path);
    if (is_database(path)) return check_library(path);
    const std::string ending = base::ending_of(path);
    if (ending == ".json") return check_json(path, layout);
    std::vector<std::string> known{".json"};
    for (const EndingKind& kind : kEndingKinds) {
        known.emplace_back(kind.ending);
        if (ending != kind.ending) continue;
        kind.read(path);
        return std::string(kind.name) + " (" + ending.substr(1) + ")";
    }
    if (begins_as_json(path)) return check_json(path, layout);
    (void)base::read_text_file(path);  // says if there is no such file
    throw base::InputError(path.string(), "",
                           "is of no kind that can be checked: a library, JSON, or a file that ends in " +
                               base::join(known, ", "));
}

}  // namespace fretwork::app
