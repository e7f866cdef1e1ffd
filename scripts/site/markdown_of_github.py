"""Pages as GitHub reads them, made into what Python-Markdown reads the same way, with the site's own links."""

import posixpath
import re

# What a page may link to outside of docs/, and the page of the site that shows it (generated.py).
OUTSIDE = {
    "CHANGELOG.md": "reference/changelog.md",
    "THIRD_PARTY.md": "reference/third-party.md",
    "examples/cpp": "reference/examples-cpp.md",
    "examples/python": "reference/examples-python.md",
    "examples/web/embed.html": "reference/examples-web.md",
    "examples/web/three": "reference/examples-web.md",
    "examples/web/vite": "reference/examples-web.md",
    "examples/web/webpack": "reference/examples-web.md",
    "packages/weft/README.md": "reference/npm.md",
}
MEDIA = "bench/results/media/"  # of stored runs; on the site it is media/
FENCE = re.compile(r"\s*(?:```|~~~)")
ITEM = re.compile(r"\s*(?:[-+*]|\d+[.)])\s")
CODE = re.compile(r"`[^`]*`")
NAMED = re.compile(r"\[[\w./]+\.md\]\(([^)#\s]+\.md)(?=[)#])")
LINK = re.compile(r"(?<=\]\()\.\./[^)#\s]+")


def mended(text: str) -> str:
    """A list, a table or a fence that touches a paragraph gets the empty line between that Python-Markdown asks for."""
    made: list[str] = []
    fenced = False
    first = ""  # line of the paragraph, list or table that this line is part of
    for line in text.split("\n"):
        if FENCE.match(line):
            if not fenced and made and made[-1].strip():
                made.append("")
            fenced = not fenced
            first = line if not fenced else ""  # what follows a fence is another paragraph
        elif not fenced:
            row = line.startswith("|")
            starts = row and not made[-1].startswith("|") or bool(ITEM.match(line)) and not ITEM.match(first)
            if first and line.strip() and (starts or FENCE.match(first)):
                made.append("")
                first = ""
            first = (first or line) if line.strip() else ""
            if row:  # a bar in code is no bar of the table, and needs no backslash
                line = CODE.sub(lambda code: code.group().replace(r"\|", "|"), line)
        made.append(line)
    return "\n".join(made)


def inside(text: str, page: str) -> str:
    """With each link that leaves docs/ led to the page of the site that shows its target. A KeyError: there is none."""
    folder = posixpath.dirname(page)

    def led(link: re.Match[str]) -> str:
        path = posixpath.normpath(posixpath.join("docs", folder, link.group()))
        if path.startswith("docs/"):
            return link.group()
        there = path.replace(MEDIA, "media/", 1) if path.startswith(MEDIA) else OUTSIDE[path]
        return posixpath.relpath(there, folder or ".")

    return LINK.sub(led, text)


def titled(text: str, page: str, titles: dict[str, str]) -> str:
    """With the title of the page where a link's words are the name of its file, which the site does not show."""
    folder = posixpath.dirname(page)

    def put(link: re.Match[str]) -> str:
        title = titles.get(posixpath.normpath(posixpath.join(folder, link.group(1))))
        return f"[{title}]({link.group(1)}" if title else link.group()

    return NAMED.sub(put, text)
