// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace fretwork::app {

/// Print one line of at most 300 characters on standard error, whatever a message quotes.
void complain(std::string message);

}  // namespace fretwork::app
