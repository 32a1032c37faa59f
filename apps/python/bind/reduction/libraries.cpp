// SPDX-License-Identifier: GPL-3.0-or-later
// Pattern libraries: one SQLite file each.
#include "core/bind.hpp"
#include "reduction/library_object.hpp"
#include "reduction/methods.hpp"
#include "reduction/tile_builds.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/library/fill.hpp>
#include <fretwork/library/merge.hpp>
#include <fretwork/library/statistics.hpp>

namespace fretwork::python {
namespace {

using namespace library;
using Names = std::vector<std::string>;

LibraryPointer shared(Library library) {
    return std::make_shared<LibraryObject>(std::move(library), "library");
}

/// The patterns with these ids; for None, all patterns.
std::vector<pattern::NamedPattern> patterns_of(const Library& library, const std::optional<Names>& ids) {
    if (!ids) return library.patterns();
    std::vector<pattern::NamedPattern> found;
    for (const std::string& id : *ids) found.push_back(library.find_pattern(id));
    return found;
}

void bind_rows(py::module_& m) {
    bind_enum<Access>(m);
    Record<CalibrationKey>(m, "CalibrationKey", "The key that distinguishes the calibrations of one pattern.")
        .field("model", &CalibrationKey::model, "")
        .field("optimizer", &CalibrationKey::optimizer, "")
        .field("seed", &CalibrationKey::seed, "")
        .field("starts", &CalibrationKey::starts, "")
        .field("budget", &CalibrationKey::budget, "largest number of evaluations")
        .done();
    Record<CalibrationRecord>(m, "CalibrationRecord", "A calibration with the library's notes on it.")
        .constant("calibration", &CalibrationRecord::calibration, "")
        .constant("budget", &CalibrationRecord::budget, "largest number of evaluations")
        .constant("seconds", &CalibrationRecord::seconds, "wall time")
        .done()
        .def_property_readonly("key", &CalibrationRecord::key);
    Record<PatternSummary>(m, "PatternSummary", "A summary of the data that a library has of one pattern.")
        .constant("pattern", &PatternSummary::pattern, "id")
        .constant("edges", &PatternSummary::edges, "")
        .constant("samples", &PatternSummary::samples, "number of samples of its responses; 0: no responses")
        .constant("converged_samples", &PatternSummary::converged_samples, "")
        .constant("stable_samples", &PatternSummary::stable_samples, "")
        .constant("limit_load_samples", &PatternSummary::limit_load_samples, "")
        .constant("calibrations", &PatternSummary::calibrations, "")
        .constant("best_objective", &PatternSummary::best_objective, "")
        .constant("failures", &PatternSummary::failures, "")
        .done(Made::ByFunctions);
    Record<FoundPattern>(m, "FoundPattern", "A pattern that Library.find() has found.")
        .constant("id", &FoundPattern::id, "")
        .constant("mirror", &FoundPattern::mirror, "id of the mirror image; empty if the layout has none")
        .constant("values", &FoundPattern::values, "a value for each column; None: not known")
        .done(Made::ByFunctions);
    Record<FoundPatterns>(m, "FoundPatterns", "The patterns that Library.find() has found, in its order.")
        .constant("columns", &FoundPatterns::columns, "names of the columns")
        .constant("patterns", &FoundPatterns::patterns, "")
        .constant("known", &FoundPatterns::known, "number of all patterns with known behaviour")
        .done(Made::ByFunctions);
    Record<Failure>(m, "Failure", "A recorded failure of a computation on one pattern.")
        .field("pattern", &Failure::pattern, "id")
        .field("computation", &Failure::computation, "")
        .field("reason", &Failure::reason, "one line")
        .done();
    Record<PatternData>(m, "PatternData", "The data to store for one pattern.")
        .field("pattern", &PatternData::pattern, "id")
        .field("responses", &PatternData::responses, "none, or one for each scenario")
        .field("calibrations", &PatternData::calibrations, "")
        .field("properties", &PatternData::properties, "pairs of name and value, SI")
        .done();
}

/// Responses of many patterns as arrays.
struct ResponseArrays {
    Names patterns;
    py::array_t<double> displacements;  ///< patterns x scenarios x magnitudes x nodes x 6
    py::array_t<double> magnitudes;     ///< scenarios x magnitudes
    py::array_t<bool> converged;        ///< patterns x scenarios x magnitudes
    py::array_t<bool> stable;
};

ResponseArrays read_arrays(const Library& library, const std::optional<Names>& ids) {
    ResponseArrays arrays;
    const auto& setting = library.setting();
    const auto nodes = static_cast<py::ssize_t>(library.layout().interface_nodes().size()) * setting.sides;
    std::vector<std::vector<reduction::Response>> found;
    const auto patterns = patterns_of(library, ids);
    auto all = library.responses(patterns);
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        if (all[i].empty()) continue;
        arrays.patterns.push_back(patterns[i].id);
        found.push_back(std::move(all[i]));
    }
    const auto count = static_cast<py::ssize_t>(found.size());
    const auto scenarios = static_cast<py::ssize_t>(setting.scenarios.size());
    const py::ssize_t steps = setting.magnitudes;
    arrays.displacements = py::array_t<double>(std::vector<py::ssize_t>{count, scenarios, steps, nodes, 6});
    arrays.magnitudes = py::array_t<double>(std::vector<py::ssize_t>{scenarios, steps});
    arrays.converged = py::array_t<bool>(std::vector<py::ssize_t>{count, scenarios, steps});
    arrays.stable = py::array_t<bool>(std::vector<py::ssize_t>{count, scenarios, steps});
    double* rows = arrays.displacements.mutable_data();
    double* magnitudes = arrays.magnitudes.mutable_data();
    bool* converged = arrays.converged.mutable_data();
    bool* stable = arrays.stable.mutable_data();
    for (const auto& responses : found) {
        double* magnitude = magnitudes;
        for (const reduction::Response& response : responses)
            for (const reduction::Response::Sample& sample : response.samples) {
                rows = std::copy_n(sample.displacements.data(), nodes * 6, rows);
                *magnitude++ = sample.magnitude;
                *converged++ = sample.converged;
                *stable++ = sample.stable;
            }
    }
    return arrays;
}

void bind_arrays(py::module_& m) {
    py::class_<ResponseArrays>(m, "ResponseArrays", "Responses of the patterns that have some, as arrays.")
        .def_property_readonly(
            "patterns", [](const ResponseArrays& self) { return self.patterns; }, "P ids")
        .def_property_readonly(
            "displacements", [](const ResponseArrays& self) { return self.displacements; },
            "P x scenarios x magnitudes x nodes x 6 floats; zeros where not converged")
        .def_property_readonly(
            "magnitudes", [](const ResponseArrays& self) { return self.magnitudes; },
            "scenarios x magnitudes floats, N")
        .def_property_readonly(
            "converged", [](const ResponseArrays& self) { return self.converged; },
            "P x scenarios x magnitudes bools")
        .def_property_readonly(
            "stable", [](const ResponseArrays& self) { return self.stable; },
            "P x scenarios x magnitudes bools");
}

using LibraryClass = py::class_<LibraryObject, LibraryPointer>;

LibraryClass bind_opening(py::module_& m) {
    LibraryClass type(
        m, "Library",
        "The pattern library: one setting, patterns of one node layout, their responses, calibrations "
        "and properties, in one SQLite file. Use by one thread at a time.\n\n"
        ">>> import fretwork as fw, tempfile\n"
        ">>> folder = tempfile.TemporaryDirectory()\n"
        ">>> layout = fw.paper_layout()\n"
        ">>> pattern = fw.parse_pattern_id(layout, '0-1+1-6')\n"
        ">>> with fw.Library.create(folder.name + '/own.db', layout, fw.paper_setting()) as library:\n"
        "...     _ = library.add_patterns([pattern])\n"
        "...     _ = library.fill()\n"
        "...     calibration = library.best_fit('0-1+1-6')\n"
        ">>> calibration.model\n"
        "'paper6'\n");
    type.def_static(
            "create",
            [](const std::filesystem::path& path, const pattern::NodeLayout& layout,
               const reduction::Setting& setting) { return shared(Library::create(path, layout, setting)); },
            "path"_a, "layout"_a, "setting"_a, "Create a new file. Raises InputError if the file exists.")
        .def_static(
            "open",
            [](const std::filesystem::path& path, Access access) {
                return shared(Library::open(path, access));
            },
            "path"_a, "access"_a = Access::ReadOnly)
        .def_static(
            "open_or_create",
            [](const std::filesystem::path& path, const pattern::NodeLayout& layout,
               const reduction::Setting& setting, const std::vector<pattern::Pattern>& patterns,
               const py::object& progress) {
                check(layout, patterns);
                return run_long(progress, [&](const base::Control& control) {
                    return shared(Library::open_or_create(path, layout, setting, patterns, control));
                });
            },
            "path"_a, "layout"_a, "setting"_a, "patterns"_a = std::vector<pattern::Pattern>{},
            "progress"_a = py::none())
        .def(
            "close", [](LibraryObject& self) { self.use().close(); },
            "Close the file; later calls raise Error.")
        .def("__enter__", [](const LibraryPointer& self) { return self; })
        .def("__exit__", [](LibraryObject& self, const py::args&) { self.use().close(); });
    return type;
}

void bind_content(LibraryClass& type) {
    type.def_property_readonly("path", [](LibraryObject& self) { return self.use()->path(); })
        .def_property_readonly("layout", [](LibraryObject& self) { return self.use()->layout(); })
        .def_property_readonly(
            "setting", [](LibraryObject& self) { return self.use()->setting(); }, "a copy")
        .def("__len__", [](LibraryObject& self) { return self.use()->pattern_count(); })
        .def("pattern_count", [](LibraryObject& self) { return self.use()->pattern_count(); })
        .def(
            "patterns", [](LibraryObject& self) { return self.use()->patterns(); },
            "All patterns, sorted by number of edges and then by their edges.")
        .def(
            "sample", [](LibraryObject& self, std::size_t size) { return self.use()->sample(size); },
            "size"_a, "Up to `size` patterns, spread over the numbers of edges.")
        .def(
            "summaries", [](LibraryObject& self) { return self.use()->summaries(); },
            "One summary for each pattern.")
        .def("fitted_patterns", [](LibraryObject& self) { return self.use()->fitted_patterns(); })
        .def(
            "objectives",
            [](LibraryObject& self, const CalibrationKey& key) { return self.use()->objectives(key); },
            "key"_a, "The objectives of all calibrations of a key, ascending.")
        .def(
            "find",
            [](LibraryObject& self, const std::string& where, const std::string& sort, bool descending,
               std::size_t limit) {
                return self.use()->find({where, sort, descending, limit});
            },
            "where"_a = "", "sort"_a = "", "descending"_a = false, "limit"_a = 0,
            "The patterns with the wanted behaviour. `where` and `sort` are SQL expressions over the "
            "columns, such as \"bending_poisson < 0\". Raises InputError that names the place in an invalid "
            "expression.")
        .def(
            "find_pattern",
            [](LibraryObject& self, std::string_view id) { return self.use()->find_pattern(id); }, "id"_a)
        .def("failures", [](LibraryObject& self) { return self.use()->failures(); })
        .def(
            "responses", [](LibraryObject& self, std::string_view id) { return self.use()->responses(id); },
            "pattern_id"_a,
            "The responses of a pattern in the order of the setting's scenarios; empty if none are stored.")
        .def(
            "response_arrays",
            [](LibraryObject& self, const std::optional<Names>& patterns) {
                return read_arrays(*self.use(), patterns);
            },
            "patterns"_a = py::none(), "The responses of these patterns (ids; None: all) as arrays.")
        .def(
            "calibrations",
            [](LibraryObject& self, std::string_view id) { return self.use()->calibrations(id); },
            "pattern_id"_a, "All calibrations of a pattern, sorted by key.")
        .def(
            "best_calibrations",
            [](LibraryObject& self, std::string_view id) { return self.use()->best_calibrations(id); },
            "pattern_id"_a, "For each tile model, the calibration with the smallest objective.")
        .def(
            "best_fit", [](LibraryObject& self, std::string_view id) { return self.use()->best_fit(id); },
            "pattern_id"_a)
        .def(
            "properties",
            [](LibraryObject& self, std::string_view id) {
                std::vector<reduction::NamedValue> values;
                for (const auto& [name, value] : self.use()->properties(id)) values.push_back({name, value});
                return values;
            },
            "pattern_id"_a, "By name, SI.")
        .def(
            "content_hash", [](LibraryObject& self) { return self.use()->content_hash(); },
            "A SHA-256 of the content, independent of the order in which the content was stored.")
        .def(
            "has_content",
            [](LibraryObject& self, std::string_view hash) { return self.use()->has_content(hash); },
            "hash"_a);
}

void bind_changes(LibraryClass& type) {
    type.def(
            "check_setting",
            [](LibraryObject& self, const reduction::Setting& wanted) { self.use()->check_setting(wanted); },
            "wanted"_a,
            "Check that the library has this setting. Raises InputError that names the first difference.")
        .def(
            "check_layout",
            [](LibraryObject& self, const pattern::NodeLayout& wanted) { self.use()->check_layout(wanted); },
            "wanted"_a)
        .def(
            "adopt_setting",
            [](LibraryObject& self, const reduction::Setting& wanted) { self.use()->adopt_setting(wanted); },
            "wanted"_a, "Replace the setting, if nothing has been computed under the present one.")
        .def(
            "add_patterns",
            [](LibraryObject& self, const std::vector<pattern::Pattern>& patterns,
               const py::object& progress) {
                const auto use = self.use();
                check(use->layout(), patterns);
                return run_long(progress, [&](const base::Control& control) {
                    return use->add_patterns(patterns, control);
                });
            },
            "patterns"_a, "progress"_a = py::none(),
            "Add patterns that the library lacks. Returns the number of patterns added.")
        .def(
            "store",
            [](LibraryObject& self, const std::vector<PatternData>& batch,
               const std::vector<Failure>& failures) { self.use()->store(batch, failures); },
            "batch"_a, "failures"_a = std::vector<Failure>{},
            "Store a batch in one transaction, completely or not at all.")
        .def("forget_failures", [](LibraryObject& self) { self.use()->forget_failures(); })
        .def(
            "export_csv",
            [](LibraryObject& self, const std::filesystem::path& folder, const py::object& progress) {
                const auto use = self.use();
                return run_long(progress, [&](const base::Control& control) {
                    use->export_csv(folder, control);
                    return true;
                });
            },
            "folder"_a, "progress"_a = py::none(), "Write each table as one CSV file.");
}

void bind_fill(py::module_& m, LibraryClass& type) {
    Record<FillReport>(m, "FillReport", "The report of fill().")
        .constant("open", &FillReport::open, "number of patterns that lacked the calibration at the start")
        .constant("done", &FillReport::done, "number of patterns calibrated by this call")
        .constant("failed", &FillReport::failed, "number of patterns recorded as failed by this call")
        .constant("dead_starts", &FillReport::dead_starts, "number of starts without a descent")
        .done(Made::ByFunctions);
    Record<FillOptions>(
        m, "FillOptions",
        "Options of fill(): the calibration that fill() adds to each pattern, and the way fill() runs.")
        .field("model", &FillOptions::model, "")
        .field("calibration", &FillOptions::calibration, "")
        .field("threads", &FillOptions::threads, "number of threads; 0: one for each processor")
        .field("seconds_between_stores", &FillOptions::seconds_between_stores, "0: at once")
        .done();
    type.def(
        "fill",
        [](LibraryObject& self, const std::optional<Names>& patterns, const py::kwargs& named) {
            const auto use = self.use();
            py::dict others(named.attr("copy")());
            const auto models = taken_models(others);
            const auto rows = taken_optimizers(others);
            auto keywords = Keywords<FillOptions>::rest(others);
            keywords.options.models = models;
            keywords.options.calibration.optimizers = rows;
            const auto wanted = patterns_of(*use, patterns);
            return keywords.run([&](const auto& options) { return fill(*use, wanted, options); });
        },
        "patterns"_a = py::none(),
        "Compute the missing data of these patterns (ids; None: all): responses, effective properties, and a "
        "calibration. `models` and `optimizers` are your own rows in addition to the built-in rows. After "
        "Ctrl-C, finished patterns are kept.\n\nOptions: FillOptions, models, optimizers, progress\n");
}

void bind_statistics(py::module_& m, LibraryClass& type) {
    Record<FarAbove>(m, "FarAbove",
                     "A calibration whose objective lies far above those of comparable calibrations.")
        .constant("pattern", &FarAbove::pattern, "id")
        .constant("objective", &FarAbove::objective, "")
        .done(Made::ByFunctions);
    Record<CalibrationStatistics>(m, "CalibrationStatistics", "Statistics of the calibrations of one key.")
        .constant("calibrated", &CalibrationStatistics::calibrated, "")
        .constant("mean", &CalibrationStatistics::mean, "mean of the objective E")
        .constant("deviation", &CalibrationStatistics::deviation,
                  "standard deviation of E over these patterns")
        .constant("median", &CalibrationStatistics::median, "")
        .constant("far_above_limit", &CalibrationStatistics::far_above_limit, "")
        .constant("far_above", &CalibrationStatistics::far_above, "")
        .constant("at_bound", &CalibrationStatistics::at_bound,
                  "for each parameter, number of patterns with this parameter at a bound")
        .constant("samples", &CalibrationStatistics::samples, "")
        .constant("converged", &CalibrationStatistics::converged, "")
        .constant("limit_load", &CalibrationStatistics::limit_load, "")
        .constant("unstable", &CalibrationStatistics::unstable, "")
        .done(Made::ByFunctions);
    type.def(
        "calibration_statistics",
        [](LibraryObject& self, const CalibrationKey& key, const std::optional<Names>& patterns) {
            const auto use = self.use();
            return calibration_statistics(*use, patterns_of(*use, patterns), key);
        },
        "key"_a, "patterns"_a = py::none(),
        "Statistics of the calibrations of these patterns (ids; None: all).");
    m.def(
        "merge",
        [](const std::filesystem::path& output, const std::vector<std::filesystem::path>& inputs,
           const py::object& progress) {
            run_long(progress, [&](const base::Control& control) {
                merge(output, inputs, control);
                return true;
            });
        },
        "output"_a, "inputs"_a, "progress"_a = py::none(),
        "Merge libraries of one layout and one setting into a new file.");
}

}  // namespace

void bind_libraries(py::module_& m) {
    bind_rows(m);
    bind_arrays(m);
    LibraryClass type = bind_opening(m);
    bind_content(type);
    bind_changes(type);
    bind_fill(m, type);
    bind_statistics(m, type);
}

}  // namespace fretwork::python
