// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program.hpp"

namespace fretwork::app {

/// Refuse a command line whose files do not go together, before anything is computed: an output that is an
/// input or another output (also by way of links or another spelling), that has the ending of something else,
/// or whose folder is missing or closed to us. A file that is there is replaced only by one of its own kind,
/// and only if this program has made it, or if it is empty: a table by one with the same header, a frame if
/// it is as this program writes it. Throws InputError that names the file.
void check_files(const Program& program);

}  // namespace fretwork::app
