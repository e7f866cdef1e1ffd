"""Every message that docs/answers.md quotes is in the sources, each … being a value."""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = [path for room in ("src", "apps/cli") for path in sorted((ROOT / room).rglob("*.cpp"))]
SOURCES += sorted((ROOT / "packages/weft/src").glob("*.ts"))
LITERAL = r'"((?:[^"\\\n]|\\.)*)"|`([^`]*)`'
CONVERSION = r"%%|%[-+ #0]*[\d.*]*(?:hh|h|ll|l|z|t)?[a-zA-Z]"
VALUE = "…"


def words_of(source: str) -> str:
    """The string literals of a file, adjacent ones joined; a conversion of printf, or an end, is a value."""
    made, end = [], 0
    for literal in re.finditer(LITERAL, source):
        if source[end : literal.start()].strip():
            made.append(VALUE)
        text = literal.group(1) if literal.group(1) is not None else re.sub(r"\$\{.*?\}", VALUE, literal.group(2))
        text = re.sub(CONVERSION, lambda one: "%" if one[0] == "%%" else VALUE, text)
        made.append(text.replace('\\"', '"').replace("\\n", ""))
        end = literal.end()
    return "".join(made)


def quoted(page: str) -> list[str]:
    """The quotations of a page, each as one line."""
    found = re.findall(r"(?:^>.*\n)+", page, re.MULTILINE)
    return [" ".join(line.lstrip("> ") for line in one.splitlines()) for one in found]


def said_by(texts: list[str], sentence: str) -> bool:
    """Whether one file has all parts of the sentence between values, in its order; a value may be quoted or missing."""
    parts = [part.strip(' ".') for part in sentence.split(VALUE)]
    parts = [part for part in parts if len(part) > 1]
    assert max(map(len, parts)) > 8, f"{sentence} says too little"
    pattern = re.compile(".{0,400}?".join(map(re.escape, parts)), re.DOTALL)
    return any(pattern.search(text) for text in texts)


class Messages(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.texts = [words_of(path.read_text("utf-8")) for path in SOURCES]
        cls.quoted = quoted((ROOT / "docs/answers.md").read_text("utf-8"))

    def test_every_message_that_is_quoted_is_one_of_the_program(self):
        self.assertGreater(len(self.quoted), 30)
        self.assertEqual([one for one in self.quoted if not said_by(self.texts, one)], [])

    def test_a_message_that_nobody_says_is_found(self):
        for sentence in self.quoted:
            words = sentence.split()
            longest = max(range(len(words)), key=lambda i: len(words[i].strip('"…:;,.')))
            words[longest] = words[longest].replace(words[longest].strip('"…:;,.'), "otherwise")
            self.assertFalse(said_by(self.texts, " ".join(words)), " ".join(words))


if __name__ == "__main__":
    unittest.main()
