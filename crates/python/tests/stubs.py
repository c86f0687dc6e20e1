"""The stub of the compiled part has each of its functions and methods, with their parameters, and nothing else."""

import ast
import inspect
from pathlib import Path

import scenelang
from scenelang import _native

tree = ast.parse((Path(scenelang.__file__).parent / "_native.pyi").read_text(encoding="utf-8"))


def stubs(body):
    return {node.name: node for node in body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}


def public(thing):
    return {name for name in vars(thing) if not name.startswith("_")}


def parameters(node):
    """Names of parameters as the stub has them: those that may be given by position, and those that need their names."""
    return [a.arg for a in node.args.args if a.arg != "self"], [a.arg for a in node.args.kwonlyargs]


def taken(function):
    """The same as the compiled part has them."""
    all_of_them = [p for p in inspect.signature(function).parameters.values() if p.name != "self"]
    named = [p.name for p in all_of_them if p.kind is p.KEYWORD_ONLY]
    return [p.name for p in all_of_them if p.kind is not p.KEYWORD_ONLY], named


def compare(where, thing, body):
    written, there = stubs(body), public(thing)
    assert {name for name in written if not name.startswith("_")} == there, (where, set(written) ^ there)
    for name, node in written.items():
        value = vars(thing).get(name)
        if isinstance(node, ast.ClassDef):
            compare(name, value, node.body)
        elif name == "__new__":
            assert parameters(node)[0][1:] == taken(thing)[0], (where, name, taken(thing))
        elif any(ast.unparse(decorator) == "property" for decorator in node.decorator_list):
            assert not callable(value), (where, name)
        else:
            assert parameters(node) == taken(value), (where, name, taken(value))


compare("_native", _native, tree.body)
