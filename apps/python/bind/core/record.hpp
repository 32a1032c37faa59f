// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/enums.hpp"

#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

namespace fretwork::python {

/// Names a field of a class for its constructor, comparison, text and pickle.
void add_field(py::object& type, const char* name, const py::object& set);

/// How values of a class come into being in Python.
enum class Made {
    ByFields,     ///< by its constructor, whose keywords are the fields
    ByFunctions,  ///< by functions only, which check the values; fields are read-only
};

/// Gives a class its constructor, `__repr__`, `__eq__`, `__copy__` and pickling from its fields.
void finish_record(py::object& type, Made made);

/// A list as a tuple and an array as a read-only one, so that nobody changes a copy; anything else as it is.
py::object frozen(py::object value);

/// A copy of a text that lives as long as the program, for members that are views. Rows of catalogues have
/// such members, with few different texts.
std::string_view kept_text(std::string_view text);

/// The value of a member, on its way to Python: frozen.
template <class Value>
struct Frozen {
    Value value;
};

template <class Value>
concept ListLike = requires(const py::detail::make_caster<Value>& caster) {
    []<class List, class Element>(const py::detail::list_caster<List, Element>&) {}(caster);
};

template <class Value>
concept EigenDense = py::detail::is_eigen_dense_plain<Value>::value;

/// A struct of the framework as a class in Python. Members that are structs themselves are references into
/// their owner, which they keep alive. Arrays of fixed size, and arrays that cannot be set, are views of the
/// owner. Lists come out as tuples, and other members as copies.
template <class T>
class Record {
  public:
    Record(py::handle scope, const char* name, const char* doc) : type_(scope, name, doc) { construct(); }
    template <class Base>
    Record(py::handle scope, const char* name, const py::class_<Base>& base, const char* doc)
        : type_(scope, name, base, doc) {
        construct();
    }

    /// A field that can be read and set.
    template <class Owner, class Member>
    Record& field(const char* name, Member Owner::*member, const char* doc) {
        const py::cpp_function set = setter(member);
        type_.def_property(name, getter<Member&>(member), set, doc);
        add_field(type_, name, set);
        return *this;
    }
    /// A field that can be read, and is set only when an object is made.
    template <class Owner, class Member>
    Record& constant(const char* name, Member Owner::*member, const char* doc) {
        type_.def_property_readonly(name, getter<const Member&>(member), doc);
        add_field(type_, name, setter(member));
        return *this;
    }
    py::class_<T>& done(Made made = Made::ByFields) {
        finish_record(type_, made);
        return type_;
    }
    py::class_<T>& type() { return type_; }

  private:
    template <class Member>
    static constexpr bool kIsStruct =
        std::is_base_of_v<py::detail::type_caster_generic, py::detail::make_caster<Member>>;
    template <class Access, class Member>
    static constexpr bool kIsView = [] {
        if constexpr (EigenDense<Member>)
            return Member::SizeAtCompileTime != Eigen::Dynamic ||
                   std::is_const_v<std::remove_reference_t<Access>>;
        return false;
    }();

    void construct() {
        if constexpr (std::is_default_constructible_v<T>) type_.def(py::init<>());
    }
    /// No array is a view of memory that a setter may move. `Access` is Member& if the member can be set,
    /// else const Member&.
    template <class Access, class Owner, class Member>
    static py::cpp_function getter(Member Owner::*member) {
        if constexpr (kIsStruct<Member>)
            return py::cpp_function([member](T& self) -> Member& { return self.*member; },
                                    py::return_value_policy::reference_internal);
        else if constexpr (kIsView<Access, Member>)
            return py::cpp_function([member](T& self) -> Access { return self.*member; },
                                    py::return_value_policy::reference_internal);
        else
            return py::cpp_function([member](const T& self) { return Frozen<Member>{self.*member}; });
    }
    template <class Owner, class Member>
    static py::cpp_function setter(Member Owner::*member) {
        // The text of a view would end with the Python object from which it comes.
        if constexpr (std::is_same_v<Member, std::string_view>)
            return py::cpp_function([member](T& self, Member value) { self.*member = kept_text(value); });
        else
            return py::cpp_function([member](T& self, Member value) {
                forget_origins(value);
                self.*member = std::move(value);
            });
    }
    /// A list that Python sets is in no file, also if its entries were read from some.
    template <class Value>
    static void forget_origins(Value& value) {
        if constexpr (ListLike<Value>) {
            if constexpr (requires { value.front().origin = {}; })
                for (auto& entry : value) entry.origin = {};
        }
    }

    py::class_<T> type_;
};

}  // namespace fretwork::python

namespace pybind11::detail {

template <class Value>
struct type_caster<fretwork::python::Frozen<Value>> {
    static constexpr auto name = [] {
        if constexpr (fretwork::python::ListLike<Value>)
            return const_name("Tuple[") + make_caster<typename Value::value_type>::name +
                   const_name(", ...]");
        else
            return make_caster<Value>::name;
    }();
    static handle cast(fretwork::python::Frozen<Value> frozen, return_value_policy policy, handle parent) {
        auto value = make_caster<Value>::cast(std::move(frozen.value), policy, parent);
        return fretwork::python::frozen(reinterpret_steal<object>(value)).release();
    }
};

}  // namespace pybind11::detail
