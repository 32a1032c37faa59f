# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the type stubs of the package: what type checkers and editors see.

They are made from the module itself: pybind11 writes each function's signature into its docstring, options of functions
are named there by a line "Options: NAME, ..", and fields of values say their types. Usage: stubs.py PACKAGE_FOLDER
"""

import enum
import inspect
import pathlib
import re
import sys
import types

HEADER = '''# SPDX-License-Identifier: GPL-3.0-or-later
# Written by apps/python/stubs.py; do not edit.
import enum
import fractions
import os
import pathlib
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Generic, Literal, TypeVar, overload

import numpy as np
import numpy.typing as npt

_Got = TypeVar("_Got")
_Set = TypeVar("_Set")
_Array = npt.ArrayLike | Sequence[float] | Sequence[Sequence[float]]
_Progress = Callable[[str, int, int], object] | bool | None
_Floats = npt.NDArray[np.float64]
_Design = Mapping[str, npt.ArrayLike]

class _Field(Generic[_Got, _Set]):
    @overload
    def __get__(self, owner: None, kind: type) -> _Field[_Got, _Set]: ...
    @overload
    def __get__(self, owner: object, kind: type | None = ...) -> _Got: ...
    def __set__(self, owner: object, value: _Set) -> None: ...

__version__: str
'''

# Keywords that are not fields of an options struct.
KEYWORDS = {
    "progress": ["progress: _Progress = ..."],
    "models": ["models: Sequence[TileModel] | None = ..."],
    "optimizers": ["optimizers: Sequence[OptimizerRow] | None = ..."],
    "palette": ["palette: str | Sequence[str] | None = ..."],
    "property": ["property: str | None = ..."],
    "range": ["range: str | None = ..."],
    "on_better": ["on_better: Callable[[DesignProgress], object] | None = ..."],
    "dither": ["dither: bool = ..."],
    "scene": ["scale: float = ...", "view: str | None = ...", "size: str | None = ...", "colour: str | None = ...",
              "strength: float | None = ...", 'labels: Sequence[Literal["tiles", "nodes"]] = ...']
             + [f"{name}: str | None = ..." for name in
                ("fillet", "kerf", "frame", "bolts", "eye", "bed", "fit", "clearance", "layer")],
}


def split(text):
    """The parts of a list that commas separate, brackets and quotes respected."""
    parts, depth, start, quote = [], 0, 0, ""
    for i, c in enumerate(text):
        if quote:
            quote = "" if c == quote else quote
        elif c in "'\"":
            quote = c
        elif c in "([{<":
            depth += 1
        elif c in ")]}>" and text[i - 1] != "-":
            depth -= 1
        elif c == "," and depth == 0:
            parts.append(text[start:i].strip())
            start = i + 1
    last = text[start:].strip()
    return parts + [last] if last else parts


class Types:
    """The types of pybind11's signatures as those of stubs."""

    def __init__(self, enums):
        self._enums = enums

    def returned(self, text):
        text = re.sub(r"numpy\.ndarray\[numpy\.(\w+)\[[^\]]*\](?:, flags[^\]]*)?\]", r"npt.NDArray[np.\1]", text)
        text = re.sub(r"numpy\.ndarray\[(?:numpy\.)?(\w+)\]", self._plain_array, text)
        text = re.sub(r"\bList\[", "list[", re.sub(r"\bTuple\[", "tuple[", re.sub(r"\bDict\[", "dict[", text)))
        text = re.sub(r"\bobject\b", "Any", text.replace("os.PathLike", "pathlib.Path"))
        return self._common(text)

    @staticmethod
    def _plain_array(match):
        return f"npt.NDArray[np.{'bool_' if match[1] == 'bool' else match[1]}]"

    def taken(self, text):
        text = re.sub(r"numpy\.ndarray\[numpy\.\w+(\[[^\]]*\])?(?:, flags[^\]]*)?\]", "_Array", text)
        text = re.sub(r"\bList\[int\]", "Iterable[int]", text)
        text = re.sub(r"\bList\[", "Sequence[", text)
        text = re.sub(r"\bTuple\[str, \.\.\.\]", "str | Iterable[str]", text)
        text = re.sub(r"\bTuple\[float, float\]", "Sequence[float]", re.sub(r"\bDict\[", "dict[", text))
        text = re.sub(r"\bTuple\[int, \.\.\.\]", "Iterable[int]", text)
        text = re.sub(r"\bTuple\[(\w[\w.]*), \.\.\.\]", r"Sequence[\1]", text)
        text = re.sub(r"\bTuple\[", "tuple[", text.replace("os.PathLike", "str | os.PathLike[str]"))
        text = re.sub(r"(\w[\w.]*)\[(int|float)\[\d\]\]", r"Sequence[\2]", text)
        text = self._common(text).replace("fractions.Fraction", "fractions.Fraction | int | str")
        return re.sub(r"\b(%s)\b" % "|".join(map(re.escape, self._enums)), r"\1 | str", text) if self._enums else text

    def _common(self, text):
        text = re.sub(r"\bfretwork\._core\.|\bfretwork\.", "", text)
        text = self._unwrapped(text, "Optional", lambda inner: f"{inner} | None")
        text = self._unwrapped(text, "Union", lambda inner: " | ".join(split(inner)))
        text = re.sub(r"Annotated\[(.+?), FixedSize\(\d+\)\]", r"\1", text)
        text = re.sub(r"(?:list|Sequence|List)\[(\w[\w.]*)\[(\d)\]\]", lambda m: f"list[{m[1]}]", text)
        text = re.sub(r"\b(\w[\w.]*)\[(\d+)\]", lambda m: f"list[{m[1]}]", text)
        text = text.replace("std::monostate", "None").replace("function", "Callable[..., Any]")
        return re.sub(r"\b(args|kwargs|handle|iterable)\b", "Any", text)

    @staticmethod
    def _unwrapped(text, name, change):
        while (start := text.find(name + "[")) >= 0:
            end, depth = start + len(name) + 1, 1
            while depth:
                depth += {"[": 1, "]": -1}.get(text[end], 0)
                end += 1
            text = text[:start] + change(text[start + len(name) + 1:end - 1]) + text[end:]
        return text


