"""The texts of the plugin that people read, as patterns: what is filled in is %1, %2 ...

They are extracted from the source: from Python by its syntax tree, from the templates of reports by that of
jinja2, from styles and models by their attributes. A text is a string of two words or more, or one of
`WORDS`; a string that only looks like a text is one of `NO_TEXTS`.
"""

import ast
import html
import itertools
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, Optional

import jinja2
from ichnograph.scripts.words import COMPOSED, NO_TEXTS, WORDS
from jinja2 import nodes

ROOT = Path(__file__).parents[1]

FOLDERS = ("algorithms", "processing_provider")

HOLE = "\0"
"""Stands for what is filled in until all holes are numbered."""

MOST_VARIANTS = 16
"""Of one string with several words to choose from."""

FOR_DEVELOPERS = {"AssertionError", "TypeError", "TypeVar", "ValueError", "judged", "physical", "statistical"}
"""Calls whose arguments nobody reads in QGIS."""

UNITS = {"cm", "km", "m", "mm", "m²", "ppm", "px", "x", "y", "z", "MB", "EPSG", "MDB", "sigma"}
"""Words that are the same in all languages."""

SHOWN_IN_DIALOGS = re.compile(r"[A-Z][a-z]+…?")
"""A single word in the provider."""

MARKUP = re.compile(r'[<>\\{]|^[.#$/]|^[\w-]+:[\w-]|\w\.(html|svg|css)$|="')

ATTRIBUTES = {
    ".qml": re.compile(r' label="([^"]*)"'),
    ".model3": re.compile(
        r'name="(?:[A-Z][A-Z_\d]*|component_description|description|model_group|model_name)" value="([^"]*)"'
    ),
}
"""Of files of QGIS, those that it shows."""


def texts() -> dict[str, list[str]]:
    """Return the patterns, and the files that hold each."""
    found = {text: [place] for text, place in COMPOSED.items()}
    for path in sorted(path for folder in FOLDERS for path in (ROOT / folder).rglob("*")):
        for text in dict.fromkeys(map(_numbered, _of_file(path))):
            if is_shown(text, path):
                found.setdefault(text, []).append(path.relative_to(ROOT).as_posix())
    return found


def is_shown(text: str, path: Path) -> bool:
    """Whether people read a string."""
    if text in WORDS:
        return True
    literal = re.sub(r"%\d+", " ", text)
    words = re.findall(r"[^\W\d_]+", literal)
    if not set(words) - UNITS or text in NO_TEXTS or MARKUP.search(text):
        return False
    if path.suffix == ".html":
        return any(len(word) > 2 for word in words)
    if re.fullmatch(r"\S+", text):
        return "processing_provider" in path.parts and bool(SHOWN_IN_DIALOGS.fullmatch(text))
    return any(len(word) > 1 for word in words)


def _of_file(path: Path) -> Iterator[str]:
    if path.suffix == ".py":
        yield from _Reader().read(ast.parse(path.read_text(encoding="utf-8")))
    elif path.suffix == ".html":
        yield from _of_template(jinja2.Environment().parse(path.read_text(encoding="utf-8")))
    elif path.suffix in ATTRIBUTES:
        for text in ATTRIBUTES[path.suffix].findall(path.read_text(encoding="utf-8")):
            yield re.sub(r"\$\w+", HOLE, html.unescape(text))


def _numbered(pattern: str) -> str:
    """Return a pattern with %1, %2 ... for its holes, and one blank for all white space of a template."""
    numbers = itertools.count(1)
    return re.sub(HOLE, lambda _: f"%{next(numbers)}", pattern).strip()


# Python


class _Reader(ast.NodeVisitor):
    """Gathers the patterns of a module."""

    def __init__(self) -> None:
        self._found: list[str] = []

    def read(self, tree: ast.Module) -> list[str]:
        self.visit(tree)
        return self._found

    def visit(self, node: ast.AST) -> None:
        variants = _variants(node)
        if variants is None:
            super().visit(node)
        else:
            self._found += variants
            for inner in _filled_in(node):
                self.visit(inner)

    def visit_Expr(self, node: ast.Expr) -> None:
        if not isinstance(node.value, ast.Constant):
            self.generic_visit(node)

    def visit_Call(self, node: ast.Call) -> None:
        if not (isinstance(node.func, ast.Name) and node.func.id in FOR_DEVELOPERS):
            self.generic_visit(node)

    def visit_Assign(self, node: ast.Assign) -> None:
        # The words by which the toolbox is searched are of all languages.
        if not (isinstance(node.targets[0], ast.Name) and node.targets[0].id == "words"):
            self.visit(node.value)

    def visit_AnnAssign(self, node: ast.AnnAssign) -> None:
        if node.value:
            self.visit(node.value)

    def visit_FunctionDef(self, node: ast.FunctionDef) -> None:
        for part in (*node.args.defaults, *node.args.kw_defaults, *node.body):
            if part:
                self.visit(part)

    def visit_Subscript(self, node: ast.Subscript) -> None:
        self.visit(node.value)


