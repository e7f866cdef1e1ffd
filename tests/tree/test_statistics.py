"""The files that scripts/make_statistics.py makes are those of the table; a new row reaches every one of them."""

import unittest

from scripts.make_statistics import ROOT, TABLE, made

ROWS = (ROOT / TABLE).read_text("utf-8")
DOCS = (ROOT / "docs/cli.md").read_text("utf-8")


def with_row(row, before):
    return ROWS.replace(f"\n{before} ", f"\n{row}\n{before} ")


class Statistics(unittest.TestCase):
    def test_every_file_is_as_the_table_makes_it(self):
        for name, text in made(ROWS, DOCS).items():
            self.assertEqual((ROOT / name).read_text("utf-8"), text, f"run scripts/make_statistics.py for {name}")

    def test_a_new_row_reaches_every_file(self):
        files = made(with_row("gliding_nodes | u32 | frame | sum | nodes that glide", "crossings"), DOCS)
        for name, line in (
            ("src/state/statistics.wgsl", "const kStatGlidingNodes = 5u;"),
            ("src/state/statistics.wgsl", "const kStatCrossings = 6u;"),
            ("src/state/statistics.hpp", "  std::uint32_t gliding_nodes = 0;"),
            ("src/state/statistics.hpp", "  totals.gliding_nodes += frame.gliding_nodes;"),
            ("src/state/statistics.hpp", '  visit("gliding_nodes", statistics.gliding_nodes);'),
            ("include/weft/totals.hpp", "  std::uint64_t gliding_nodes = 0;"),
            ("include/weft/totals.hpp", '  visit("gliding_nodes", totals.gliding_nodes);'),
            ("packages/weft/src/totals.ts", "  glidingNodes: number;"),
            ("packages/weft/src/totals.ts", '  "glidingNodes",'),
            ("packages/weft/src/totals.ts", "    glidingNodes: 0,"),
            ("docs/cli.md", "| `gliding_nodes` | Nodes that glide |"),
        ):
            self.assertIn(line, files[name].split("\n"), name)

    def test_what_is_cleared_with_each_frame_comes_before_what_is_kept(self):
        for row, before in (
            ("late | u32 | frame | sum | after what is kept", "frozen"),
            ("odd | f64 | reset | last | of no such type", "frozen"),
            ("odd | u32 | reset | mean | of no such sum", "frozen"),
            ("odd | u32 | frame | host | counted by both", "contacts"),
            ("odd | u32 | - | sum | counted by none", "contacts"),
        ):
            with self.assertRaises(ValueError, msg=row):
                made(with_row(row, before), DOCS)


if __name__ == "__main__":
    unittest.main()
