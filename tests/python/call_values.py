# SPDX-License-Identifier: GPL-3.0-or-later
"""Values for random calls: by the types of the stubs, mostly of the right type and seldom sensible."""

import ast
import enum
import fractions
import os
import pathlib
import shutil

import numpy as np

import fretwork as fw
import support

MOST_KEPT = 8
ENDINGS = {"svg": ".svg", "dxf": ".dxf", "obj": ".obj", "ply": ".ply", "off": ".off", "deck": ".inp", "image": ".png", "library": ".db"}
IDS = ["0-6", "0-1+1-6", "0-5+5-6", "0-1+1-5+1-6+5-6", "paper7:0-1+1-6", "0-1+0-1", "6-0", "+", "1-99"]
WORDS = ["", "x", "\0", "\ud800", "a" * 5000, "random:1", "field:x", "all", "left", "paper7", "fifths12", "corotational", "condensed", "full",
         "paper6", "mixed:0.1", "26mm", "15deg", "-1", "nan", "1e999", "0.1*x", "max_displacement", "edges > 2", "{}", "[1]"]


def copy_files(folder):
    """A file of every kind that the program reads: the examples of the fuzzer."""
    names = []
    for kind in sorted((support.SOURCE / "tests/fuzz/corpora").iterdir()):
        if kind.name.startswith("studio") or kind.name in ("expression", "query"):
            continue
        for example in sorted(kind.iterdir())[:2]:
            names.append(f"{kind.name}_{example.stem}{ENDINGS.get(kind.name, '.json')}")
            shutil.copy(example, folder / names[-1])
    return names


def first_objects():
    """From these, calls make further ones."""
    layout, surface, case = fw.paper_layout(), support.surface(), support.tip()
    session = fw.Session(surface, case, model="condensed")
    setting = fw.paper_setting()
    setting.magnitudes = 1
    bowl = fw.Problem("bowl", [-1, -1], [2, 2], value=lambda x: float(x @ x))
    return [layout, fw.find_node_layout("fifths12"), fw.parse_pattern_id(layout, support.PATTERN), surface, surface.tessellation, case,
            support.project(), session, session.solve(subject=True), setting, bowl, support.cantilever(), fw.Material(1e9, 0.3, 1000),
            fw.rectangle_section(0.002, 0.002), fw.make_fan(layout, fw.Pattern([0, 5])), fw.Filter("f", lambda pattern: True)]

# Memory for a list of this length is a MemoryError. The address sanitizer would end the program instead.
LONG = range(1000 if "libasan" in os.environ.get("LD_PRELOAD", "") else 10**12)


