// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/files/provenance.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/mechanics/internal/result_json.hpp>
#include <fretwork/reduction/internal/setting_json.hpp>
#include <fretwork/simulation/results/surface_result.hpp>

#include <algorithm>
#include <functional>
#include <limits>

namespace fretwork::simulation {
namespace {

using base::Json;
using base::JsonReader;
using mechanics::LinearRange;

constexpr std::string_view kSurfaceKeys[] = {"subject",     "linear_range",         "fit_error",
                                             "model_doubt", "model_error_estimate", "buckled_tiles"};

Json model_error_json(const ModelError& error) {
    Json json = {{"mean", error.mean},
                 {"largest", error.largest},
                 {"relative_l2", error.relative_l2},
                 {"full_share", error.full_share}};
    if (error.largest_stress) json["largest_stress"] = *error.largest_stress;
    return json;
}

double read_full_share(const JsonReader& reader) {
    const double share = reader.number();
    if (share < 0.0 || share > 1.0)
        reader.fail("is " + reader.text() + ", where a share of the tiles from 0 to 1 is needed");
    return share;
}

ModelError read_model_error(const JsonReader& reader) {
    reader.allow_only({"mean", "largest", "relative_l2", "largest_stress", "full_share"});
    ModelError error{mechanics::read_not_negative(reader.at("mean")),
                     mechanics::read_not_negative(reader.at("largest")),
                     mechanics::read_not_negative(reader.at("relative_l2"))};
    if (const auto stress = reader.find("largest_stress"))
        error.largest_stress = mechanics::read_not_negative(*stress);
    if (const auto share = reader.find("full_share")) error.full_share = read_full_share(*share);
    return error;
}

Json model_doubt_json(const ModelDoubt& doubt) {
    return {{"tile_rotation", doubt.tile_rotation}, {"change", doubt.change}};
}

ModelDoubt read_model_doubt(const JsonReader& reader) {
    reader.allow_only({"tile_rotation", "change"});
    return {mechanics::read_not_negative(reader.at("tile_rotation")),
            mechanics::read_not_negative(reader.at("change"))};
}

Json range_json(const LinearRange& range) {
    return {{"error_estimate", range.error}, {"loses_stability", range.loses_stability}};
}

LinearRange read_range(const JsonReader& reader) {
    reader.allow_only({"error_estimate", "loses_stability"});
    return {mechanics::read_not_negative(reader.at("error_estimate")),
            reader.at("loses_stability").boolean()};
}

std::vector<int> read_tiles(const JsonReader& reader) {
    std::vector<int> tiles;
    for (const JsonReader& tile : reader.elements())
        tiles.push_back(static_cast<int>(tile.integer(0, std::numeric_limits<int>::max())));
    if (std::ranges::adjacent_find(tiles, std::greater_equal()) != tiles.end())
        reader.fail("is not in ascending order, each tile once");
    return tiles;
}

Json subject_json(const ResultSubject& subject) {
    Json json = {{"model", subject.model},
                 {"is_reference", subject.is_reference},
                 {"load_case", Json::parse(subject.load_case_text)},
                 {"tessellation", subject.tessellation_hash},
                 {"painting", subject.painting_hash},
                 {"setting", subject.setting_hash}};
    if (subject.joints) json["joints"] = reduction::joints_name(*subject.joints);
    if (!subject.full_tiles.empty()) json["full_tiles"] = subject.full_tiles;
    if (subject.stages_text.empty()) return json;
    json["stages"] = Json::parse(subject.stages_text);
    json["stage_load_cases"] = Json::array();
    for (const std::string& text : subject.stage_load_cases)
        json["stage_load_cases"].push_back(Json::parse(text));
    return json;
}

std::string read_hash(const JsonReader& reader) {
    constexpr std::size_t kDigits = 64;
    std::string hash = reader.string();
    if (hash.size() != kDigits || hash.find_first_not_of("0123456789abcdef") != std::string::npos)
        reader.fail("is " + reader.text() + ", where a hash of 64 hexadecimal digits is needed");
    return hash;
}

std::optional<reduction::Joints> read_joints(const JsonReader& subject) {
    const auto joints = subject.find("joints");
    return joints ? std::optional(reduction::read_joints(*joints)) : std::nullopt;
}

ResultSubject read_subject(const JsonReader& reader) {
    reader.allow_only({"model", "is_reference", "load_case", "tessellation", "painting", "setting", "joints",
                       "full_tiles", "stages", "stage_load_cases"});
    const auto full_tiles = reader.find("full_tiles");
    const auto stages = reader.find("stages");
    std::vector<std::string> cases;
    if (stages) {
        for (const JsonReader& load_case : reader.at("stage_load_cases").elements())
            cases.push_back(load_case.text());
    }
    return {.model = reader.at("model").string(),
            .is_reference = reader.at("is_reference").boolean(),
            .load_case = reader.at("load_case").at("name").string(),
            .load_case_text = reader.at("load_case").text(),
            .tessellation_hash = read_hash(reader.at("tessellation")),
            .painting_hash = read_hash(reader.at("painting")),
            .setting_hash = read_hash(reader.at("setting")),
            .joints = read_joints(reader),
            .full_tiles = full_tiles ? read_tiles(*full_tiles) : std::vector<int>{},
            .stages_text = stages ? stages->text() : "",
            .stage_load_cases = std::move(cases)};
}

/// A surface is solved from rest to its whole load, and no further.
void check_load_factor(const JsonReader& document, double factor) {
    if (factor >= 0.0 && factor <= 1.0) return;
    document.at("load_factor")
        .fail("is " + base::format_number(factor) + ", where a share of the load from 0 to 1 is needed");
}

}  // namespace

std::string surface_result_text(const SurfaceResult& result) {
    if (!result.subject) throw base::InputError("a result of a surface without its subject is not written");
    const bool is_newer =
        result.subject->joints || (result.model_error && result.model_error->largest_stress);
    Json json = {{"format", is_newer ? mechanics::kNewerResultFormat : mechanics::kResultFormat},
                 {"program", base::version()}};
    json["subject"] = subject_json(*result.subject);
    if (result.linear_range) json["linear_range"] = range_json(*result.linear_range);
    if (result.fit_error) json["fit_error"] = *result.fit_error;
    if (result.model_doubt) json["model_doubt"] = model_doubt_json(*result.model_doubt);
    if (result.model_error) json["model_error_estimate"] = model_error_json(*result.model_error);
    if (result.buckled_tiles) json["buckled_tiles"] = *result.buckled_tiles;
    mechanics::append_result(result, json);
    return base::json_text(json);
}

void write_surface_result(const SurfaceResult& result, const std::filesystem::path& path) {
    base::write_file_atomically(path, surface_result_text(result));
}

SurfaceResult read_surface_result(const std::filesystem::path& path) {
    return parse_surface_result(base::read_text_file(path), path.string());
}

SurfaceResult parse_surface_result(std::string_view text, const std::string& source) {
    const JsonReader document = JsonReader::from_text(text, source);
    mechanics::check_result_format(document, kSurfaceKeys);
    SurfaceResult result{mechanics::read_result(document)};
    check_load_factor(document, result.solution.load_factor);
    const auto subject = document.find("subject");
    if (!subject)
        document.fail("is the result of a frame, where that of a surface is needed: it has no subject");
    result.subject = read_subject(*subject);
    if (const auto doubt = document.find("model_doubt")) result.model_doubt = read_model_doubt(*doubt);
    if (const auto error = document.find("model_error_estimate"))
        result.model_error = read_model_error(*error);
    if (const auto range = document.find("linear_range")) result.linear_range = read_range(*range);
    if (const auto fit = document.find("fit_error")) result.fit_error = mechanics::read_not_negative(*fit);
    if (const auto tiles = document.find("buckled_tiles")) result.buckled_tiles = read_tiles(*tiles);
    return result;
}

}  // namespace fretwork::simulation
