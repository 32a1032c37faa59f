// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/files/file_lock.hpp>

#include <filesystem>

namespace fretwork::studio {

/// Throws InputError unless a project may be saved there: under a name that ends with .json, where nothing is
/// yet, or a project. Other files are not to be lost.
void require_project_file(const std::filesystem::path& path);

/// The lock that the commands take, too: a program that changes a file locks it, and one that makes it locks
/// its folder. Throws InputError if another program has it.
base::FileLock lock_for_writing(const std::filesystem::path& path);

}  // namespace fretwork::studio