class Values:
    """What has a type, and what has not. Results of calls are kept, and are arguments of later ones."""

    def __init__(self, random, folder):
        self._random = random
        self._kept = {}
        self._paths = copy_files(folder)
        self._texts = [(folder / name).read_text() for name in self._paths if name.endswith((".json", ".svg", ".inp"))]
        self._enums = [part for part in vars(fw).values() if isinstance(part, type) and issubclass(part, enum.Enum)]
        for value in first_objects():
            self.keep(value)

    def keep(self, value):
        """Objects of the module, alone or in a sequence."""
        if isinstance(value, (list, tuple)):
            for part in value[:3]:
                self.keep(part)
        elif type(value).__module__.startswith("fretwork") and not isinstance(value, (enum.Enum, Exception)):
            kept = self._kept.setdefault(type(value).__qualname__, [])
            kept.append(value)
            if len(kept) > MOST_KEPT:
                del kept[self._random.randrange(len(kept))]

    def any_object(self):
        return self._random.choice(self._random.choice(list(self._kept.values())))

    def drop(self, value):
        """Forget an object: nothing but what was made from it may keep it alive."""
        kept = self._kept[type(value).__qualname__]
        kept[:] = [other for other in kept if other is not value]
        if not kept:
            del self._kept[type(value).__qualname__]

    def wrong(self):
        """A value of any type."""
        return self._random.choice((self._number, self._text, self._array, self.any_object, self._odd))()

    def of(self, node):
        """A value of the type that a node of the stub's syntax tree says."""
        if node is None or (isinstance(node, ast.Constant) and node.value is None):
            return None
        if isinstance(node, ast.BinOp):
            return self.of(self._random.choice((node.left, node.left, node.right)))
        if isinstance(node, ast.Subscript):
            return self._generic(ast.unparse(node.value).rpartition(".")[2], node.slice)
        return self._named(ast.unparse(node))

    def _named(self, name):
        makers = {"int": self._integer, "float": self._number, "bool": lambda: self._random.random() < 0.5, "str": self._text,
                  "_Array": self._array, "npt.ArrayLike": self._array, "_Floats": self._array, "_Progress": self._function, "fractions.Fraction": self._fraction,
                  "Any": self.wrong, "object": self.wrong, "_Design": lambda: {self._text(): self._array() for _ in range(self._below(3))},
                  "os.PathLike": self._path, "pathlib.Path": self._path}
        if name in makers:
            return makers[name]()
        for kind in self._enums:
            if kind.__name__ == name:
                member = self._random.choice(list(kind))
                return self._random.choice((member, str(member), self._text()))
        return self._random.choice(self._kept[name]) if name in self._kept else self.wrong()

    def _generic(self, name, inner):
        if name == "PathLike":
            return self._path()
        if name == "Callable":
            return self._function()
        if name == "Literal":
            return self._random.choice([ast.literal_eval(part) for part in getattr(inner, "elts", [inner])])
        if name in ("dict", "Mapping"):
            key, value = inner.elts
            return {self.of(key): self.of(value) for _ in range(self._below(4))}
        if name == "tuple" and isinstance(inner, ast.Tuple) and ast.unparse(inner.elts[-1]) != "...":
            return tuple(self.of(part) for part in inner.elts)
        element = inner.elts[0] if isinstance(inner, ast.Tuple) else inner
        values = [self.of(element) for _ in range(self._random.choice((0, 1, 1, 2, 3, 7, 33)))]
        return values * 3000 if self._below(50) == 0 else values

    def _below(self, count):
        return self._random.randrange(count)

    def _integer(self):
        return self._random.choice((0, 0, 1, 1, 2, 3, 4, 6, 7, 33, 100, -1, -2**31, 2**31 - 1, 2**31, 2**32, 2**63, 2**64, 10**30, True))

    def _number(self):
        return self._random.choice((0.0, 1.0, 0.5, -1.0, 0.002, 0.02, 30, 2**40, 1e-300, 1e300, -1e300, 5e-324, float("nan"), float("inf"), -float("inf"), self._integer()))

    def _text(self):
        return self._random.choice((self._random.choice(IDS), self._random.choice(WORDS), self._random.choice(self._paths), self._random.choice(self._texts),
                                    str(self._random.choice(list(self._random.choice(self._enums))))))

    def _path(self):
        names = ("none.json", "no/folder.json", ".", "", "/dev/full", "\0", "a" * 300, "new.db", "new.svg", "new.dxf", "new.html", "new.json")
        name = self._random.choice((self._random.choice(self._paths), self._random.choice(names)))
        return self._random.choice((name, pathlib.Path(name))) if "\0" not in name else name

    def _fraction(self):
        return self._random.choice((0, 1, "1/3", "x", "1/0", fractions.Fraction(1, 2), fractions.Fraction(-10**30, 7), "99999999999999999999/7"))

    def _array(self):
        shape = self._random.choice(((0,), (2,), (3,), (6,), (0, 2), (3, 2), (4, 2), (33, 2), (2, 3), (33, 6), (3, 3), (2, 2, 2), (1, 10**5)))
        array = np.full(shape, 0.25) if self._below(3) == 0 else np.random.default_rng(self._below(2**32)).normal(size=shape)
        change = self._below(10)
        if change == 0 and array.size:
            array.flat[self._below(array.size)] = self._random.choice((np.nan, np.inf, 1e308))
        changed = {1: lambda: array.astype(np.float32), 2: lambda: array.astype(int), 3: lambda: array[::-1], 4: lambda: array.T, 5: lambda: array.tolist(),
                   6: lambda: array.astype(object), 7: lambda: array.astype(str)}
        return changed.get(change, lambda: array)()

    def _function(self):
        value = self._random.choice((None, True, 0.5, "x", np.zeros(2), np.zeros((12, 12)), np.nan, 10**400))

        def answering(*_arguments, **_named):
            return value

        def raising(*_arguments, **_named):
            raise KeyError("raised by a function that was passed")

        def calling_back(*_arguments, **_named):
            return fw.pattern_id(fw.paper_layout(), fw.Pattern([0]))

        return self._random.choice((None, answering, raising, calling_back))

    def _odd(self):
        return self._random.choice((None, object(), b"bytes", [], {}, [[1, 2], [3, 4]], (None, None), int, len, LONG, fw, np.array(["a"]), iter([1]), 1j))
