// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program.hpp"

namespace fretwork::app {

/// Refuse a command line whose files do not go together, before anything is computed: an output that is an
/// input or another output (also by way of links or another spelling), that has the ending of something else,
/// whose folder is missing or closed to us, or that would replace a file of another kind: a library by a
/// drawing, a project by a result. Older outputs of this program and empty files are replaced; a file that it
/// has not made, such as an outline drawn by hand, never is.
/// Throws InputError that names the file.
void check_files(const Program& program);

}  // namespace fretwork::app
