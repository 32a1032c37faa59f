// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history.hpp"

#include <fretwork/base/json_reader.hpp>

#include <optional>
#include <string_view>

namespace fretwork::studio {

/// What a request for an edit makes of a document, which is the same state if it changes nothing; nothing if
/// `name` is no edit. Throws InputError if the
/// request is malformed or asks for what is not possible on this document.
std::optional<Edited> edited(const State& state, std::string_view name, const base::JsonReader& request);

}  // namespace fretwork::studio
