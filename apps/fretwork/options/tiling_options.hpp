// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/tessellate.hpp>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace fretwork::app {

/// A length as an option has it, and from which bare number on a unit is asked for.
struct LengthOption {
    const char* name;
    double large;  ///< m
};

/// m. Throws InputError that names the option.
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

/// m; none: the option is not given.
std::optional<double> wanted_edge_length(const TilingText& text);
/// rad; none: the option is not given.
std::optional<double> wanted_angle(const TilingText& text);
tiling::Narrow wanted_narrow(const TilingText& text);

}  // namespace fretwork::app
