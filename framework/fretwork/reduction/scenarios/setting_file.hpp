// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/scenarios/setting.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace fretwork::reduction {

/// Read a setting file. If a key such as "material" is missing, its value is taken from paper_setting(); a
/// material without the key "density" has density 0. A scenario is an object, the name of a scenario of the
/// paper, or {"use": name} with the optional keys "max_magnitude" (N) and "weight". Throws InputError with
/// file and JSON pointer.
Setting read_setting(const std::filesystem::path& path);

/// The setting named "paper" or "made" or, for another text, the setting in the file with this path.
/// "./paper" is the path of a file named paper. Throws as read_setting().
Setting find_setting(const std::string& name_or_path);
/// The name of a setting: "paper", "made", or "own" for any other setting. Strengths are ignored, and so are
/// shapes of sections with equal areas and moments.
std::string setting_name(const Setting& setting);

/// Write a setting file atomically. Throws IoError and leaves the file as it was.
void write_setting(const Setting& setting, const std::filesystem::path& path);

/// The setting as JSON text, as libraries store it.
std::string setting_text(const Setting& setting);
/// The inverse of setting_text; `source` names the text in messages. Throws InputError.
Setting parse_setting(std::string_view text, std::string source);

/// The setting without the strength and the section's shape, on which no response depends. The text of the
/// result identifies a setting.
Setting without_stresses(Setting setting);

/// The first difference between two settings in one line ("/section/J: 2.25e-12, where the library has
/// 2.3e-12"), or "" if there is none. Strengths are ignored, and so are shapes of sections with equal areas
/// and moments.
std::string setting_difference(const Setting& wanted, const Setting& present);

}  // namespace fretwork::reduction
