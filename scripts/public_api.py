"""The lists of what weft's packages declare for programs, tests/public/, and how they differ from the sources.

usage: python3 -m scripts.public_api [LIBRARY]   writes the lists; LIBRARY is build/libweft.so by default
"""

import pathlib
import re
import subprocess
import sys
from collections.abc import Iterator

from scripts.cpp_declarations import declarations
from scripts.site.declared import cpp_headers, python_names, typescript_names

ROOT = pathlib.Path(__file__).resolve().parent.parent
LISTS = ROOT / "tests/public"
COMMENT = re.compile(r"(?<!\S)//[^\n]*|/\*.*?\*/", re.DOTALL)


def cpp() -> Iterator[str]:
    for name, text in cpp_headers(ROOT / "include/weft"):
        yield from (f"{name} {line}" for line in declarations(text))


def symbols(library: str) -> list[str]:
    """What a shared library exports, demangled."""
    said = subprocess.run(["nm", "-DC", "--defined-only", library], check=True, capture_output=True, text=True).stdout
    return sorted({re.sub(r"^[0-9a-f]+ \w ", "", line) for line in said.splitlines()})


def python() -> Iterator[str]:
    for name, signature, _, members in python_names(ROOT / "python/weft"):
        yield " ".join(COMMENT.sub("", re.sub(r"  #[^\n]*", "", signature)).split())
        yield from (f"{name}.{form}" for _, form, _ in members)


def npm() -> Iterator[str]:
    for name, text in typescript_names(ROOT / "packages/weft/src"):
        head, brace, body = " ".join(COMMENT.sub(" ", text).split()).removeprefix("export ").partition(" { ")
        if not brace or not re.match(r"(class|interface) ", head):
            yield f"{head}{brace}{body}".rstrip(" ;")
            continue
        yield head
        yield from (f"{name}: {part.removeprefix('async ')}" for part in _parts(body.removesuffix("}")))


def _parts(body: str) -> Iterator[str]:
    """The members of a class or an interface, which end in semicolons outside of brackets."""
    depth, said = 0, ""
    for letter in body:
        depth += (letter in "([{") - (letter in ")]}")
        if letter == ";" and depth == 0:
            yield said.strip()
            said = ""
        else:
            said += letter


def difference(before: list[str], now: list[str]) -> str:
    """What has been taken away and added, a line each; nothing where the lists are equal."""
    changed = [f"  taken away: {line}" for line in before if line not in now]
    changed += [f"  added: {line}" for line in now if line not in before]
    return "\n".join(changed) if changed or before == now else "  the same in another order"


def lists(library: str) -> dict[str, list[str]]:
    return {"cpp": list(cpp()), "symbols": symbols(library), "python": list(python()), "npm": list(npm())}


def stored(name: str) -> list[str]:
    return (LISTS / f"{name}.txt").read_text("utf-8").splitlines()


def release(changelog: str) -> tuple[str, bool]:
    """The version on top of the changes, and whether it is out."""
    version, when = re.search(r"^## (\d+\.\d+\.\d+) \((.*)\)$", changelog, re.MULTILINE).groups()
    return version, when != "unreleased"


def main() -> None:
    version, out = release((ROOT / "CHANGELOG.md").read_text("utf-8"))
    for name, lines in lists(sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "build/libweft.so")).items():
        path = LISTS / f"{name}.txt"
        changed = difference(stored(name) if path.exists() else [], lines)
        if changed and out:
            raise SystemExit(f"{version} is released, and what it declares stays:\n{changed}\nRaise the version first.")
        if changed:
            path.write_text("".join(f"{line}\n" for line in lines), "utf-8")
            print(f"{path.relative_to(ROOT)}:\n{changed}")


if __name__ == "__main__":
    main()
