"""report/index.html from stored results: one file, everything labelled, everything with its source."""

import html.parser
import pathlib
import re
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

from bench.paper import media, plots, report, svg
from bench.paper.docs import generate
from bench.paper.store import RESULTS, Machine, machines
from bench.paper.table import Table, built, left, right

UNIT = re.compile(r"\[[^\]]+\]$|^(nodes|triangles|contacts|listed pairs)\b")  # a unit in brackets, or what is counted


class Page(html.parser.HTMLParser):
    """What the tests ask of the page."""

    def __init__(self, text):
        super().__init__()
        self.elements, self.ids, self.headings = [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        self.elements.append((tag, attrs))
        if "id" in attrs:
            self.ids.append(attrs["id"])
        if re.fullmatch("h[1-6]", tag):
            self.headings.append(int(tag[1]))

    def of(self, *tags):
        return [attrs for tag, attrs in self.elements if tag in tags]


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            cls.html = report.write(RESULTS, pathlib.Path(folder)).read_text(encoding="utf-8")
        cls.page = Page(cls.html)

    def test_nothing_is_loaded_from_outside_and_nothing_runs(self):
        self.assertEqual(self.page.of("script", "iframe", "object", "embed", "base"), [])
        for _, attrs in self.page.elements:
            for name in ("src", "href", "poster", "srcset", "data", "action"):
                if attrs.get(name) is not None:
                    self.assertRegex(attrs[name], r"^(#|data:)")
            self.assertFalse([name for name in attrs if name.startswith("on")])
        style = re.search(r"<style>(.*?)</style>", self.html, re.S)[1]
        self.assertNotIn("url(", style)
        self.assertNotIn("@import", style)

    def test_ids_are_unique_and_what_names_them_exists(self):
        self.assertEqual(len(self.page.ids), len(set(self.page.ids)))
        for _, attrs in self.page.elements:
            named = attrs.get("aria-labelledby", "").split() + (
                [attrs["href"][1:]] if attrs.get("href", "").startswith("#") else []
            )
            for one in named:
                self.assertIn(one, self.page.ids)

    def test_headings_are_in_order(self):
        self.assertEqual(self.page.headings[0], 1)
        self.assertEqual(self.page.headings.count(1), 1)
        for before, after in zip(self.page.headings, self.page.headings[1:]):
            self.assertLessEqual(after, before + 1)

    def test_all_stored_machines_are_in_it_and_the_one_asked_for_comes_first(self):
        for machine in machines():
            self.assertIn(f"hanging-{machine.name}", self.page.ids)
        self.assertEqual([machine.name for machine in machines(first="2core")][0], "2core")

    def test_every_table_and_figure_has_a_caption_that_names_its_source(self):
        captions = re.findall(r"<caption.*?</caption>|<figcaption.*?</figcaption>", self.html, re.S)
        self.assertEqual(len(captions), len(self.page.of("table")) + len(self.page.of("figure")))
        for caption in captions:
            self.assertIn("Source: ", caption)
            self.assertRegex(caption, r"<b>(Table|Figure) \d+\.</b>")
        for attrs in self.page.of("th"):
            self.assertIn(attrs["scope"], ("col", "row"))

    def test_pictures_and_plots_have_words(self):
        self.assertGreater(len(self.page.of("img")), 10)
        for attrs in self.page.of("img"):
            self.assertRegex(attrs["alt"], r"(textured|wireframe), frame \d+")
        drawn = re.findall(r"<svg.*?</svg>", self.html, re.S)
        self.assertGreater(len(drawn), 8)
        for one in drawn:
            self.assertRegex(one, r"<title id=.*?>.+?</title><desc id=.*?>.+?</desc>")

    def test_axes_are_labelled_with_units(self):
        drawn = re.findall(r"<svg.*?</svg>", self.html, re.S) + [
            text for name, text in generate().items() if name.endswith(".svg")
        ]
        for one in drawn:
            labels = [
                node for node in ElementTree.fromstring(one).iter() if node.get("class") in ("x-label", "y-label")
            ]
            kinds = [label.get("class") for label in labels]
            self.assertIn("x-label", kinds)
            if "<rect" not in one:  # bars have names on the other side
                self.assertEqual(kinds.count("y-label"), kinds.count("x-label"))
            for label in labels:
                self.assertRegex(label.text, UNIT)

    def test_every_stored_row_is_shown_with_its_hash(self):
        for machine in machines():
            for experiment in ("hanging", "pull"):
                for row in machine.measured(experiment):
                    self.assertIn(row["state_hash"], self.html)

    def test_the_captions_say_what_differs_from_the_paper(self):
        for said in ("4070 Ti", "760", "0.9K", "50.6K", "52.0K", "requestAnimationFrame"):
            self.assertIn(said, self.html)

    def test_what_was_not_measured_is_said(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            bare = Machine("bare", folder)
            bare.data["hardware"] = {"gpu": "Loom 3000"}
            bare.save()
            text = report.write(folder, folder).read_text()
        for said in (
            "The native sheet has not been measured",
            "The pulls have not been measured",
            "not recorded",
            "No pictures",
        ):
            self.assertIn(said, text)
        self.assertNotIn("<svg", text)


class Media(unittest.TestCase):
    def test_stored_pictures_are_small_and_each_belongs_to_a_row(self):
        whole = 0
        for machine in machines():
            folder = RESULTS / "media" / machine.name
            named = {name for row in machine.rows("pictures") for name in row["files"].values()}
            self.assertEqual(named, {path.name for path in folder.glob("*")})
            for path in folder.glob("*"):
                self.assertLessEqual(
                    path.stat().st_size, media.VIDEO_BYTES if path.suffix == ".mp4" else media.PICTURE_BYTES, path
                )
                whole += path.stat().st_size
        self.assertLess(whole, 6_000_000)  # 3 MB a machine

    def test_a_picture_is_made_as_small_as_it_must_be_and_no_smaller(self):
        with tempfile.TemporaryDirectory() as folder:
            noise, small = pathlib.Path(folder) / "noise.png", pathlib.Path(folder) / "small.jpg"
            subprocess.run(
                [
                    "ffmpeg",
                    "-v",
                    "error",
                    "-f",
                    "lavfi",
                    "-i",
                    "nullsrc=s=320x180,geq=lum='random(1)*255':cb=128:cr=128",
                    "-frames:v",
                    "1",
                    str(noise),
                ],
                check=True,
            )
            sizes = []
            for most in (10_000_000, 20_000):
                media.shrink(
                    ["-i", str(noise)], ["-frames:v", "1"], small, most, [["-q:v", str(q)] for q in (3, 8, 25)]
                )
                sizes.append(small.stat().st_size)
            self.assertGreater(sizes[0], 20_000)
            self.assertLessEqual(sizes[1], 20_000)
            with self.assertRaisesRegex(RuntimeError, "does not fit in 100 bytes"):
                media.shrink(["-i", str(noise)], ["-frames:v", "1"], small, 100, [["-q:v", "25"]])

    def test_both_views_of_a_picture_show_the_same_state(self):
        for machine in machines():
            hashes = {}
            for row in machine.rows("pictures"):
                hashes.setdefault((row["name"], row["frames"]), set()).add(row["state_hash"])
            for name, found in hashes.items():
                self.assertEqual(len(found), 1, f"{machine.name}, {name}")


class Parts(unittest.TestCase):
    def test_a_column_that_no_row_has_is_left_out_and_named(self):
        table, missing = built(
            [{"a": 1}, {"a": 2, "b": 3}],
            [(key, "right", lambda row, key=key: str(row[key]) if key in row else None) for key in ("a", "b", "c")],
        )
        self.assertEqual(table.rows, [["1", "not measured"], ["2", "3"]])
        self.assertEqual(missing, ["c"])

    def test_a_short_row_spans_the_rest_and_text_is_escaped(self):
        table = Table(left("<x>") + right("y", "z"), [["1", "skipped: a < b"]])
        text = "".join(table.html("caption", "t"))
        self.assertIn('<td colspan="2" class="left">skipped: a &lt; b</td>', text)
        self.assertIn("&lt;x&gt;", text)
        self.assertEqual(list(table.markdown())[2], "| 1 | skipped: a < b | |")

    def test_points_lie_where_the_axes_say(self):
        plot = svg.Plot("t", "nodes", "a step [ms]", [svg.Line("a", [(100, 1), (10_000, 100)], 0)])
        text = svg.drawing("p", [plot])
        ticks = {
            node.text: float(node.get("x"))
            for node in ElementTree.fromstring(text).iter()
            if node.get("class") == "small" and node.get("text-anchor") == "middle"
        }
        line = re.search(r'class="line" d="M([\d.]+) ([\d.]+)L([\d.]+) ([\d.]+)"', text)
        self.assertAlmostEqual(float(line[1]), ticks["100"], delta=0.2)
        self.assertAlmostEqual(float(line[3]), ticks["10K"], delta=0.2)
        self.assertLess(float(line[4]), float(line[2]))  # more lies higher

    def test_a_plot_of_nothing_is_none(self):
        self.assertIsNone(plots.hanging_cost(Machine("nowhere"), {}))


if __name__ == "__main__":
    unittest.main()
