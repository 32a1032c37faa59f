// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/sparse/ldlt.hpp>
#include <fretwork/mechanics/sparse/system_layout.hpp>

#include <span>

namespace fretwork::mechanics::structure {

/// Refuse a structure at rest that can move without strain in spite of its supports. Throws NumericalError
/// that names a node, or states that nothing holds the structure; Stopped.
///
/// A mechanism has a pivot that is zero or, if beams are oblique, as small as rounding. A merely soft
/// structure may have a small pivot, too. Therefore, if all pivots are positive and one of them is small, a
/// solution under an arbitrary load decides: a mechanism cannot balance the load. Rigid motions of connected
/// parts are found by their places and supports, whatever the pivots (see freely_moving_node()).
///
/// @param values   the stiffness at rest
/// @param factors  the factors of the stiffness
/// @param outcome  the outcome of the factorization
void refuse_mechanisms(const Assembly& assembly, const sparse::SystemLayout& layout,
                       std::span<const double> values, const sparse::Ldlt& factors,
                       const sparse::Ldlt::Outcome& outcome, const base::Control& control = {});

}  // namespace fretwork::mechanics::structure
