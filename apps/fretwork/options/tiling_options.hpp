// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/tessellate.hpp>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace fretwork::app {

/// An option with a length. A bare number of at least `large` is refused, because its unit is missing.
struct LengthOption {
    const char* name;
    double large;  ///< m
};

/// The length in m. Throws InputError that names the option.
double read_length(const LengthOption& option, const std::string& text);

/// How tiles are laid, as people write it.
struct TilingText {
    std::optional<std::string> edge_length;
    std::optional<std::string> angle;
    std::string narrow = "refine";
};

/// The options --edge-length, --angle and --narrow of `tile` and `retile`. `text` must outlive the verb.
/// @param usual_length  the mean side without the option: "the setting's tile side"
void add_tiling_options(CLI::App& verb, TilingText& text, const std::string& usual_length);

/// The wanted length in m; none if the option is not given.
std::optional<double> wanted_edge_length(const TilingText& text);
/// The wanted angle in rad; none if the option is not given.
std::optional<double> wanted_angle(const TilingText& text);
tiling::Narrow wanted_narrow(const TilingText& text);

}  // namespace fretwork::app
