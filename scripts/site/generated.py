"""The pages of the site that are made from the code: nothing of them is stored beside it."""

import json
import subprocess
from collections.abc import Iterator
from pathlib import Path

from declared import cpp_headers, python_names, typescript_names

COMMANDS = (
    "run",
    "view",
    "check",
    "scenes",
    "fabrics",
    "validate",
    "adapters",
    "schema",
    "bench",
    "export",
    "completion",
)


def said(weft: str, *words: str) -> str:
    """What the program prints."""
    return subprocess.run([weft, *words], check=True, capture_output=True, text=True).stdout.strip("\n")


def titled(title: str, what: str, guide: str) -> str:
    """The beginning of a page: its title, what is on it, and the page that explains it."""
    return f"# {title}\n{what}. Guide: [{guide}](../{guide})."


def fenced(language: str, text: str) -> str:
    return f"```{language}\n{text.rstrip()}\n```"


def help_page(weft: str) -> str:
    parts = [titled("What `weft --help` says", "All options, as the program prints them", "cli.md")]
    parts += ["## weft", fenced("text", said(weft, "--help"))]
    for command in COMMANDS:
        parts += [f"## weft {command}", fenced("text", said(weft, command, "--help"))]
    return "\n\n".join(parts)


def schema_page() -> str:
    return """# The JSON Schema of scenes
`weft schema` prints it, and this site has it as a file: [weft-scene.schema.json](weft-scene.schema.json). It is made
from the table by which weft checks scenes, so an editor that knows it completes keys and marks what weft would refuse;
[scene.md](../scene.md) says what the keys mean.

In VS Code, in `.vscode/settings.json`:
```json
{ "json.schemas": [{ "fileMatch": ["*.scene.json"], "url": "./weft-scene.schema.json" }] }
```
"""


def python_page(root: Path) -> str:
    parts = [titled("Python: names and docstrings", "All that `import weft` has, from its docstrings", "python.md")]
    for name, signature, text, members in python_names(root / "python/weft"):
        parts += [f"## {name}", fenced("python", signature), fenced("text", text) if text else ""]
        for member, form, words in members:
            parts += [f"### {name}.{member}", fenced("python", form), fenced("text", words) if words else ""]
    return "\n\n".join(part for part in parts if part)


def cpp_page(root: Path) -> str:
    parts = [titled("C++: the public headers", "As they are installed", "cpp.md")]
    for name, text in cpp_headers(root / "include/weft"):
        parts += [f"## weft/{name}", fenced("cpp", text)]
    return "\n\n".join(parts)


def typescript_page(root: Path) -> str:
    parts = [titled("TypeScript: the package's declarations", "All that `weft-cloth` exports", "web.md")]
    for name, text in typescript_names(root / "packages/weft/src"):
        parts += [f"## {name}", fenced("ts", text)]
    return "\n\n".join(parts)


def cpp_examples(root: Path) -> str:
    parts = [titled("C++ examples", "`examples/cpp`, with the project that builds them", "cpp.md")]
    for path in sorted((root / "examples/cpp").iterdir()):
        language = "cpp" if path.suffix == ".cpp" else "cmake"
        parts += [f"## {path.name}", fenced(language, path.read_text("utf-8"))]
    return "\n\n".join(parts)


def web_examples(root: Path) -> str:
    parts = [titled("Web examples", "`examples/web`", "web.md")]
    languages = {".html": "html", ".js": "js", ".ts": "ts", ".css": "css", ".json": "json"}
    for path in sorted(one for one in (root / "examples/web").rglob("*") if one.suffix in languages):
        if {"node_modules", "dist"} & set(path.parts):
            continue
        name = path.relative_to(root / "examples/web").as_posix()
        parts += [f"## {name}", fenced(languages[path.suffix], path.read_text("utf-8"))]
    return "\n\n".join(parts)


def python_examples(root: Path) -> str:
    parts = [titled("Python examples", "The notebooks of `examples/python`", "python.md")]
    for path in sorted((root / "examples/python").glob("*.ipynb")):
        parts.append(f"## {path.name}")
        for cell in json.loads(path.read_text("utf-8"))["cells"]:
            text = "".join(cell["source"])
            parts.append(fenced("python", text) if cell["cell_type"] == "code" else text.replace("# ", "### ", 1))
    return "\n\n".join(parts)


def files(root: Path, weft: str) -> Iterator[tuple[str, str]]:
    """Each file's path in the site's sources, and its text."""
    yield "reference/cli-help.md", help_page(weft)
    yield "reference/schema.md", schema_page()
    yield "reference/weft-scene.schema.json", said(weft, "schema") + "\n"
    yield "reference/python-names.md", python_page(root)
    yield "reference/cpp-headers.md", cpp_page(root)
    yield "reference/typescript.md", typescript_page(root)
    yield "reference/examples-cpp.md", cpp_examples(root)
    yield "reference/examples-python.md", python_examples(root)
    yield "reference/examples-web.md", web_examples(root)
    yield "reference/npm.md", (root / "packages/weft/README.md").read_text("utf-8")
    yield "reference/changelog.md", (root / "CHANGELOG.md").read_text("utf-8")
    yield "reference/third-party.md", (root / "THIRD_PARTY.md").read_text("utf-8")
