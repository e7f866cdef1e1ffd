"""What a C++ header declares for programs: a line for each name that is not private, in its order."""

import re
from collections.abc import Iterator

SCOPE = re.compile(r"(?:template\s*<[^{]*>\s*)?(?P<kind>namespace|class|struct|enum class)\b(?P<rest>[^()]*)$")
# Up to its body: what stands after its parameters, and a constructor's list without a brace of its last member.
FUNCTION = re.compile(r"\)((?:[\s&]|\bconst\b|\bnoexcept\b|\boverride\b)*)(?:\s:\s.*[)}]\s*)?$", re.DOTALL)
TOKEN = re.compile(r'"(?:\\.|[^"\\])*"|::|.', re.DOTALL)


def declarations(text: str) -> Iterator[str]:
    """Scope and declaration without comments and bodies: "weft::World: void finish()", "weft::View: Normals = 2"."""
    text = re.sub(r"//[^\n]*|/\*.*?\*/", " ", text, flags=re.DOTALL)
    text = re.sub(r"^\s*#[^\n]*", " ", text, flags=re.MULTILINE)
    yield from _body(iter(TOKEN.findall(text)), [], "namespace")


def _body(tokens: Iterator[str], scope: list[str], kind: str) -> Iterator[str]:
    """Up to the brace that ends it."""
    shown, said, depth, number = kind != "class", "", 0, 0
    for token in tokens:
        if depth == 0 and token == "}":
            break
        if depth == 0 and token == "{" and (inner := SCOPE.match(said.strip())):
            name, of = inner["rest"].strip(), inner["kind"]
            if shown and of != "namespace":
                yield _line(scope, said)
            inside = list(_body(tokens, [*scope, re.sub(r"\[\[.*?\]\]|\bfinal\b|:.*", "", name).strip()], of))
            yield from inside if shown else ()
            said = ""
        elif depth == 0 and token == "{" and FUNCTION.search(said):
            if shown:
                yield _line(scope, FUNCTION.sub(r")\1", said))
            _skip(tokens)
            said = ""
        elif token == "{":
            said += "{" + _skip(tokens)
        elif depth == 0 and token in (";", ",") and (token == ";" or kind == "enum class"):
            if shown and said.strip() and not said.strip().startswith("friend class"):
                yield _line(scope, said, number if kind == "enum class" else None)
            said, number = "", number + 1
        elif token == ":" and said.strip() in ("public", "private", "protected"):
            shown, said = said.strip() == "public", ""
        else:
            depth += (token == "(") - (token == ")")
            said += token
    if kind == "enum class" and said.strip():
        yield _line(scope, said, number)


def _skip(tokens: Iterator[str]) -> str:
    """What stands up to the brace that closes one, with that."""
    depth, said = 1, ""
    while depth > 0:
        token = next(tokens)
        depth += (token == "{") - (token == "}")
        said += token
    return said


def _line(scope: list[str], said: str, number: int | None = None) -> str:
    words = " ".join(said.split())
    return f"{'::'.join(scope)}: {words}" + ("" if number is None else f" = {number}")
