// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/results/result_subject.hpp>

#include <span>
#include <string>
#include <vector>

namespace fretwork::app {

/// Read a surface's result and check its subject. Each warning about the result is a line on standard error.
/// Throws InputError if the file or the subject is invalid.
simulation::SurfaceResult read_surface_result(const std::string& file);

/// Read results and check their subjects. A warning that several results have is one line that names all
/// their files. Throws as read_surface_result().
std::vector<simulation::SurfaceResult> read_surface_results(std::span<const std::string> files);

/// Throw InputError unless the result, which was read from `file`, belongs to this surface. Load cases are
/// not compared.
void check_subject_of(const simulation::SurfaceIdentity& surface, const simulation::SurfaceResult& result,
                      const std::string& file);

}  // namespace fretwork::app
