// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/design/target/target_file.hpp>
#include <studio/designing/design_request.hpp>
#include <studio/document/painting_request.hpp>
#include <studio/server/sent_file.hpp>
#include <studio/server/words.hpp>

#include <vector>

namespace fretwork::studio {

using base::JsonReader;

namespace {

constexpr long long kMostPatternsAsked = 1'000'000;
constexpr long long kMostSolutions = 1'000'000;
constexpr const char* kFirstPalette = "sample:64";

/// A message that names no format has the newest one.
design::Target read_target(const JsonReader& json) {
    base::Json value = base::Json::parse(json.text());
    if (value.is_object() && !value.contains("format")) value["format"] = design::kTargetFormat;
    return base::located(kMessageSource, "/target", [&] { return design::parse_target(value.dump(), ""); });
}

/// All tiles but those that may change.
std::vector<tiling::TileIndex> tiles_to_keep(const JsonReader& request, const State& state) {
    std::vector<tiling::TileIndex> keep;
    const auto named = request.find("tiles");
    if (!named) return keep;
    std::vector<bool> may_change(state.tile_count());
    for (const std::size_t tile : read_tiles(*named, state)) may_change[tile] = true;
    for (std::size_t t = 0; t < may_change.size(); ++t) {
        if (!may_change[t]) keep.emplace_back(t);
    }
    return keep;
}

void read_free(const JsonReader& request, design::DesignOptions& options) {
    const auto free = request.find("free");
    if (!free) return;
    for (const JsonReader& word : free->elements()) {
        const bool is_factor = word.choice({"factor", "prescribed"}) == "factor";
        (is_factor ? options.free_factor : options.free_prescribed) = true;
    }
}

}  // namespace

DesignWish read_design(const JsonReader& request, const Situation& situation) {
    request.allow_only(
        {"id", "do", "target", "tiles", "palette", "max_patterns", "free", "seconds", "solutions", "seed"});
    const State& state = *situation.state;
    DesignWish wish{.target = read_target(request.at("target")), .options = {}, .palette = kFirstPalette};
    wish.options.load_case = load_case_of(situation).name;
    wish.options.keep = tiles_to_keep(request, state);
    read_free(request, wish.options);
    if (const auto palette = request.find("palette")) wish.palette = read_plain_text(*palette);
    if (const auto most = request.find("max_patterns"))
        wish.options.max_patterns = static_cast<std::size_t>(most->integer(1, kMostPatternsAsked));
    if (const auto seconds = request.find("seconds")) wish.options.seconds = seconds->positive_number();
    if (const auto solutions = request.find("solutions"))
        wish.options.most_solutions = static_cast<int>(solutions->integer(1, kMostSolutions));
    if (const auto seed = request.find("seed"))
        wish.options.seed = static_cast<std::uint64_t>(seed->integer(0, 1LL << 53));
    return wish;
}

}  // namespace fretwork::studio
