// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How the framework's small types become Python's: indices are ints, points are rows of arrays, sets of dofs
// are names, exact fractions are fractions.Fraction. Every source of the module includes this before any
// binding, mostly by bind.hpp.

#include <fretwork/base/index_vector.hpp>
#include <fretwork/geometry/polygon.hpp>
#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/pattern/pattern.hpp>
#include <fretwork/reduction/calibration/calibration.hpp>

#include <bitset>
#include <cstring>
#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace fretwork::python {

namespace py = pybind11;

/// The names of an enum's values in Python, in their order. Specialized in enums.hpp.
template <class Enum>
struct Words;

template <class Enum>
concept Worded = std::is_enum_v<Enum> && requires {
    Words<Enum>::kName;
};

/// The place of a Python word among those of an enum; -1 if the object is no text. Throws InputError that
/// names the nearest word if the word is unknown.
int place_of_word(py::handle object, const char* kind, std::span<const char* const> words);

/// Reads a set of dofs from the names of its components. Returns false if the object is neither a text nor
/// iterable. Throws InputError for an unknown word.
bool read_dofs(py::handle object, mechanics::DofSet& dofs);
py::object dof_names(const mechanics::DofSet& dofs);

/// An array of doubles with this many columns; an empty sequence gives an array without rows. A null array if
/// the object is no such array.
py::array_t<double, py::array::c_style | py::array::forcecast> read_rows(py::handle object,
                                                                         py::ssize_t columns, bool convert);

/// Decimal digits as a Python int.
py::object int_of_digits(const std::string& digits);

py::object fraction(std::int64_t numerator, std::int64_t denominator);
/// Throws TypeError for a float, and otherwise the errors of Fraction() and of Rational.
pattern::Rational read_fraction(py::handle object);

}  // namespace fretwork::python

