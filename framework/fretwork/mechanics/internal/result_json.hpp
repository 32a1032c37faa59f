// SPDX-License-Identifier: GPL-3.0-or-later
// The members of a result file that belong to the structure. Files of surfaces have more.
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/mechanics/results/result_file.hpp>

#include <span>
#include <string_view>

namespace fretwork::mechanics {

inline constexpr const char* kResultFormat = "fretwork/result/4";
/// With the error of the largest stress, or the joints of a surface.
inline constexpr const char* kNewerResultFormat = "fretwork/result/5";

/// Append everything but the format and the program.
void append_result(const Result& result, base::Json& json);

/// Throws InputError unless the document is a result of a format that is written, with no keys but those of
/// a structure and `more_keys`.
void check_result_format(const base::JsonReader& document, std::span<const std::string_view> more_keys = {});

/// Read what append_result has written. Throws InputError that names source and place.
Result read_result(const base::JsonReader& document);

/// A number that must not be negative.
double read_not_negative(const base::JsonReader& reader);

}  // namespace fretwork::mechanics
