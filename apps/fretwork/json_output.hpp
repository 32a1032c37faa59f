// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/internal/json_text.hpp>

#include <cstdio>

namespace fretwork::app {

/// The output of `--json`: one document on standard output.
inline void print_document(const base::Json& document) {
    std::fputs(base::json_text(document).c_str(), stdout);
}

}  // namespace fretwork::app