namespace pybind11::detail {

/// Indices by role: plain ints in Python.
template <class Tag>
struct type_caster<fretwork::base::Index<Tag>> {
    PYBIND11_TYPE_CASTER(fretwork::base::Index<Tag>, const_name("int"));
    bool load(handle source, bool convert) {
        make_caster<std::int32_t> number;
        if (!number.load(source, convert)) return false;
        value = fretwork::base::Index<Tag>(cast_op<std::int32_t>(number));
        return true;
    }
    static handle cast(fretwork::base::Index<Tag> index, return_value_policy, handle) {
        return PyLong_FromLong(index.value);
    }
};

/// Elements that are rows of doubles: an n x columns array in Python.
template <class Rows, std::size_t kColumns>
struct RowsCaster {
    using Element = typename Rows::value_type;
    static_assert(sizeof(Element) == kColumns * sizeof(double));
    PYBIND11_TYPE_CASTER(Rows, const_name("numpy.ndarray[numpy.float64[n, ") + const_name<kColumns>() +
                                   const_name("]]"));
    bool load(handle source, bool convert) {
        const auto rows = fretwork::python::read_rows(source, static_cast<ssize_t>(kColumns), convert);
        if (!rows) return false;
        value.resize(static_cast<std::size_t>(rows.shape(0)));
        if (!value.empty())
            std::memcpy(static_cast<void*>(value.data()), rows.data(), value.size() * sizeof(Element));
        return true;
    }
    static handle cast(const Rows& rows, return_value_policy, handle) {
        const auto count = static_cast<ssize_t>(rows.size());
        array_t<double> array({count, static_cast<ssize_t>(kColumns)});
        if (count > 0) std::memcpy(array.mutable_data(), rows.data(), rows.size() * sizeof(Element));
        return array.release();
    }
};

template <>
struct type_caster<std::vector<fretwork::geometry::Point2>>
    : RowsCaster<std::vector<fretwork::geometry::Point2>, 2> {};
template <>
struct type_caster<std::vector<Eigen::Vector3d>> : RowsCaster<std::vector<Eigen::Vector3d>, 3> {};
template <>
struct type_caster<std::vector<std::array<double, 3>>> : RowsCaster<std::vector<std::array<double, 3>>, 3> {};
template <class Role>
struct type_caster<fretwork::base::IndexVector<Role, fretwork::geometry::Point2>>
    : RowsCaster<fretwork::base::IndexVector<Role, fretwork::geometry::Point2>, 2> {};
template <class Role>
struct type_caster<fretwork::base::IndexVector<Role, Eigen::Vector3d>>
    : RowsCaster<fretwork::base::IndexVector<Role, Eigen::Vector3d>, 3> {};
template <class Role, class T>
struct type_caster<fretwork::base::IndexVector<Role, T>>
    : list_caster<fretwork::base::IndexVector<Role, T>, T> {};

/// A single point: a pair of floats.
template <>
struct type_caster<fretwork::geometry::Point2> {
    PYBIND11_TYPE_CASTER(fretwork::geometry::Point2, const_name("Tuple[float, float]"));
    bool load(handle source, bool convert) {
        make_caster<std::array<double, 2>> pair;
        if (!pair.load(source, convert)) return false;
        const auto& numbers = cast_op<std::array<double, 2>&>(pair);
        value = {numbers[0], numbers[1]};
        return true;
    }
    static handle cast(const fretwork::geometry::Point2& point, return_value_policy, handle) {
        return make_tuple(point.x, point.y).release();
    }
};

template <>
struct type_caster<fretwork::mechanics::DofSet> {
    PYBIND11_TYPE_CASTER(fretwork::mechanics::DofSet, const_name("Tuple[str, ...]"));
    bool load(handle source, bool) { return fretwork::python::read_dofs(source, value); }
    static handle cast(const fretwork::mechanics::DofSet& dofs, return_value_policy, handle) {
        return fretwork::python::dof_names(dofs).release();
    }
};

template <>
struct type_caster<fretwork::pattern::Rational> {
    PYBIND11_TYPE_CASTER(fretwork::pattern::Rational, const_name("fractions.Fraction"));
    bool load(handle source, bool) {
        value = fretwork::python::read_fraction(source);
        return true;
    }
    static handle cast(const fretwork::pattern::Rational& number, return_value_policy, handle) {
        return fretwork::python::fraction(number.numerator(), number.denominator()).release();
    }
};

/// A set of candidate edges: their numbers, ascending.
template <>
struct type_caster<fretwork::pattern::Pattern::Bits> {
    using Bits = fretwork::pattern::Pattern::Bits;
    PYBIND11_TYPE_CASTER(Bits, const_name("Tuple[int, ...]"));
    bool load(handle source, bool convert) {
        make_caster<std::vector<int>> numbers;
        if (!numbers.load(source, convert)) return false;
        for (const int number : cast_op<std::vector<int>&>(numbers)) {
            if (number < 0 || number >= fretwork::pattern::kMaxCandidateEdges)
                throw index_error("there is no candidate edge " + std::to_string(number));
            value.set(static_cast<std::size_t>(number));
        }
        return true;
    }
    static handle cast(const Bits& bits, return_value_policy, handle) {
        std::vector<int> numbers;
        for (std::size_t e = bits._Find_first(); e < bits.size(); e = bits._Find_next(e))
            numbers.push_back(static_cast<int>(e));
        return tuple(pybind11::cast(numbers)).release();
    }
};

/// A view of elements, for parameters: Python may pass any sequence.
template <class T>
struct type_caster<std::span<const T>> {
    using Owner = make_caster<std::vector<T>>;
    static constexpr auto name = Owner::name;
    template <class>
    using cast_op_type = std::span<const T>;
    bool load(handle source, bool convert) { return owner_.load(source, convert); }
    operator std::span<const T>() { return cast_op<std::vector<T>&>(owner_); }
    static handle cast(std::span<const T> elements, return_value_policy policy, handle parent) {
        return Owner::cast(std::vector<T>(elements.begin(), elements.end()), policy, parent);
    }

  private:
    Owner owner_;
};

/// Numbers by name: a dict.
template <>
struct type_caster<std::vector<fretwork::reduction::NamedValue>> {
    using Values = std::vector<fretwork::reduction::NamedValue>;
    PYBIND11_TYPE_CASTER(Values, const_name("Dict[str, float]"));
    bool load(handle source, bool) {
        if (!isinstance<dict>(source)) return false;
        for (const auto& [name, number] : reinterpret_borrow<dict>(source))
            value.push_back({name.cast<std::string>(), number.cast<double>()});
        return true;
    }
    static handle cast(const Values& values, return_value_policy, handle) {
        dict named;
        for (const auto& [name, number] : values) named[str(name)] = number;
        return named.release();
    }
};

/// An enum: a member of its class in Python, or its word.
template <fretwork::python::Worded Enum>
struct type_caster<Enum> {
    using Words = fretwork::python::Words<Enum>;
    PYBIND11_TYPE_CASTER(Enum, const_name("fretwork.") + const_name(Words::kName));
    bool load(handle source, bool) {
        const int place = fretwork::python::place_of_word(source, Words::kName, Words::kWords);
        if (place < 0) return false;
        value = static_cast<Enum>(place);
        return true;
    }
    static handle cast(Enum member, return_value_policy, handle) {
        return object(handle(type)[Words::kWords.at(static_cast<std::size_t>(member))]).release();
    }
    static inline PyObject* type = nullptr;  ///< a dict from word to member; lives as long as the program
};

}  // namespace pybind11::detail
