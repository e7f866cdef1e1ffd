"""What the tutorial and the how-tos say to type works: their blocks of sh and json, in order, in an empty folder.

Each page has a checkout of its own, with this one's scenes, models and scripts. Its `weft` is the built one, but for
fewer frames and small pictures; `./dev` does nothing there, since all is built.
"""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = [ROOT / "docs/tutorial.md", *sorted((ROOT / "docs/how-to").glob("*.md"))]
ELSEWHERE = {"python.md", "cpp.md"}  # of an installed package: python/tests, tests/install
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
SAVE = re.compile(r"[Ss]ave this as `([\w.-]+)`")
FEWER = 60  # of so many frames one is simulated

WEFT = """#!/usr/bin/python3 -B
import os, re, sys
def fewer(number):
    return max(1, int(number) // {fewer})
words = [re.sub(r"(?<=checkpoint_)\\d+", lambda n: f"{{fewer(n[0]):05}}", word) for word in sys.argv[1:]]
if words[:1] == ["run"]:
    for i, word in enumerate(words):
        if word in ("--frames", "--checkpoint-every"):
            words[i + 1] = str(fewer(words[i + 1]))
        elif word == "--size":
            words[i + 1] = "64x48"
    if "--frames" not in words:
        words += ["--frames", "1"]
    if "--size" not in words:
        words += ["--set", "render.size=[64,48]"]
os.execv({weft!r}, ["weft", *words])
"""


def checkout(folder: pathlib.Path) -> None:
    for name in ("scenes", "models", "scripts"):
        (folder / name).symlink_to(ROOT / name)
    (folder / "build").mkdir()
    for path, text in (("build/weft", WEFT.format(fewer=FEWER, weft=os.environ["WEFT"])), ("dev", "#!/bin/sh\n")):
        (folder / path).write_text(text)
        (folder / path).chmod(0o755)


def script_of(page: str) -> str:
    """All blocks of sh, and before each what is to be saved, as one script of a shell."""
    parts, end = ["set -eu"], 0
    for block in BLOCK.finditer(page):
        language, text = block.groups()
        name = SAVE.findall(page[end : block.start()])
        end = block.end()
        if language == "sh":
            parts.append(text)
        elif name:
            parts.append(f"cat > {name[-1]} <<'END_OF_FILE'\n{text}END_OF_FILE")
        elif language == "json":  # a scene to read, not to save
            parts.append(f"weft check - >/dev/null <<'END_OF_FILE'\n{text}END_OF_FILE")
    return "\n".join(parts)


def typed(page: str) -> subprocess.CompletedProcess[str]:
    """What a shell says that has gone through a page."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        checkout(folder)
        environment = os.environ | {"PATH": f"{folder}/build:{os.environ['PATH']}"}
        return subprocess.run(
            ["/bin/bash", "-c", script_of(page)],
            cwd=folder,
            env=environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=300,
            check=False,
        )


class Blocks(unittest.TestCase):
    def test_what_a_page_says_to_type_works(self):
        self.assertGreater(len(PAGES), 12)
        for path in PAGES:
            if path.name in ELSEWHERE:
                continue
            with self.subTest(path.name):
                made = typed(path.read_text("utf-8"))
                self.assertEqual(made.returncode, 0, made.stdout)

    def test_a_command_and_a_scene_that_are_wrong_are_found(self):
        for page in (
            "```sh\nweft run hanging --nodse 8\n```\n",
            '```json\n{ "format": "weft-scene/1", "cloths": [{ "gird": [8, 8] }] }\n```\n',
            'Save this as `a.json`:\n```json\n{ "format": "weft-scene/2" }\n```\n```sh\nweft check a.json\n```\n',
        ):
            self.assertNotEqual(typed(page).returncode, 0, page)

    def test_the_runs_are_the_ones_of_the_page_but_short(self):
        made = typed("```sh\nweft run hanging --nodes 4 --frames 120 --size 640x480 --json\nls out 2>&1 || true\n```\n")
        self.assertIn('"frames": 2', made.stdout)
        self.assertTrue(shutil.which("ffmpeg"))


if __name__ == "__main__":
    unittest.main()
