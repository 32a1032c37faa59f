# SPDX-License-Identifier: GPL-3.0-or-later
"""The behaviour of values (constructors by keywords, text, comparison and pickling), made from the fields of a class."""

import difflib


def finish(cls, is_made_by_fields):
    """Give a class of the extension module the behaviour of a value. Its fields are the keys of `_setters`."""
    cls._fields = tuple(cls.__dict__.get("_setters", {}))
    bare_new, bare_init = cls.__mro__[-2].__new__, cls.__init__

    def new(kind, *_values, **_named):  # there is no object without its value
        made = bare_new(kind)
        bare_init(made)
        return made

    def init(self, *values, **named):
        _fill(self, cls, values, named)

    def refuse(self, *_values, **_named):
        raise TypeError(f"{cls.__name__} is made by functions, which check it; see its docstring")

    cls.__new__ = new
    cls.__init__ = init if is_made_by_fields else refuse
    cls.__match_args__ = cls._fields
    cls.__repr__ = _repr
    cls.__eq__ = _equal
    cls.__hash__ = None
    cls.__reduce__ = _reduce
    cls.__copy__ = lambda self: _restored(cls, *_values(self))
    cls.__deepcopy__ = lambda self, _memo: _restored(cls, *_values(self))


def guard(module):
    """Let `X.__new__(X)` require what `X()` requires, because no object of the extension module exists without its value.

    A subclass with other parameters defines `__new__`, as one of tuple does.
    """
    for kind in _classes(vars(module)):
        if not hasattr(kind, "_fields"):
            _guard(kind)


def _classes(names):
    for part in list(names.values()):
        if type(part).__name__ == "pybind11_type":
            yield part
            yield from _classes(vars(part))


def _guard(cls):
    bare_new, bare_init = cls.__mro__[-2].__new__, cls.__init__
    is_made_by_functions = "__init__" not in vars(cls)

    def new(kind, *values, **named):
        if is_made_by_functions:
            raise TypeError(f"{cls.__name__} is made by functions; see its docstring")
        made = bare_new(kind)
        bare_init(made, *values, **named)  # a second call of it does nothing
        return made

    cls.__new__ = new
    if hasattr(cls, "__setstate__"):
        cls.__reduce__ = lambda self: (_thawed, (type(self), self.__getstate__()))


def _thawed(cls, state):
    made = cls.__mro__[-2].__new__(cls)
    cls.__setstate__(made, state)
    return made


def _fill(record, cls, values, named):
    if len(values) > len(cls._fields):
        raise TypeError(f"{cls.__name__}() takes {len(cls._fields)} values, and {len(values)} were given")
    for name, value in zip(cls._fields, values):
        if name in named:
            raise TypeError(f"{cls.__name__}() got two values for '{name}'")
        named[name] = value
    for name, value in named.items():
        set_field(record, cls, name, value)


def set_field(record, cls, name, value):
    """Set a field by its name. The error names the nearest field for an unknown name, and the type for a wrong value."""
    if name not in cls._setters:
        near = difflib.get_close_matches(name, cls._fields, 1)
        hint = f"; did you mean '{near[0]}'?" if near else f"; there is: {', '.join(cls._fields)}"
        raise TypeError(f"{cls.__name__} has no field '{name}'{hint}")
    try:
        cls._setters[name](record, value)
    except TypeError as error:
        wanted = getattr(cls, name).fget.__doc__.rpartition("-> ")[2].strip()
        raise TypeError(f"{cls.__name__}.{name} takes {wanted}, and not {value!r}") from error


def fill(record, named):
    """Set fields by keywords."""
    for name, value in named.items():
        set_field(record, type(record), name, value)


def _values(record):
    return tuple(getattr(record, name) for name in record._fields)


def _restored(cls, *values):
    record = cls.__new__(cls)
    for name, value in zip(cls._fields, values):
        cls._setters[name](record, value)
    return record


def _reduce(record):
    return _restored, (type(record), *_values(record))


def _repr(record):
    shown = ", ".join(f"{name}={_short(getattr(record, name))}" for name in record._fields)
    return f"{type(record).__name__}({shown})"


def _short(value, most=200):
    if hasattr(value, "shape") and hasattr(value, "dtype"):
        return f"array({value.tolist()})" if value.size <= 12 else f"<{' x '.join(map(str, value.shape))} array>"
    if isinstance(value, tuple) and len(value) > 6:
        return f"<{len(value)} of {type(value[0]).__name__}>"
    text = repr(value)
    return text if len(text) <= most else f"<{type(value).__name__}>"


def _equal(left, right):
    if type(left) is not type(right):
        return NotImplemented
    return all(_same(a, b) for a, b in zip(_values(left), _values(right)))


def _same(left, right):
    if hasattr(left, "shape") or hasattr(right, "shape"):
        import numpy

        return numpy.array_equal(left, right)
    if isinstance(left, tuple) and isinstance(right, tuple):
        return len(left) == len(right) and all(map(_same, left, right))
    return bool(left == right)
