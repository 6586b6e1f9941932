# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes stubs beside the modules of the package in a folder: write_stubs.py FOLDER.

Stubs have the signatures and docstrings of the modules. In place of **parameters they have the
named parameters, which only the extension knows.
"""

import ast
import importlib
import inspect
import pathlib
import sys


def is_private(node):
    """Whether a node of a syntax tree has a name that begins with _ and does not end with __."""
    name = getattr(node, "name", "")
    return name.startswith("_") and not name.endswith("__")


def name_parameters(node, function):
    """Replaces **parameters in the node of a function by those that its signature shows."""
    for parameter in inspect.signature(function).parameters.values():
        # Parameters of the extension have texts as annotations. The node has all others.
        if parameter.kind == parameter.KEYWORD_ONLY and isinstance(parameter.annotation, str):
            node.args.kwonlyargs.append(ast.arg(parameter.name, ast.Name(parameter.annotation)))
            node.args.kw_defaults.append(ast.Constant(...))
    node.args.kwarg = None
    node.decorator_list.clear()  # the decorator named_parameters makes that signature


def stub_of(tree, owner):
    """Removes code of functions, private functions and classes from a tree; returns the tree.

    tree: of a module or class. Assignments without annotations stay as they are.
    owner: the imported module or class itself.
    """
    tree.body = [node for node in tree.body if not is_private(node)]
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            stub_of(node, getattr(owner, node.name))
        elif isinstance(node, ast.FunctionDef):
            if node.args.kwarg:
                name_parameters(node, getattr(owner, node.name))
            docstring = node.body[:1] if ast.get_docstring(node) else []
            node.body = [*docstring, ast.Expr(ast.Constant(...))]
        elif isinstance(node, ast.AnnAssign):
            node.value = None
    return tree


folder = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(folder.parent))
for file in folder.glob("*.py"):
    module = importlib.import_module(f"pcl_ops.{file.stem}")
    stub = ast.fix_missing_locations(stub_of(ast.parse(file.read_text(encoding="utf-8")), module))
    # Annotations that the extension writes need these names.
    text = f"from typing import Literal, Optional, Tuple, Union\n{ast.unparse(stub)}\n"
    file.with_suffix(".pyi").write_text(text, encoding="utf-8")
(folder / "_pcl_ops.pyi").write_text("__version__: str\nclass Segment: ...\n")
