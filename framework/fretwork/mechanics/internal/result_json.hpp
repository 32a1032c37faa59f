// SPDX-License-Identifier: GPL-3.0-or-later
// The members of a result file that belong to the structure. Files of surfaces have further members.
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/mechanics/results/result_file.hpp>

#include <span>
#include <string_view>

namespace fretwork::mechanics {

inline constexpr const char* kResultFormat = "fretwork/result/4";
/// The format of results with the error of the largest stress, or with the joints of a surface.
inline constexpr const char* kNewerResultFormat = "fretwork/result/5";

/// Append all members except the format and the program.
void append_result(const Result& result, base::Json& json);

/// Check that the document is a result in a known format, and has only the keys of a structure's result and
/// `more_keys`. Throws InputError.
void check_result_format(const base::JsonReader& document, std::span<const std::string_view> more_keys = {});

/// Read the program, and the members that append_result() writes. Throws InputError that names source and
/// place.
Result read_result(const base::JsonReader& document);

/// Read a number. Throws InputError if it is negative.
double read_not_negative(const base::JsonReader& reader);

}  // namespace fretwork::mechanics
