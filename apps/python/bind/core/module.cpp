// SPDX-License-Identifier: GPL-3.0-or-later
// The extension module behind the package `fretwork`, stage by stage in the direction of data.
#include "core/bind.hpp"

#include <fretwork/base/files/provenance.hpp>

#include <map>
#include <string>

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
    bind_studies(module);
    bind_libraries(module);
    bind_outlines(module);
    bind_tessellations(module);
    bind_load_cases(module);
    bind_projects(module);
    bind_results(module);
    bind_derivatives(module);
    bind_sessions(module);
    bind_surface_stresses(module);
    bind_fabrication(module);
    bind_designs(module);
    bind_exports(module);
}

}  // namespace

PYBIND11_MODULE(_core, module) {
    module.attr("__module__") = "fretwork";  // where its classes and functions are found
    pybind11::options options;
    options.disable_enum_members_docstring();
    module.attr("__version__") = fretwork::base::version();
    module.def(
        "provenance",
        [] {
            const auto pairs = fretwork::base::provenance();
            return std::map<std::string, std::string>(pairs.begin(), pairs.end());
        },
        "The names and values that a result should record so that it can be reproduced.");
    bind_all(module);
}
