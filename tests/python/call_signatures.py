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


def calls():
    """All calls in the order of the stubs; a function with overloads is several."""
    return list(_of_module(ast.parse(stub_text()).body))


def _of_module(body):
    for node in body:
        if isinstance(node, ast.FunctionDef):
            yield _call(node.name, "function", node)
        elif isinstance(node, ast.ClassDef) and hasattr(fw, node.name):
            yield from _of_class(node.name, node)


def _of_class(name, owner):
    kind = fw
    for part in name.split("."):
        kind = getattr(kind, part)
    if issubclass(kind, (enum.Enum, Exception)):
        return
    for node in owner.body:
        if isinstance(node, ast.ClassDef):
            yield from _of_class(f"{name}.{node.name}", node)
        elif isinstance(node, ast.AnnAssign) and isinstance(node.annotation, ast.Subscript):
            yield Call(f"{name}.{node.target.id}", "field", [ast.arg("value", node.annotation.slice.elts[1])], [], 1)
        elif isinstance(node, ast.FunctionDef) and node.name == "__init__":
            yield _call(name, "constructor", node)
        elif isinstance(node, ast.FunctionDef) and not any(ast.unparse(mark) == "property" for mark in node.decorator_list):
            yield _call(f"{name}.{node.name}", "method", node)


def _call(name, kind, node):
    given = node.args.args
    needed = len(given) - len(node.args.defaults)
    has_self = kind != "function" and bool(given) and given[0].arg == "self"
    return Call(name, kind, given[has_self:], node.args.kwonlyargs, needed - has_self)
