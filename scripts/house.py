"""The modules of the plugin and what they import, read from their text without running them."""

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Union

ROOT = Path(__file__).resolve().parent.parent

PLUGIN = ("algorithms", "processing_provider")
"""Packages that are installed with the plugin."""

CHAPTERS = ("clouds", "targets", "registration", "site_plan", "facade", "evaluation")
"""Packages of `algorithms` that are about one task each."""

SHARED = ("geometry", "tables", "reporting")
"""Packages of `algorithms` that every chapter may import."""

FunctionNode = Union[ast.FunctionDef, ast.AsyncFunctionDef]


@dataclass(frozen=True)
class Function:
    """A function or method, and its number of lines."""

    name: str
    lines: int


@dataclass(frozen=True)
class Import:
    """An import of one module by another.

    Attributes
    ----------
    module : str
        What is imported; dotted from the root of the checkout if it is part of it.
    line : int
    for_types : bool
        Whether only type checkers see it.
    """

    module: str
    line: int
    for_types: bool


@dataclass(frozen=True)
class Module:
    """A Python file.

    Attributes
    ----------
    path : Path
        From the root of the checkout.
    """

    path: Path

    @property
    def name(self) -> str:
        """The dotted name from the root; that of a package is the name of its folder."""
        parts = self.path.with_suffix("").parts
        return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)

    @property
    def is_package(self) -> bool:
        """Whether this is the `__init__` of a folder."""
        return self.path.name == "__init__.py"

    @property
    def package(self) -> str:
        """The package that relative imports start from."""
        return self.name if self.is_package else self.name.rpartition(".")[0]

    @cached_property
    def text(self) -> str:
        """The source."""
        return (ROOT / self.path).read_text(encoding="utf-8")

    @cached_property
    def tree(self) -> ast.Module:
        """The parsed source."""
        return ast.parse(self.text, str(self.path))

    @property
    def lines(self) -> int:
        """The number of lines."""
        return len(self.text.splitlines())

    @property
    def computes(self) -> bool:
        """Whether it defines a function or a method, other than properties and special methods."""
        return any(not _is_plain(function) for function in self._functions())

    def defined(self) -> set[str]:
        """Return the names of the functions, classes and constants at the top of the module."""
        names = {node.name for node in self.tree.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
        assigned = [node for node in self.tree.body if isinstance(node, (ast.Assign, ast.AnnAssign))]
        targets = [child for node in assigned for child in ast.walk(node) if isinstance(child, ast.Name)]
        return names | {name.id for name in targets if isinstance(name.ctx, ast.Store)}

    def functions(self) -> Iterator[Function]:
        """Yield the functions and methods."""
        for node in self._functions():
            yield Function(node.name, (node.end_lineno or node.lineno) - node.lineno + 1)

    def imports(self) -> Iterator[Import]:
        """Yield the imports, also those within functions."""
        for_types = {
            id(child) for node in ast.walk(self.tree) if _is_for_types(node) for child in ast.walk(node)
        }
        for node in ast.walk(self.tree):
            if isinstance(node, (ast.Import, ast.ImportFrom)):
                for name in self._imported(node):
                    yield Import(name, node.lineno, id(node) in for_types)

    def _functions(self) -> Iterator[FunctionNode]:
        for node in ast.walk(self.tree):
            if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
                yield node

    def _imported(self, node: Union[ast.Import, ast.ImportFrom]) -> list[str]:
        if isinstance(node, ast.Import):
            return [_from_root(alias.name) for alias in node.names]
        base = node.module or ""
        if node.level:
            parts = self.package.split(".")
            base = ".".join([*parts[: len(parts) - node.level + 1], *([node.module] if node.module else [])])
        base = _from_root(base)
        # `from .package import module` imports the module, `from .module import name` the module too.
        return sorted(
            {f"{base}.{alias.name}" if _is_module(f"{base}.{alias.name}") else base for alias in node.names}
        )


def modules(*folders: str) -> list[Module]:
    """Return the modules in folders of the checkout, by default in the packages of the plugin."""
    paths = (path for folder in folders or PLUGIN for path in sorted((ROOT / folder).rglob("*.py")))
    return [Module(path.relative_to(ROOT)) for path in paths]


def room_of(name: str) -> str:
    """Return the package below `algorithms` that a module is in, 'root' for the modules beside them."""
    parts = name.split(".")
    return parts[1] if len(parts) > 1 and (ROOT / parts[0] / parts[1]).is_dir() else "root"


def _from_root(name: str) -> str:
    return name[len("ichnograph.") :] if name.startswith("ichnograph.") else name


def _is_module(name: str) -> bool:
    path = ROOT.joinpath(*name.split("."))
    return path.with_suffix(".py").exists() or (path / "__init__.py").exists()


def _is_for_types(node: ast.AST) -> bool:
    return isinstance(node, ast.If) and isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING"


def _is_plain(function: FunctionNode) -> bool:
    decorators = {node.id for node in function.decorator_list if isinstance(node, ast.Name)}
    return bool(decorators & {"property", "cached_property"}) or function.name.startswith("__")
