// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/internal/json_text.hpp>

#include <cstddef>
#include <string>

namespace fretwork::app {

/// Print an error: one line of at most 300 characters on standard error, whatever a message quotes.
void complain(std::string message);

/// Print a warning: one line on standard error.
void warn(const std::string& line);

/// The size of a file for people, with three digits: "27 bytes", "1.25 MB".
std::string bytes_text(std::size_t bytes);

/// Print the output of `--json`: one document on standard output.
void print_document(const base::Json& document);

}  // namespace fretwork::app
