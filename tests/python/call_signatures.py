# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be called in the module, with the types of its parameters: read from the stubs, which are made from the module."""

import ast
import dataclasses
import enum
import importlib.util

import fretwork as fw
import support


@dataclasses.dataclass
class Call:
    name: str  # with its class, "Session.paint"
    kind: str  # "function", "constructor", "method", or "field" (which is set)
    parameters: list  # ast.arg of those by place, without self
    keywords: list  # ast.arg of those by name
    needed: int  # how many of the first have no default

    def function(self):
        part = fw
        for name in self.name.split("."):
            part = getattr(part, name)
        return part


def stub_text():
    """As stubs.py writes it: also for builds whose stubs are not written."""
    place = importlib.util.spec_from_file_location("stubs", support.SOURCE / "apps/python/stubs.py")
    stubs = importlib.util.module_from_spec(place)
    place.loader.exec_module(stubs)
    return stubs.Stubs(fw).text()


def declared(nodes, owner=""):
    """What a stub declares, as (name, node): the members of a class follow it, "Session.paint"."""
    for node in nodes:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            yield owner + node.name, node
        elif isinstance(node, ast.AnnAssign):
            yield owner + node.target.id, node
        elif isinstance(node, ast.Assign):
            yield owner + node.targets[0].id, node
        if isinstance(node, ast.ClassDef):
            yield from declared(node.body, f"{owner}{node.name}.")


def calls():
    """All calls in the order of the stubs; a function with overloads is several."""
    made = (_call(name, node) for name, node in declared(ast.parse(stub_text()).body))
    return [call for call in made if call is not None]


def _call(name, node):
    """None for what cannot be called or set: properties, values of enums, what the stub alone has."""
    owner, _, member = name.rpartition(".")
    if owner and not _is_made_by_calls(owner):
        return None
    if isinstance(node, ast.AnnAssign):
        is_field = owner and isinstance(node.annotation, ast.Subscript)
        return Call(name, "field", [ast.arg("value", node.annotation.slice.elts[1])], [], 1) if is_field else None
    if not isinstance(node, ast.FunctionDef) or any(ast.unparse(mark) == "property" for mark in node.decorator_list):
        return None
    if member == "__init__":
        return _of_function(owner, "constructor", node)
    return _of_function(name, "method" if owner else "function", node)


def _is_made_by_calls(name):
    kind = fw
    for part in name.split("."):
        kind = getattr(kind, part, None)
    return kind is not None and not issubclass(kind, (enum.Enum, Exception))


def _of_function(name, kind, node):
    given = node.args.args
    needed = len(given) - len(node.args.defaults)
    has_self = kind != "function" and bool(given) and given[0].arg == "self"
    return Call(name, kind, given[has_self:], node.args.kwonlyargs, needed - has_self)
