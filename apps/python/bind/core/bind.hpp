// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The stages of the framework as parts of the module, and what their functions share.

#include "core/casters.hpp"
#include "core/long_call.hpp"
#include "core/record.hpp"

#include <string>

namespace fretwork::python {

using namespace py::literals;  // NOLINT(google-build-using-namespace): "name"_a

void bind_errors(py::module_& module);
void bind_patterns(py::module_& module);
void bind_enumeration(py::module_& module);
void bind_frames(py::module_& module);
void bind_solvers(py::module_& module);
void bind_optimization(py::module_& module);
void bind_settings(py::module_& module);
void bind_tile_models(py::module_& module);
void bind_calibration(py::module_& module);
void bind_studies(py::module_& module);
void bind_libraries(py::module_& module);
void bind_outlines(py::module_& module);
void bind_tessellations(py::module_& module);
void bind_load_cases(py::module_& module);
void bind_projects(py::module_& module);
void bind_results(py::module_& module);
void bind_derivatives(py::module_& module);
void bind_sessions(py::module_& module);
void bind_surface_stresses(py::module_& module);
void bind_fabrication(py::module_& module);
void bind_designs(py::module_& module);
void bind_exports(py::module_& module);

/// Sets fields of a struct by keywords. Throws TypeError that names the nearest field.
void fill_record(py::object record, const py::dict& named);

/// Takes a keyword out of `named`; None if it is not there.
py::object taken(py::dict& named, const char* name);

/// Keywords of a call: the fields of an options struct, and `progress`.
template <class Options>
class Keywords {
  public:
    explicit Keywords(const py::kwargs& named) : Keywords(py::dict(named.attr("copy")()), 0) {}
    /// The keywords that are left in `named` after others were taken out. `progress` is taken out of it, too.
    static Keywords rest(py::dict named) { return Keywords(std::move(named), 0); }

    Options options{};
    py::object progress;

    /// Runs work(options) as a long call; `options.control` stops it and reports its progress.
    template <class Work>
    auto run(const Work& work) {
        return run_long(progress, [&](const base::Control& control) {
            options.control = control;
            return work(static_cast<const Options&>(options));
        });
    }

  private:
    Keywords(py::dict named, int) : progress(taken(named, "progress")) {
        fill_record(py::cast(&options, py::return_value_policy::reference), named);
    }
};

/// Throws InputError if a pattern has an edge that the layout does not.
void check(const pattern::NodeLayout& layout, const pattern::Pattern& pattern);
void check(const pattern::NodeLayout& layout, std::span<const pattern::Pattern> patterns);

/// An index that is in range. Throws IndexError.
std::size_t checked_index(std::ptrdiff_t index, std::size_t count, const char* what);

/// Functions that read, write and parse a kind of file.
template <class Value>
struct FileFunctions {
    Value (*parse)(std::string_view text, const std::string& source);
    std::string (*text)(const Value& value);
    Value (*read)(const std::filesystem::path& path);
    void (*write)(const Value& value, const std::filesystem::path& path);
};

/// Binds parse_NAME, NAME_text, read_NAME and write_NAME.
template <class Value>
void bind_files(py::module_& module, const std::string& name, const FileFunctions<Value>& functions) {
    module.def(("parse_" + name).c_str(), functions.parse, "text"_a, "source"_a = "text",
               "Parse the text of a file; `source` names the text in errors. Raises InputError.");
    module.def((name + "_text").c_str(), functions.text, py::arg(name.c_str()),
               "The text of a file with this value.");
    module.def(("read_" + name).c_str(), functions.read, "path"_a,
               "Read a file. Raises InputError that names the file and the place in it.");
    module.def(("write_" + name).c_str(), functions.write, py::arg(name.c_str()), "path"_a,
               "Write a file, completely or not at all. Raises IoError.");
}

}  // namespace fretwork::python
