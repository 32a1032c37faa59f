// SPDX-License-Identifier: GPL-3.0-or-later
// The extension module behind the package `fretwork`, stage by stage in the direction of data.
#include "bind.hpp"

#include <fretwork/base/files/provenance.hpp>

namespace {

void bind_all(pybind11::module_& module) {
    using namespace fretwork::python;
    bind_errors(module);
    bind_patterns(module);
    bind_enumeration(module);
    bind_frames(module);
    bind_solvers(module);
    bind_optimization(module);
    bind_settings(module);
    bind_tile_models(module);
    bind_calibration(module);
    bind_libraries(module);
}

}  // namespace

PYBIND11_MODULE(_core, module) {
    module.attr("__module__") = "fretwork";  // where its classes and functions are found
    pybind11::options options;
    options.disable_enum_members_docstring();
    module.attr("__version__") = fretwork::base::version();
    module.def(
        "provenance", [] { return pybind11::dict(pybind11::cast(fretwork::base::provenance())); },
        "The names and values that a result should carry so that it can be made again.");
    bind_all(module);
}