class Stubs:
    def __init__(self, module):
        self._module = module
        members = {name: value for name, value in vars(module).items() if not name.startswith("_")}
        self._members = members
        self._types = Types([name for name, value in members.items() if self._is_enum(value)])

    @staticmethod
    def _is_enum(value):
        return isinstance(value, type) and issubclass(value, enum.Enum)

    def text(self):
        lines = [HEADER]
        for name, value in self._members.items():
            if isinstance(value, types.ModuleType):
                continue
            if isinstance(value, type):
                lines += self._class(name, value, "")
            elif callable(value):
                lines += self._function(name, value, "")
            else:
                lines.append(f"{name}: {type(value).__name__}")
        return "\n".join(lines) + "\n"

    def _class(self, name, value, indent):
        if self._is_enum(value):
            return [f"{indent}class {name}(enum.StrEnum):"] + [
                f'{indent}    {member.name} = "{member.value}"' for member in value] + [""]
        bases = [base.__name__ for base in value.__bases__ if base.__name__ not in ("object", "pybind11_object")]
        lines = [f"{indent}class {name}" + (f"({', '.join(bases)})" if bases else "") + ":"]
        inner = indent + "    "
        if issubclass(value, Exception) and name == "Error":
            lines += [inner + line for line in
                      ("problem: str", "kind: ErrorKind", "source: str", "place: str",
                       "where: tuple[tuple[str, str], ...]", "about: tuple[str, ...]")]
        body = []
        for key, member in vars(value).items():
            body += self._member(value, key, member, inner)
        if len(lines) + len(body) == 1:
            body = [inner + "..."]
        return lines + body + [""]

    SKIPPED = {"__module__", "__doc__", "__dict__", "__weakref__", "__new__", "__reduce__", "__copy__", "__deepcopy__",
               "__match_args__", "__hash__", "__repr__", "__getstate__", "__setstate__", "__eq__", "__annotations__"}

    def _member(self, owner, name, member, indent):
        if name in self.SKIPPED or (name.startswith("_") and not name.startswith("__") and name != "_repr_svg_"
                                    and name != "_repr_html_"):
            return []
        if isinstance(member, type):
            return self._class(name, member, indent)
        if isinstance(member, property):
            return self._property(owner, name, member, indent)
        if name == "__init__":
            return self._init(owner, member, indent)
        if isinstance(member, staticmethod):
            return [indent + "@staticmethod"] + self._function(name, member.__func__, indent)
        return self._function(name, member, indent) if callable(member) else []

    def _property(self, owner, name, member, indent):
        got = self._return_type(member.fget)
        if member.fset is not None:
            return [f"{indent}{name}: _Field[{got}, {self._set_type(member.fset)}]"]
        return [f"{indent}@property", f"{indent}def {name}(self) -> {got}: ..."]

    def _return_type(self, function):
        if isinstance(function, types.FunctionType):
            return self._annotation(function.__annotations__.get("return", "Any"))
        doc = function.__doc__ or ""
        return self._types.returned(doc.splitlines()[0].rpartition("-> ")[2].strip()) if "->" in doc else "Any"

    def _set_type(self, setter):
        signature = re.match(r"\((.*)\) -> ", setter.__doc__.splitlines()[0])
        return self._types.taken(split(signature[1])[1].partition(": ")[2])

    def _init(self, owner, member, indent):
        fields = owner.__dict__.get("_setters")
        if fields is None:
            return self._function("__init__", member, indent)
        if member.__name__ == "refuse":
            return []
        parameters = [f"{name}: {self._set_type(setter)} = ..." for name, setter in fields.items()]
        return [f"{indent}def __init__(self, {', '.join(parameters)}) -> None: ..."]

    def _function(self, name, function, indent):
        if isinstance(function, types.FunctionType):
            return [f"{indent}def {name}{self._python_signature(function)}: ..."]
        doc = function.__doc__ or ""
        overloads = re.findall(rf"^\d+\. {re.escape(name)}(\(.*\)) -> (.*)\n((?:(?!^\d+\. ).*\n?)*)", doc, re.M)
        if not overloads:
            first = re.match(rf"{re.escape(name)}(\(.*\)) -> (.*)\n?((?:.*\n?)*)", doc)
            if not first:
                return []
            overloads = [first.groups()]
        lines = []
        for parameters, result, text in overloads:
            if len(overloads) > 1:
                lines.append(indent + "@overload")
            lines.append(f"{indent}def {name}({self._parameters(parameters, text)}) -> "
                         f"{self._types.returned(result.strip())}: ...")
        return lines

    def _parameters(self, text, doc):
        shown, has_star = [], False
        for part in split(text[1:-1]):
            if part == "**kwargs":
                keywords = self._keywords(doc)
                if keywords and not has_star:
                    shown.append("*")
                shown += keywords
            elif part in ("*", "/", "*args"):
                has_star = has_star or part != "/"
                shown.append(part if part != "*args" else "*args: Any")
            else:
                shown.append(self._parameter(part))
        return ", ".join(shown)

    def _parameter(self, part):
        name, _, rest = part.partition(": ")
        if name == "self":
            return "self"
        kind, equals, _ = rest.partition(" = ")
        if name == "progress":
            return KEYWORDS["progress"][0]
        taken = self._types.taken(kind)
        if equals and rest.endswith("= None") and "None" not in taken:
            taken += " | None"
        return f"{name}: {taken}" + (" = ..." if equals else "")

    def _keywords(self, doc):
        line = re.search(r"^Options: (.*)$", doc, re.M)
        shown = []
        for name in split(line[1]) if line else []:
            if name in KEYWORDS:
                shown += KEYWORDS[name]
            else:
                setters = self._members[name]._setters
                shown += [f"{field}: {self._set_type(setter)} = ..." for field, setter in setters.items()]
        return shown

    def _python_signature(self, function):
        signature = inspect.signature(function)
        shown, has_star = [], False
        for parameter in signature.parameters.values():
            if parameter.kind is parameter.KEYWORD_ONLY and not has_star:
                shown.append("*")
                has_star = True
            prefix = {parameter.VAR_POSITIONAL: "*", parameter.VAR_KEYWORD: "**"}.get(parameter.kind, "")
            has_star = has_star or prefix == "*"
            text = prefix + parameter.name
            if parameter.name != "self":
                text += ": " + self._annotation(parameter.annotation)
            if parameter.default is not parameter.empty:
                text += " = ..."
            shown.append(text)
        return f"({', '.join(shown)}) -> {self._annotation(signature.return_annotation)}"

    @staticmethod
    def _annotation(annotation):
        if annotation is inspect.Signature.empty:
            return "Any"
        return annotation if isinstance(annotation, str) else getattr(annotation, "__name__", str(annotation))


def main():
    package = pathlib.Path(sys.argv[1])
    sys.path[0] = str(package.parent)  # not the folder of this script, which has the package's sources
    import fretwork

    (package / "__init__.pyi").write_text(Stubs(fretwork).text())


if __name__ == "__main__":
    main()
