"""The layout of all text files: at most 120 columns, no tabs, no blanks at line ends, one newline at the end.

./dev format runs it with --fix, which mends blanks and fills paragraphs of Markdown that are too wide; with --check it
runs without. WGSL, for which no maintained formatter is published in a package registry, has its indentation, spacing
and binding tables checked too.

May be longer: a row of a Markdown table, which that format cannot break, and a line that has no blank to break at.
"""

import argparse
import pathlib
import re
import subprocess
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent
COLUMNS = 120
KINDS = {".cpp", ".hpp", ".wgsl", ".ts", ".js", ".py", ".sh", ".cmake", ".md", ".j2", ".yml", ".yaml", ".html", ".css"}
NAMES = {"CMakeLists.txt", "CMakePresets.json", "dev", "run", "package.json", "tsconfig.json", ".clang-format"}
MARKDOWN = (".md", ".md.j2")
ITEM = re.compile(r"\s*(?:[-+*]|\d+[.)])\s+")  # of a list


def tracked():
    """The paths of the tracked files, and of those that git would track; some may be deleted."""
    found = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT,
        check=True,
        capture_output=True,
        text=True,
    )
    return sorted(set(found.stdout.splitlines()))


def files():
    """The files that have lines to look at."""
    paths = (ROOT / name for name in tracked())
    return [path for path in paths if (path.suffix in KINDS or path.name in NAMES) and path.is_file()]


def mended(path, text):
    lines = [line.rstrip() for line in text.expandtabs(2).split("\n")]
    if path.suffix == ".wgsl":
        lines = [spaced(line, lines[max(i - 1, 0) : i] + lines[i + 1 : i + 2]) for i, line in enumerate(lines)]
        lines = [line for i, line in enumerate(lines) if line or (i > 0 and lines[i - 1])]
    if path.suffix == ".md":
        lines = filled(lines)
    return "\n".join(lines).rstrip("\n") + "\n"


def filled(lines, always=False):
    """Lines of Markdown, with each paragraph that has a line too wide filled again, or each one at all."""
    out, paragraph, fence = [], [], None
    for line in [*lines, ""]:
        opened = re.match(r"\s*(```|~~~)", line)
        if fence or opened or re.match(r"\s*(?:$|\||#|<|>)", line):
            out += fill(paragraph, always)
            paragraph = []
            out.append(line)
            if opened and fence in (None, opened.group(1)):
                fence = None if fence else opened.group(1)
        elif ITEM.match(line):
            out += fill(paragraph, always)
            paragraph = [line]
        else:
            paragraph.append(line)
    return out[:-1]


def fill(paragraph, always):
    if not paragraph or not always and all(len(line) <= COLUMNS for line in paragraph):
        return paragraph
    item = ITEM.match(paragraph[0])
    lead = item.group() if item else re.match(r"\s*", paragraph[0]).group()
    words = " ".join([paragraph[0][len(lead) :], *(line.strip() for line in paragraph[1:])])
    # A word that would make a list, a heading, a quotation or a table of its line stays on the line before.
    words = re.sub(r" (?=(?:[-+*]|\d+[.)])(?: |$)|[#>|=])", "\0", words)
    broken = textwrap.wrap(
        words,
        COLUMNS,
        initial_indent=lead,
        subsequent_indent=" " * len(lead),
        break_long_words=False,
        break_on_hyphens=False,
        expand_tabs=False,
        replace_whitespace=False,
    )
    return [line.replace("\0", " ") for line in broken]


def spaced(line, neighbours):
    """A line of WGSL with the spaces that style asks for; two before a comment that stands in no column of comments."""
    code, slashes, comment = line.partition("//")
    if not code.strip() or line.lstrip().startswith("#"):
        return line
    code = re.sub(r"\b(if|for|while|switch)\(", r"\1 (", code)
    code = code.replace("){", ") {")
    code = re.sub(r",(?=\S)", ", ", code)
    code = re.sub(r";(?=[^\s)])", "; ", code)
    in_column = code.endswith(" ") and any(other.find("//") == len(code) for other in neighbours)
    in_column = in_column or code.startswith("@group")
    if slashes and not code.endswith("  ") and not in_column:
        code = code.rstrip() + "  "
    return code + slashes + comment


def too_long(path, line):
    if len(line) <= COLUMNS:
        return False
    if path.name.endswith(MARKDOWN) and line.lstrip().startswith("|"):
        return False
    lead = re.match(r"\s*(?:(?://[/!]?|#|\*|-|\d+\.)\s+)?", line).end()
    return " " in line[lead:].rstrip()


def wgsl_faults(lines):
    """Number and fault of each line whose indentation is not that of its block, or that leaves a binding table."""
    blocks = []  # the brackets that are open
    goes_on = False  # the statement of the line before
    table = []
    above = ""
    for number, line in enumerate(lines, 1):
        code = line.partition("//")[0].rstrip()
        table = [*table, line] if re.match(r"@group\(\d\) @binding\(\d\) ", line) else []
        if table and (line.find(" var"), line.find(" : ")) != (table[0].find(" var"), table[0].find(" : ")):
            yield number, "its `var` or its colon is in another column than in the first row of this binding table"
        lead = len(line) - len(line.lstrip())
        closed = len(re.match(r"[\s})\]]*", code).group().replace(" ", ""))
        expected = 2 * (len(blocks) - closed)
        free = goes_on or any(bracket != "{" for bracket in blocks)
        if line.startswith("#") or not line or (not code and lead == above.find("//")):
            pass
        elif lead < expected if free else lead != expected:
            yield number, f"{lead} blanks before it, not {expected}"
        above = line
        if not code or code.startswith("#"):
            continue
        for bracket in re.findall(r"[][(){}]", code):
            if bracket in "([{":
                blocks.append(bracket)
            elif blocks:
                blocks.pop()
        goes_on = not code.endswith((";", "{", "}", ",", ":")) and not code.lstrip().startswith("@")


def faults(path, text):
    lines = text.split("\n")
    for number, line in enumerate(lines, 1):
        if too_long(path, line):
            yield number, f"{len(line)} columns"
    wanted = mended(path, text).split("\n")
    if wanted != lines:
        at = next((i for i, line in enumerate(lines) if i >= len(wanted) or line != wanted[i]), len(lines))
        yield at + 1, "not as ./dev format writes it"
    if path.suffix == ".wgsl":
        yield from wgsl_faults(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fix", action="store_true", help="mend what can be, then check")
    parser.add_argument("files", nargs="*", type=pathlib.Path, help="default: all files of the tree")
    given = parser.parse_args()
    count = 0
    for path in given.files or files():
        text = path.read_text(encoding="utf-8")
        if given.fix and (good := mended(path, text)) != text:
            path.write_text(good, encoding="utf-8")
            text = good
        for number, fault in faults(path, text):
            print(f"{path.resolve().relative_to(ROOT)}:{number}: {fault}")
            count += 1
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
