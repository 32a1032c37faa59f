// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bind.hpp"

#include <fretwork/base/control.hpp>
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>

#include <functional>

namespace fretwork::python {
namespace {

/// The exception classes; they live as long as the program.
struct Exceptions {
    PyObject* error = nullptr;
    PyObject* input = nullptr;
    PyObject* geometry = nullptr;
    PyObject* numerical = nullptr;
    PyObject* io = nullptr;
    PyObject* stopped = nullptr;
};

Exceptions& exceptions() {
    static Exceptions classes;
    return classes;
}

PyObject* make_class(py::module_& module, const char* name, const py::tuple& bases, const char* doc) {
    const std::string full = "fretwork." + std::string(name);
    PyObject* made = PyErr_NewExceptionWithDoc(full.c_str(), doc, bases.ptr(), nullptr);
    if (made == nullptr) throw py::error_already_set();
    module.attr(name) = py::handle(made);
    return made;
}

/// A text as one line. It may quote a file whose bytes are not UTF-8.
py::str line(const std::string& text) {
    return base::printable(text);
}

py::tuple places_of(const base::ErrorData& data) {
    py::list places;
    for (const auto& [source, place] : data.where) places.append(py::make_tuple(line(source), line(place)));
    return py::tuple(places);
}

py::tuple facts_of(const base::ErrorData& data) {
    py::list facts;
    for (const std::string& fact : data.about) facts.append(line(fact));
    return py::tuple(facts);
}

/// The innermost source that is not empty, and the place in it.
std::pair<std::string, std::string> innermost(const base::ErrorData& data) {
    std::pair<std::string, std::string> found;
    for (const auto& [source, place] : data.where) {
        if (!source.empty()) found = {source, ""};
        if (!place.empty()) found.second = place;
    }
    return found;
}

void raise(PyObject* type, const base::Error& error) {
    const py::object raised = py::handle(type)(line(base::text_of(error.data())));
    const auto [source, place] = innermost(error.data());
    raised.attr("problem") = line(error.data().problem);
    raised.attr("kind") = error.data().kind;
    raised.attr("source") = line(source);
    raised.attr("place") = line(place);
    raised.attr("where") = places_of(error.data());
    raised.attr("about") = facts_of(error.data());
    PyErr_SetObject(type, raised.ptr());
}

void translate(std::exception_ptr thrown) {
    try {
        if (thrown) std::rethrow_exception(thrown);
    } catch (const base::GeometryError& error) {
        raise(exceptions().geometry, error);
    } catch (const base::InputError& error) {
        raise(exceptions().input, error);
    } catch (const base::NumericalError& error) {
        raise(exceptions().numerical, error);
    } catch (const base::IoError& error) {
        raise(exceptions().io, error);
    } catch (const base::Stopped& error) {
        raise(exceptions().stopped, error);
    } catch (const base::Error& error) {
        raise(exceptions().error, error);
    } catch (const std::bad_function_call&) {
        PyErr_SetString(PyExc_TypeError, "a function is needed where None was passed");
    } catch (const py::cast_error&) {
        // pybind11's own message is for people who write bindings.
        PyErr_SetString(PyExc_TypeError,
                        "a keyword, or the answer of a function that was passed, has another type than the "
                        "docstring says");
    }
}

}  // namespace

void bind_errors(py::module_& module) {
    bind_enum<base::ErrorKind>(module);
    Exceptions& classes = exceptions();
    const auto also = [](PyObject* first, PyObject* second) {
        return py::make_tuple(py::handle(first), py::handle(second));
    };
    classes.error = make_class(
        module, "Error", py::make_tuple(py::handle(PyExc_Exception)),
        "The base class of all errors of the framework. Its text is one line.\n\nAttributes: `problem` (what "
        "is wrong, and what would be valid), `kind` (an ErrorKind), `source` and `place` (the innermost "
        "file, option or message, and the JSON pointer, line or element in it; may be empty), `where` (all "
        "pairs of source and place, the outermost first), `about` (texts, as the kind says).");
    classes.input = make_class(module, "InputError", also(classes.error, PyExc_ValueError),
                               "A file, an argument or an option is invalid.");
    classes.geometry = make_class(module, "GeometryError", py::make_tuple(py::handle(classes.input)),
                                  "A shape is well-formed data, but impossible geometry.");
    classes.numerical =
        make_class(module, "NumericalError", also(classes.error, PyExc_ArithmeticError),
                   "A system of equations has no usable solution, as for a structure without supports.");
    classes.io = make_class(module, "IoError", also(classes.error, PyExc_OSError),
                            "The operating system refuses to read or write.");
    classes.stopped = make_class(module, "Stopped", py::make_tuple(py::handle(classes.error)),
                                 "A long computation was stopped on request; nothing is half-written.");
    py::register_exception_translator(translate);
}

}  // namespace fretwork::python
