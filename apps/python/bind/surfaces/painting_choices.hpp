// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/casters.hpp"

#include <fretwork/simulation/project/painting_choice.hpp>

#include <string>
#include <variant>
#include <vector>

namespace pybind11::detail {

/// The content of a file: bytes.
template <>
struct type_caster<fretwork::simulation::FileContent> {
    PYBIND11_TYPE_CASTER(fretwork::simulation::FileContent, const_name("bytes"));
    bool load(handle source, bool) {
        if (!isinstance<bytes>(source)) return false;
        value.bytes = source.cast<std::string>();
        return true;
    }
    static handle cast(const fretwork::simulation::FileContent& content, return_value_policy, handle) {
        return bytes(content.bytes).release();
    }
};

}  // namespace pybind11::detail

namespace fretwork::python {

/// How tiles are painted, as Python gives it: None, a text as on the command line, ids to choose from at
/// random, or one of the structs.
using PaintingGiven =
    std::variant<std::monostate, std::string, std::vector<std::string>, simulation::PaintOnePattern,
                 simulation::PaintFromFile, simulation::PaintAtRandom, simulation::PaintByField,
                 simulation::PaintByColours>;

/// The choice that Python gives. For a text, the keywords `palette`, `property`, `range` and `dither` are
/// taken out of `named`. Throws InputError if the text is invalid, or if the keywords do not fit the text.
simulation::PaintingChoice painting_choice(const PaintingGiven& given, py::dict& named);

}  // namespace fretwork::python
