// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/internal/json_text.hpp>

#include <string>

namespace fretwork::app {

/// Print an error: one line of at most 300 characters on standard error, whatever a message quotes.
void complain(std::string message);

/// Print a warning: one line on standard error.
void warn(const std::string& line);

/// Print the output of `--json`: one document on standard output.
void print_document(const base::Json& document);

}  // namespace fretwork::app
