// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/internal/json_text.hpp>

#include <cstdio>
#include <optional>

namespace fretwork::app {

/// A number, or null where there is none.
inline base::Json or_null(const std::optional<double>& value) {
    return value ? base::Json(*value) : base::Json(nullptr);
}

/// The output of `--json`: one document on standard output.
inline void print_document(const base::Json& document) {
    std::fputs(base::json_text(document).c_str(), stdout);
}

}  // namespace fretwork::app
