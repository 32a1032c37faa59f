// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/sparse/ldlt.hpp>
#include <fretwork/mechanics/sparse/system_layout.hpp>

#include <span>

namespace fretwork::mechanics::structure {

/// Throws NumericalError that names a node if a structure at rest can move without strain in spite of its
/// supports.
///
/// A pivot of a mechanism is zero or, if beams are oblique, of the size of rounding. A small pivot alone
/// could also belong to a structure that is only soft. So a solution under an arbitrary load decides: in a
/// mechanism, no load is balanced.
///
/// @param values   the stiffness at rest
/// @param factors  its factors
/// @param outcome  the outcome of its factorization
void refuse_mechanisms(const Assembly& assembly, const sparse::SystemLayout& layout,
                       std::span<const double> values, const sparse::Ldlt& factors,
                       const sparse::Ldlt::Outcome& outcome);

}  // namespace fretwork::mechanics::structure
