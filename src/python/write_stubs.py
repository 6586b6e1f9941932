# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes stubs beside the package's modules: write_stubs.py FOLDER MODULE.py...

They are the modules' own signatures and docstrings, with the named parameters that only
the extension, in that folder, knows.
"""

import ast
import pathlib
import sys


def is_private(node):
    name = getattr(node, "name", "")
    return name.startswith("_") and not name.endswith("__")


def name_parameters(function, parameters):
    """In place of **parameters, those of the lists that the decorator names."""
    for decorator in list(function.decorator_list):
        if isinstance(decorator, ast.Call) and decorator.func.id == "named_parameters":
            known = {name: annotation for one in decorator.args
                     for name, _, annotation in parameters(one.value, "default")}
            for name, annotation in known.items():
                kind = ast.parse(annotation, mode="eval").body
                function.args.kwonlyargs.append(ast.arg(name, kind))
                function.args.kw_defaults.append(ast.Constant(...))
            function.args.kwarg = None
            function.decorator_list.remove(decorator)


def stub_of(source, parameters):
    tree = ast.parse(source)
    for node in ast.walk(tree):
        if isinstance(node, (ast.Module, ast.ClassDef)):
            node.body = [one for one in node.body if not is_private(one)]
        elif isinstance(node, ast.FunctionDef):
            name_parameters(node, parameters)
            docstring = node.body[:1] if ast.get_docstring(node) else []
            node.body = [*docstring, ast.Expr(ast.Constant(...))]
    # What annotations of the extension need.
    return f"from typing import Literal, Optional\n{ast.unparse(ast.fix_missing_locations(tree))}\n"


def main():
    folder = pathlib.Path(sys.argv[1])
    sys.path.insert(0, str(folder))
    import _pcl_ops

    for module in map(pathlib.Path, sys.argv[2:]):
        stub = stub_of(module.read_text(encoding="utf-8"), _pcl_ops.parameters)
        (folder / module.with_suffix(".pyi").name).write_text(stub, encoding="utf-8")
    (folder / "_pcl_ops.pyi").write_text("__version__: str\n")


main()
