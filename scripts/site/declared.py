"""What the Python package, the C++ library and the npm package declare for programs, read from their sources."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

Member = tuple[str, str, str]  # name, signature, docstring


def python_names(package: Path) -> Iterator[tuple[str, str, str, list[Member]]]:
    """Each name of `__all__`: the name, its signature, its docstring and its public members."""
    tree = ast.parse((package / "__init__.py").read_text("utf-8"))
    homes = {
        alias.name: package / f"{node.module.replace('.', '/')}.py"
        for node in tree.body
        if isinstance(node, ast.ImportFrom) and node.level
        for alias in node.names
    }
    for name, home in sorted(homes.items()):
        text = home.read_text("utf-8")
        node = next(node for node in ast.parse(text).body if getattr(node, "name", None) == name)
        if isinstance(node, ast.ClassDef):
            yield name, class_signature(node, text), ast.get_docstring(node) or "", list(members(node))
        else:
            yield name, signature(node), ast.get_docstring(node) or "", []


def signature(node: ast.FunctionDef) -> str:
    """Its line without a body; a property's with its type alone."""
    made = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    if any(ast.unparse(decorator) == "property" for decorator in node.decorator_list):
        return f"{node.name}{made}"
    node.args.args = [one for one in node.args.args if one.arg != "self"]
    return f"{node.name}({ast.unparse(node.args)}){made}"


def class_signature(node: ast.ClassDef, text: str) -> str:
    """That of its constructor, or its bases and its fields with their comments."""
    for part in node.body:
        if isinstance(part, ast.FunctionDef) and part.name == "__init__":
            return signature(part).replace("__init__", node.name).removesuffix(" -> None")
    bases = ", ".join(ast.unparse(base) for base in node.bases)
    lines = text.splitlines()
    fields = [f"\n{lines[part.lineno - 1]}" for part in node.body if isinstance(part, ast.AnnAssign)]
    return f"class {node.name}{f'({bases})' if bases else ''}" + ("".join([":", *fields]) if fields else "")


def members(node: ast.ClassDef) -> Iterator[Member]:
    """Of setters only the property itself."""
    for part in node.body:
        if not isinstance(part, ast.FunctionDef) or part.name.startswith("_"):
            continue
        if not any(ast.unparse(decorator).endswith(".setter") for decorator in part.decorator_list):
            yield part.name, signature(part), ast.get_docstring(part) or ""


def cpp_headers(folder: Path) -> Iterator[tuple[str, str]]:
    """The name and the text of each, that which includes the others first."""
    for path in sorted(folder.glob("*.hpp"), key=lambda path: (path.name != "weft.hpp", path.name)):
        yield path.name, path.read_text("utf-8")


def typescript_names(folder: Path) -> Iterator[tuple[str, str]]:
    """Each name that index.ts exports, and its declaration with comments."""
    index = (folder / "index.ts").read_text("utf-8")
    for names, file in re.findall(r'export (?:type )?{(.*?)} from "\./(.*?)\.js"', index, re.DOTALL):
        text = (folder / f"{file}.ts").read_text("utf-8")
        for name in names.replace("type ", "").split(","):
            yield name.strip(), declaration(text, name.strip())


def declaration(text: str, name: str) -> str:
    """A type or an interface as it stands, a function or a constant without its body, a class with what is public."""
    start = re.search(
        rf"((?:^/\*\*(?:(?!\*/).)*\*/\n|^//[^\n]*\n)?)^export (?:async )?(\w+) {name}\b", text, re.MULTILINE | re.DOTALL
    )
    if not start:
        raise LookupError(f"{name} is exported by index.ts and declared nowhere.")
    rest = text[start.start(2) :]
    if start.group(2) == "interface":
        return start.group(1) + re.match(r".*?^}", rest, re.MULTILINE | re.DOTALL).group()
    if start.group(2) == "type":
        return start.group(1) + re.match(r".*?;(?= *(?:\n|//))", rest, re.DOTALL).group()
    if start.group(2) == "class":
        return start.group(1) + public(rest[: re.search(r"^}", rest, re.MULTILINE).end()])
    end = r".*?;\n" if start.group(2) == "const" else r".*?(?= {\n)"
    return start.group(1) + re.match(end, rest, re.DOTALL).group()


def public(body: str) -> str:
    """A class's members that programs use, each with its comment and without its body."""
    head, _, rest = body.partition("\n")
    made = [head]
    parts = re.finditer(
        r"((?:^  /\*\*(?:(?!\*/).)*\*/\n)?)^  (?!private|constructor|[ /*}])(?:([^\n(]*?)(?= = |;)|(\w.*?)(?= {\n))",
        rest,
        re.MULTILINE | re.DOTALL,
    )
    for part in parts:
        if "@internal" not in part.group(1):
            made.append(f"{part.group(1)}  {part.group(2) or part.group(3)};")
    return "\n".join([*made, "}"])
