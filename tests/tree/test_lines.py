"""scripts/lines.py finds what is too wide or out of line, and what it mends means the same as before."""

import pathlib
import unittest

from scripts import lines

WIDE = "word " * 30
KERNEL = """\
@group(0) @binding(0) var<uniform>       step  : StepBlock;
@group(0) @binding(1) var<storage, read> place : array<vec4f>; // node_count
fn f(a : u32) -> u32 {
  let b = g(a,
            a);
  if (a > b) { return b; }
  return a;
}
"""


def faults(name, text):
    return [fault for _, fault in lines.faults(pathlib.Path(name), text)]


class Lines(unittest.TestCase):
    def test_a_wide_line_is_found_in_every_kind_of_file(self):
        for name in (
            "a.cpp",
            "a.wgsl",
            "a.ts",
            "a.py",
            "a.sh",
            "CMakeLists.txt",
            "a.html",
            "a.css",
            "a.yml",
            "a.md.j2",
        ):
            self.assertIn("149 columns", faults(name, f"{WIDE.rstrip()}\n"), name)

    def test_a_row_of_a_table_and_a_word_that_cannot_be_broken_may_be_wide(self):
        self.assertEqual(faults("a.md", f"| {WIDE}|\n"), [])
        self.assertEqual(faults("a.cpp", f"// {'x' * 130}\n"), [])
        self.assertEqual(faults("a.cpp", f"// | {WIDE}|\n"), ["156 columns"])

    def test_a_kernel_as_style_has_it_is_left_alone(self):
        self.assertEqual(faults("a.wgsl", KERNEL), [])

    def test_a_kernel_out_of_line_is_found(self):
        for right, wrong in (
            ("place :", "place  :"),
            ("  return a;", "   return a;"),
            ("  return a;", "return a;"),
            ("if (", "if("),
            ("}\n", "} \n"),
            ("a,\n", "a,\t\n"),
        ):
            self.assertNotEqual(faults("a.wgsl", KERNEL.replace(right, wrong)), [], wrong)

    def test_paragraphs_are_filled_and_all_else_stays(self):
        rows = [f"# {WIDE}".rstrip(), f"| {WIDE}|", "```", WIDE.rstrip(), "```"]
        page = "\n".join([rows[0], f"{WIDE}- {WIDE}", *rows[1:], f"- {WIDE}", "  end", ""])
        made = lines.mended(pathlib.Path("a.md"), page)
        self.assertEqual(made.split(), page.split())
        self.assertEqual([line for line in made.split("\n") if line in rows], rows)
        rest = [line for line in made.split("\n") if line and line not in rows]
        self.assertLessEqual(max(map(len, rest)), lines.COLUMNS)
        self.assertEqual([line for line in rest if line.startswith("- ")], rest[-2:-1])  # the item and no other
        self.assertEqual(lines.mended(pathlib.Path("a.md"), made), made)
        self.assertEqual(lines.filled(["- a", "  b", "", "c", "d"], always=True), ["- a b", "", "c d"])


if __name__ == "__main__":
    unittest.main()
