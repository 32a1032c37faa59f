// SPDX-License-Identifier: GPL-3.0-or-later
// Components and vectors of nodes, as JSON inside frames, results, load cases and scenarios.
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/mechanics/frame/frame.hpp>

namespace fretwork::mechanics {

/// Read the name of a component. Throws InputError with source and JSON pointer.
Dof read_dof(const base::JsonReader& json);
/// Read a list of names of components, in which a name may stand twice. Throws as read_dof().
DofSet read_dofs(const base::JsonReader& json);
/// The inverse of read_dofs().
base::Json dofs_json(const DofSet& dofs);
/// The three components of a vector.
base::Json vector_json(const Eigen::Vector3d& vector);

}  // namespace fretwork::mechanics
