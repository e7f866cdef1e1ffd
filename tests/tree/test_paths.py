"""Every path in a comment or in a page of docs exists in the tree; a file holds the names said to be in it."""

import json
import pathlib
import re
import unittest

from scripts import lines

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMENT = {
    **dict.fromkeys((".cpp", ".hpp", ".wgsl", ".ts", ".js", ".css"), re.compile(r"//.*|/\*.*|^\s*\*.*")),
    **dict.fromkeys((".py", ".sh", ".cmake", ".txt", ""), re.compile(r"#.*")),
    **dict.fromkeys((".md", ".j2"), re.compile(r".*")),
    ".html": re.compile(r"<!--.*"),
}
SOURCES = "cpp|hpp|wgsl|ts|py|cmake"
OTHERS = "js|md|json|txt|sh|css|html|j2|svg|png|jpg|mp4"
# A file, whose folder may be left out where it is a source; or a folder, which ends in a slash.
PATH = (
    rf"(?:[\w.-]+/)+[\w.-]+\.(?:{SOURCES}|{OTHERS})\b(?![\w/*(])|[\w.-]+\.(?:{SOURCES})\b(?![\w/*(.])"
    r"|(?:[\w.-]+/)+(?=[\s`,.;:)]|$)"
)
WORD = re.compile(rf"(?<![\w./*<$@:%-])(?:{PATH})")
# A name, then "in", "of" or a parenthesis, then the path of the file that holds it.
NAMED = re.compile(rf"(\w*(?:_\w|[a-z][A-Z])\w*)`?(?: in | of | \()`?({PATH})")
LINK = re.compile(r"\]\(([^):#\s]*)(?:#([^)\s]*))?\)")
PLACEHOLDER = re.compile(r"(?:^|[/_-])(?:[A-Z]{3,}|[a-z])(?:[/.]|$)")  # scenes/NAME.json, scenes/a.json


class Tree:
    def __init__(self):
        self.files = [name for name in lines.tracked() if (ROOT / name).is_file()]
        self.made = [line.strip("/") + "/" for line in (ROOT / ".gitignore").read_text().split()]
        locked = json.loads((ROOT / "package-lock.json").read_text())["packages"]
        self.packages = [name[13:] + "/" for name in locked if name.startswith("node_modules/")]
        self.ends = {}  # a path may leave out its first folders
        for name in self.files:
            parts = name.split("/")
            for i in range(len(parts)):
                self.ends.setdefault("/".join(parts[i:]), []).append(name)
                for j in range(i + 1, len(parts)):
                    self.ends.setdefault("/".join(parts[i:j]), [])

    def knows(self, word, page):
        if word.startswith(("./", "../")):
            return (ROOT / page).parent.joinpath(word).exists()
        return (
            word.rstrip("/") in self.ends
            or word.startswith((*self.made, *self.packages))
            or PLACEHOLDER.search(word) is not None
            or re.match(r"[\w-]+\.[a-z]{2,}/", word) is not None  # a site
        )

    def holds(self, path, name):
        places = self.ends.get(path, [])
        return not places or any(name in (ROOT / place).read_text(encoding="utf-8") for place in places)

    def faults(self, page, text):
        suffix = pathlib.PurePosixPath(page).suffix
        for number, line in enumerate(text.split("\n"), 1):
            said = COMMENT[suffix].search(line)
            if not said:
                continue
            for word in WORD.findall(said.group()):
                if not self.knows(word, page):
                    yield f"{page}:{number}: there is no {word}"
            for name, path in NAMED.findall(said.group()):
                if not self.holds(path, name):
                    yield f"{page}:{number}: there is no {name} in {path}"
            for target, heading in LINK.findall(line) if suffix == ".md" else ():
                file = (ROOT / page).parent / target if target else ROOT / page
                if not file.exists():
                    yield f"{page}:{number}: there is no {target}"
                elif heading and heading not in headings(file.read_text(encoding="utf-8")):
                    yield f"{page}:{number}: there is no heading {heading} in {target or page}"


def headings(text):
    """The anchors of a page's headings, as GitHub makes them."""
    titles = re.findall(r"^#+ (.*)", text, re.MULTILINE)
    return {re.sub(r"[^\w -]", "", title.lower()).strip().replace(" ", "-") for title in titles}


class Paths(unittest.TestCase):
    def test_every_path_exists(self):
        tree, found = Tree(), []
        for name in tree.files:
            path = pathlib.PurePosixPath(name)
            if path.suffix in COMMENT and not name.startswith(("LICENSE", "NOTICE")):
                found += tree.faults(name, (ROOT / name).read_text(encoding="utf-8"))
        self.assertEqual(found, [], "\n" + "\n".join(found))

    def test_faults_are_found(self):
        here = pathlib.Path(__file__).name
        for page, text in (
            ("src/a.hpp", "int a;  // see base/no_such_header.hpp"),
            ("src/a.hpp", "int a;  // see no_such_header.hpp"),
            ("src/a.wgsl", f"// kNoSuch{'Name'} of tests/tree/{here}"),
            ("docs/a.md", "[text](no_such_page.md)"),
            ("docs/a.md", "in `src/no_such_folder/`"),
            ("scripts/a.sh", "\x23 scripts/no_such_script.sh"),
        ):
            self.assertNotEqual(list(Tree().faults(page, text)), [], text)
        for page, text in (
            ("src/a.hpp", 'auto a = "base/no_such_header.hpp";'),
            ("docs/a.md", 'import "three/addons/no_such_file.js"'),
            ("src/a.hpp", f"int a;  // PLACEHOLDER of tests/tree/{here}, {here}, build/no_such_file.json, NAME.hpp"),
        ):
            self.assertEqual(list(Tree().faults(page, text)), [])


if __name__ == "__main__":
    unittest.main()
