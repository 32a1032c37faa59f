// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/scenarios/setting.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace fretwork::reduction {

/// Read a setting file. Values that are left out are as in paper_setting(); a scenario is an object, the name
/// of one of the paper's, or {"use": name, "max_magnitude": newtons}. Throws InputError with file and JSON
/// pointer.
Setting read_setting(const std::filesystem::path& path);

/// The setting called "paper" or "made", or that of a file ("./paper": of a file called so). Throws as
/// read_setting.
Setting find_setting(const std::string& name_or_path);
/// "paper" or "made"; "own" for any other. Strengths and shapes of equal numbers do not count.
std::string setting_name(const Setting& setting);

/// Throws IoError; then the file is as it was.
void write_setting(const Setting& setting, const std::filesystem::path& path);

/// The setting as JSON text: what a library stores.
std::string setting_text(const Setting& setting);
/// The inverse of setting_text; `source` names the text in messages.
Setting parse_setting(std::string_view text, std::string source);

/// All that responses depend on, without strength and shape of the section: its text identifies a setting.
Setting without_stresses(Setting setting);

/// In one line, the first difference between two settings ("/section/J: 2.25e-12, where the library
/// has 2.3e-12"), or "". Strengths and shapes of equal numbers do not count.
std::string setting_difference(const Setting& wanted, const Setting& present);

}  // namespace fretwork::reduction
