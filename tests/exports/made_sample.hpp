// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sample.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/fabrication/solid.hpp>

#include <algorithm>
#include <string>
#include <vector>
