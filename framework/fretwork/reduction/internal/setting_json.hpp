// SPDX-License-Identifier: GPL-3.0-or-later
// A setting as JSON inside other documents.
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>

namespace fretwork::reduction {

/// Read a setting as it stands in its own file. Throws InputError with source and JSON pointer.
Setting read_setting(const base::JsonReader& json);
/// Read "centreline" or "stiff". Throws InputError with source and JSON pointer.
Joints read_joints(const base::JsonReader& json);
/// The inverse of read_setting.
base::Json setting_json(const Setting& setting);

}  // namespace fretwork::reduction
