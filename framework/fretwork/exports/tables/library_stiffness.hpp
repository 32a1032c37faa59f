// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/library/library.hpp>

#include <filesystem>
#include <span>
#include <string>

namespace fretwork::exports {

/// Options of stiffness_array().
struct StiffnessOptions {
    int threads = 0;          ///< number of threads; 0: one for each processor
    base::Control control{};  ///< progress counts patterns
};

/// The stiffness of each of `patterns` at small displacements, condensed onto the n interface nodes of the
/// polygon of the library's setting, as a NumPy file (.npy, version 1.0).
///
/// The array has the shape patterns x 6n x 6n, float64, little-endian. Rows and columns are node by node ux
/// uy uz rx ry rz; N/m, N and N m. The bytes depend on the patterns and the setting alone. Throws InputError
/// that names the pattern if an interface node has no beam, and Stopped.
std::string stiffness_array(const library::Library& library, std::span<const pattern::NamedPattern> patterns,
                            const StiffnessOptions& options = {});

/// Add `stiffness.npy` and `patterns.txt` to a batch; the caller commits it. The lines of `patterns.txt` name
/// the patterns of the array in order. Throws as stiffness_array(), and IoError.
void add_stiffness(const library::Library& library, std::span<const pattern::NamedPattern> patterns,
                   const StiffnessOptions& options, base::FolderBatch& batch);

/// Check that each file of a batch is new in a folder, or has equal bytes there. An export may thus be
/// repeated, and replaces neither the stiffness of another library, setting or choice of patterns nor any
/// other file. Throws InputError that names the file, and Stopped.
void require_same_stiffness(const std::filesystem::path& folder, const base::FolderBatch& batch,
                            const base::Control& control = {});

}  // namespace fretwork::exports
