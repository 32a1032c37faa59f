// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace fretwork::mechanics {

/// Read the text of a frame file. Throws InputError that names `source`, and the place in it. The frame is
/// valid.
Frame parse_frame(std::string_view text, const std::string& source);
/// The text of a frame file; equal materials and sections are written once. parse_frame gives an equal frame.
std::string frame_text(const Frame& frame);

/// Throws as parse_frame.
Frame read_frame(const std::filesystem::path& path);
/// Throws IoError.
void write_frame(const Frame& frame, const std::filesystem::path& path);

}  // namespace fretwork::mechanics
