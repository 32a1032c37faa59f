// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/sparse/ldlt.hpp>
#include <fretwork/mechanics/sparse/system_layout.hpp>

#include <span>

namespace fretwork::mechanics::structure {

/// Throws NumericalError that names a node if a structure at rest, as held, can move without strain.
///
/// A mechanism's pivot vanishes, or, if its beams lie askew, is rounding: then no load on it is balanced.
/// Where a pivot is small enough for that, an arbitrary load distinguishes it from a structure that is only
/// soft.
///
/// @param values   the stiffness at rest
/// @param factors  of it
/// @param outcome  how its factorization ended
void refuse_mechanisms(const Assembly& assembly, const sparse::SystemLayout& layout,
                       std::span<const double> values, const sparse::Ldlt& factors,
                       const sparse::Ldlt::Outcome& outcome);

}  // namespace fretwork::mechanics::structure
