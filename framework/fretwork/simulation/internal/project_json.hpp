// SPDX-License-Identifier: GPL-3.0-or-later
// A project as JSON inside other documents.
#pragma once

#include <fretwork/base/json_reader.hpp>

namespace fretwork::simulation {

struct Project;

/// Read a project as it stands in its own file. Throws InputError with the JSON pointer.
Project read_project(const base::JsonReader& json);

}  // namespace fretwork::simulation
