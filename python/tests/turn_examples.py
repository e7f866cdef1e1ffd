"""The notebooks, and what the guide and the how-tos have in Python, run from their first line to the last."""

import ast
import json
import os
import pathlib
import re
import tempfile
import unittest
from typing import Any

import scenes
import weft


def run(text: str, names: dict[str, Any]) -> Any:
    """What a notebook's cell shows: the value of its last expression."""
    tree = ast.parse(text)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "the cell", "exec"), names)
    return eval(compile(ast.Expression(last.value), "the cell", "eval"), names) if isinstance(last, ast.Expr) else None


def blocks(page: str, language: str) -> list[str]:
    """Of a page of the documentation, in their order."""
    text = (scenes.CHECKOUT / "docs" / page).read_text(encoding="utf-8")
    return re.findall(rf"^```{language}\n(.*?)^```", text, re.MULTILINE | re.DOTALL)


class Examples(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)

    def test_notebooks_run(self) -> None:
        notebooks = sorted((scenes.CHECKOUT / "examples/python").glob("*.ipynb"))
        self.assertGreaterEqual(len(notebooks), 3)
        for path in notebooks:
            with self.subTest(path.name):
                names: dict[str, Any] = {"__name__": "__main__"}
                for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
                    if cell["cell_type"] != "code":
                        continue
                    self.assertEqual(cell["outputs"], [])
                    shown = run("".join(cell["source"]), names)
                    if hasattr(shown, "_repr_png_"):
                        self.assertEqual(shown._repr_png_()[:8], b"\x89PNG\r\n\x1a\n")

    def test_the_guide_and_the_how_to_run(self) -> None:
        for page, least in (("python.md", 5), ("how-to/python.md", 3)):
            with self.subTest(page):
                names: dict[str, Any] = {}
                found = blocks(page, "python")
                self.assertGreaterEqual(len(found), least)
                for block in found:
                    run(block, names)
        self.assertTrue(pathlib.Path("shape.ply").exists())

    def test_the_sweep_of_the_how_to_has_a_row_for_each_run(self) -> None:
        (block,) = blocks("how-to/sweep.md", "json")
        pathlib.Path("stiffness.json").write_text(block, encoding="utf-8")
        weft.sweep("stiffness.json", "out", workers=1)
        rows = [json.loads(line) for line in pathlib.Path("out/runs.jsonl").read_text(encoding="utf-8").splitlines()]
        self.assertEqual([row["end"] for row in rows], 4 * ["complete"])


if __name__ == "__main__":
    unittest.main()
