// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/json_reader.hpp>
#include <studio/document/history.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace fretwork::studio {

/// Whether read_model() accepts the name of a mixed model.
enum class Mixed { Refused, Taken };

/// The name of a tile model of the catalogue or, with Mixed::Taken, `mixed:SHARE`. Throws InputError that
/// suggests the nearest name, or lists all names.
std::string read_model(const base::JsonReader& json, Mixed mixed);

/// A document after an edit, or the same state if the edit changes nothing; nothing if `name` is not an edit.
/// Throws InputError if the request is malformed or impossible on this document.
std::optional<Edited> edited(const State& state, std::string_view name, const base::JsonReader& request);

}  // namespace fretwork::studio
