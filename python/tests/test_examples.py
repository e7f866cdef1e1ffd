"""The notebooks, and the Python of the guide, run from their first line to the last."""

import ast
import json
import os
import pathlib
import re
import tempfile
import unittest
from typing import Any

import scenes


def run(text: str, names: dict[str, Any]) -> Any:
    """What a notebook's cell shows: the value of its last expression."""
    tree = ast.parse(text)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "the cell", "exec"), names)
    return eval(compile(ast.Expression(last.value), "the cell", "eval"), names) if isinstance(last, ast.Expr) else None


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

    def test_the_guide_runs(self) -> None:
        guide = (scenes.CHECKOUT / "docs/python.md").read_text(encoding="utf-8")
        blocks = re.findall(r"^```python\n(.*?)^```", guide, re.MULTILINE | re.DOTALL)
        self.assertGreaterEqual(len(blocks), 5)
        names: dict[str, Any] = {}
        for block in blocks:
            run(block, names)
        self.assertTrue(pathlib.Path("shape.ply").exists())


if __name__ == "__main__":
    unittest.main()