def _variants(node: Optional[ast.AST]) -> Optional[list[str]]:
    """Return the patterns of an expression that is certainly a string; None of any other."""
    if isinstance(node, ast.Constant):
        # What `format` fills in later.
        return [re.sub(r"\{\w*\}", HOLE, node.value)] if isinstance(node.value, str) else None
    if isinstance(node, ast.JoinedStr):
        return _product([_variants(part) or [HOLE] for part in node.values])
    if isinstance(node, ast.FormattedValue):
        return _variants(node.value)
    if isinstance(node, ast.IfExp):
        body, other = _variants(node.body), _variants(node.orelse)
        return None if body is None or other is None else body + other
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        left, right = _variants(node.left), _variants(node.right)
        return None if left is None and right is None else _product([left or [HOLE], right or [HOLE]])
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "format":
        return [re.sub(r"\{[^}]*\}", HOLE, text) for text in _variants(node.func.value) or []] or None
    return None


def _filled_in(node: ast.AST) -> Iterator[ast.AST]:
    """Yield the expressions that fill the holes of a string."""
    if isinstance(node, (ast.JoinedStr, ast.FormattedValue, ast.IfExp, ast.BinOp)):
        for part in ast.iter_child_nodes(node):
            if isinstance(part, ast.Constant):
                continue
            if _variants(part) is None:
                yield part
            else:
                yield from _filled_in(part)
    elif isinstance(node, ast.Call):
        yield from node.args


def _product(parts: Iterable[list[str]]) -> list[str]:
    return ["".join(chosen) for chosen in itertools.islice(itertools.product(*parts), MOST_VARIANTS)]


# Templates


def _of_template(tree: nodes.Node) -> Iterator[str]:
    """Yield the texts between tags, with and without what is shown under a condition, and the strings."""
    for run in _runs(tree):
        for variant in _product(run):
            for text in re.split(r"<style.*?</style>|<[^>]*>", variant, flags=re.DOTALL):
                yield " ".join(html.unescape(text).split())
    yield from _all_strings(tree)


def _all_strings(node: nodes.Node) -> Iterator[str]:
    """Yield the patterns of all strings in expressions."""
    found = _strings(node)
    if found != [HOLE]:
        yield from found
    else:
        for part in node.iter_child_nodes():
            yield from _all_strings(part)


def _strings(node: Optional[nodes.Node]) -> list[str]:
    """Return the patterns of a string that may be formatted, joined or chosen; or a hole."""
    if node is None:
        return [""]
    if isinstance(node, nodes.Filter) and node.name == "format":
        return _strings(node.node)
    if isinstance(node, nodes.Call) and isinstance(node.node, nodes.Getattr) and node.node.attr == "format":
        return _strings(node.node.node)
    if isinstance(node, nodes.Concat):
        return _product(_strings(part) for part in node.nodes)
    if isinstance(node, nodes.CondExpr):
        return _strings(node.expr1) + _strings(node.expr2)
    if isinstance(node, nodes.Const) and isinstance(node.value, str):
        return [re.sub(r"%[.\d]*[dfgs]|\{[^}]*\}", HOLE, node.value).replace("%%", "%")]
    return [HOLE]


def _runs(node: nodes.Node) -> Iterator[list[list[str]]]:
    """Yield what stands between two tags: parts with their variants."""
    run: list[list[str]] = []
    for part in _parts(node):
        first, *others = re.split(r"<[^>]*>", part) if isinstance(part, str) else [part]
        run.append([first] if isinstance(first, str) else first)
        for other in others:
            yield run
            run = [[other]]
    yield run


def _parts(node: nodes.Node) -> Iterator[Any]:
    """Yield the literal parts of a template, a hole for each expression, and lists of variants."""
    if isinstance(node, nodes.TemplateData):
        yield node.data
    elif isinstance(node, nodes.CondExpr):
        yield _strings(node)
    elif isinstance(node, nodes.Call):
        # A macro makes an element of its own.
        yield "<macro>"
    elif isinstance(node, nodes.Expr):
        yield [HOLE]
    elif isinstance(node, nodes.If):
        branches = [[*itertools.chain(*map(_parts, body))] for body in (node.body, node.else_)]
        if any(isinstance(part, str) and "<" in part for branch in branches for part in branch):
            for branch in branches:
                yield from ("<if>", *branch, "<if>")
        else:
            yield [
                text
                for branch in branches
                for text in _product([part] if isinstance(part, str) else part for part in branch)
            ]
    elif isinstance(node, nodes.Output):
        for part in node.nodes:
            yield from _parts(part)
    else:
        yield "<block>"
        for child in node.iter_child_nodes():
            if not isinstance(child, nodes.Expr):
                yield from _parts(child)
        yield "<block>"
