// SPDX-License-Identifier: GPL-3.0-or-later
// Load cases as JSON inside other documents: projects, results, load stages, and the studio's messages.
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace fretwork::simulation {

/// The names of the sides of a surface, in the order of Side.
inline constexpr std::array<const char*, 4> kSideNames = {"left", "right", "bottom", "top"};
inline const char* side_name(Side side) {
    return kSideNames[static_cast<std::size_t>(side)];
}

/// The keys by which an entry selects interface nodes.
inline constexpr std::array<std::string_view, 5> kSelectionKeys = {"nodes", "box", "circle", "nearest",
                                                                   "side"};
/// True if the selection has a key that the first formats of load cases, targets and stages do not know.
inline bool is_circle(const Selection& selection) {
    return std::holds_alternative<NodesInCircle>(selection);
}

/// Read a load case as it stands in its own file. Throws InputError with the JSON pointer.
LoadCase read_load_case(const base::JsonReader& json);
/// Read a selection of interface nodes as the entries of a load case hold it: exactly one of
/// kSelectionKeys. The caller refuses other keys. Throws InputError with the JSON pointer.
Selection read_selection(const base::JsonReader& json);
/// Add the key of a selection to an entry.
void write_selection(const Selection& selection, base::Json& json);
/// The inverse of read_load_case.
base::Json load_case_json(const LoadCase& load_case);

// Lists of entries of a load case. The readers throw InputError with the JSON pointer.
std::vector<LoadCase::Support> read_supports(const base::JsonReader& list);
std::vector<LoadCase::PrescribedDisplacement> read_prescribed(const base::JsonReader& list);
base::Json supports_json(std::span<const LoadCase::Support> supports);
base::Json prescribed_json(std::span<const LoadCase::PrescribedDisplacement> prescribed);

/// Read a load case's name with its factor, as combinations and load stages hold it. Throws InputError with
/// the JSON pointer, also if the factor is beyond its limits.
LoadCase::Share read_share(const base::JsonReader& json);

}  // namespace fretwork::simulation
