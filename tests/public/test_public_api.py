"""What the packages declare for programs is what the lists beside this file have; their versions are one."""

import json
import os
import re
import unittest

from scripts.cpp_declarations import declarations
from scripts.public_api import ROOT, difference, lists, release, stored

ASKED = """
What is taken away or changed breaks programs, and what is added does not: docs/versions.md says which number of the
version each raises. Say it in CHANGELOG.md in the section of the version to come, then accept it by
python3 -m scripts.public_api, which writes the list."""

CHANGELOG = (ROOT / "CHANGELOG.md").read_text("utf-8")

HEADER = """
#pragma once
namespace weft {
/// A comment; with a semicolon.
enum class Kind {
  First,  ///< its meaning
  Second,
};
template <class T>
struct Pair {
  T a{}, b{};  // two
  Pair(T one) : a(one), b{one} { if (a < b) { a = b; } }
  T sum() const { return a + b; }
  friend Pair operator+(const Pair& p, const Pair& q) { return {p.a + q.a, p.b + q.b}; }
};
class Thing final {
 public:
  static Thing make(const Pair<int>& pair = {},
                    const char* name = "a;b");
 private:
  friend class Other;
  enum class Inner { A };
  void hide();
  int hidden_ = 0;
};
[[nodiscard]] bool same(const Thing& a, const Thing& b);
}  // namespace weft
"""
DECLARED = [
    "weft: enum class Kind",
    "weft::Kind: First = 0",
    "weft::Kind: Second = 1",
    "weft: template <class T> struct Pair",
    "weft::Pair: T a{}, b{}",
    "weft::Pair: Pair(T one)",
    "weft::Pair: T sum() const",
    "weft::Pair: friend Pair operator+(const Pair& p, const Pair& q)",
    "weft: class Thing final",
    'weft::Thing: static Thing make(const Pair<int>& pair = {}, const char* name = "a;b")',
    "weft: [[nodiscard]] bool same(const Thing& a, const Thing& b)",
]


class Lists(unittest.TestCase):
    def test_every_package_declares_what_its_list_has(self) -> None:
        for name, lines in lists(os.environ["LIBRARY"]).items():
            with self.subTest(name):
                self.assertGreater(len(lines), 40)
                self.assertEqual(lines, [line for line in lines if line.isprintable()])
                changed = difference(stored(name), lines)
                self.assertFalse(changed, f"tests/public/{name}.txt is no longer what weft declares:\n{changed}{ASKED}")

    def test_the_shared_library_has_each_function_of_the_headers_and_of_the_engine_nothing(self) -> None:
        exported = {re.sub(r"\[abi:\w+\]|\(.*", "", line) for line in stored("symbols")}
        declared = set()
        for line in stored("cpp"):
            scope, said = re.fullmatch(r"\S+ (\S*): (.*)", line).groups()
            name = re.match(r"(?!static_assert|struct)(?:.*? )?([~\w]+|operator=)\(", said)
            if name and re.fullmatch(r"weft(::(Buffer|Placement|Scene|World))?", scope) and "template" not in said:
                declared.add(f"{scope}::{name[1]}")
        self.assertEqual(exported, declared)


class Readers(unittest.TestCase):
    def test_a_header_declares_what_is_not_private(self) -> None:
        self.assertEqual(list(declarations(HEADER)), DECLARED)

    def test_a_change_of_a_name_a_type_a_default_or_an_order_is_seen(self) -> None:
        for old, new in (
            ("Second,", "Second, Third,"),
            ("First,", "Zeroth, First,"),
            ("T sum() const", "T sum()"),
            ("pair = {}", "pair"),
            ("T a{}, b{};", "T a{}; T b{};"),
        ):
            self.assertTrue(difference(DECLARED, list(declarations(HEADER.replace(old, new)))), new)
        self.assertFalse(difference(DECLARED, list(declarations(HEADER.replace("int hidden_ = 0;", "long more_;")))))

    def test_a_difference_says_what_went_and_what_came(self) -> None:
        self.assertEqual(difference(["a", "b"], ["b", "c"]), "  taken away: a\n  added: c")
        self.assertEqual(difference(["a", "b"], ["b", "a"]), "  the same in another order")
        self.assertEqual(difference(["a"], ["a"]), "")


class Versions(unittest.TestCase):
    def test_every_package_has_the_version_of_the_changes_to_come(self) -> None:
        version, out = release(CHANGELOG)
        self.assertFalse(out, f"{version} is released: the next change begins another section of CHANGELOG.md.")
        project = re.search(r"^project\(weft VERSION ([\d.]+) ", (ROOT / "CMakeLists.txt").read_text("utf-8"), re.M)[1]
        npm = json.loads((ROOT / "packages/weft/package.json").read_text("utf-8"))["version"]
        locked = json.loads((ROOT / "package-lock.json").read_text("utf-8"))["packages"]["packages/weft"]["version"]
        self.assertEqual([project, npm, locked], [version] * 3)
        for page in sorted((ROOT / "examples/web").glob("*/package.json")):
            self.assertEqual(json.loads(page.read_text("utf-8"))["dependencies"]["weft-cloth"], version, page)

    def test_the_changes_of_a_release_have_its_version_and_day_the_latest_first(self) -> None:
        titles = re.findall(r"^## (.*)$", CHANGELOG, re.MULTILINE)
        found = [re.fullmatch(r"(\d+)\.(\d+)\.(\d+) \((unreleased|\d{4}-\d\d-\d\d)\)", title) for title in titles]
        self.assertNotIn(None, found)
        versions = [tuple(map(int, one.groups()[:3])) for one in found]
        self.assertEqual(versions, sorted(set(versions), reverse=True))
        self.assertNotIn("unreleased", [one[4] for one in found[1:]])
        self.assertEqual(release("# C\n\n## 0.2.0 (2026-01-02)\n## 0.1.0 (2025-01-02)\n"), ("0.2.0", True))


if __name__ == "__main__":
    unittest.main()
