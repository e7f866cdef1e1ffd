"""`weft view` on a display of its own (Xvfb) and lavapipe: what its window shows, does and writes. The program is the
last argument."""

import os
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zlib
from pathlib import Path

import x11

WEFT = Path(sys.argv.pop()).resolve()
SMALL = ["--set", "cloths.0.grid=[16,16]"]
PANEL = 320  # points of the window's width, as panel.hpp has it
HANG = 200  # [s] ends a hang only


def read_png(path):
    """Width, height, and rows of (red, green, blue)."""
    data = Path(path).read_bytes()
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at : at + 8])
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", data[at + 8 : at + 18])
        if kind == b"IDAT":
            packed += data[at + 8 : at + 8 + size]
        at += 12 + size
    assert depth == 8 and color in (2, 6)
    step = 3 if color == 2 else 4
    flat, stride = zlib.decompress(packed), width * step
    rows, above = [], bytes(stride)
    for y in range(height):
        kind, line = flat[y * (stride + 1)], bytearray(flat[y * (stride + 1) + 1 : (y + 1) * (stride + 1)])
        for i in range(stride):
            left = line[i - step] if i >= step else 0
            corner = above[i - step] if i >= step else 0
            if kind == 4:
                guess = left + above[i] - corner
                near = min(
                    (abs(guess - left), 0, left), (abs(guess - above[i]), 1, above[i]), (abs(guess - corner), 2, corner)
                )
                line[i] = (line[i] + near[2]) & 255
            else:
                line[i] = (line[i] + (0, left, above[i], (left + above[i]) // 2)[kind]) & 255
        rows.append([tuple(line[step * x : step * x + 3]) for x in range(width)])
        above = bytes(line)
    return width, height, rows


def share(rows, columns, lines, wanted):
    """Which part of these pixels is as wanted."""
    pixels = [rows[y][x] for y in lines for x in columns]
    return sum(map(wanted, pixels)) / len(pixels)


def is_background(color):
    """A grey between those of the picture's background."""
    return max(color) - min(color) < 16 and min(color) > 150


def is_colored(color):
    """Clearly more so than the background."""
    return max(color) - min(color) > 24


class View(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        read, write = os.pipe()
        # Without -noreset it begins anew where the last client goes, and refuses one that comes meanwhile.
        cls.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x900x24", "-nolisten", "tcp", "-noreset"],
            pass_fds=[write],
            stderr=subprocess.DEVNULL,
        )
        os.close(write)
        with os.fdopen(read) as said:
            number = said.readline().strip()
        assert number, "Xvfb has not started"
        cls.display = f":{number}"

    @classmethod
    def tearDownClass(cls):
        cls.server.terminate()
        cls.server.wait()

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return str(Path(self.folder.name, name))

    def environment(self):
        environment = {**os.environ, "DISPLAY": self.display}
        environment.pop("WAYLAND_DISPLAY", None)
        return environment

    def start(self, *arguments):
        child = subprocess.Popen(
            [WEFT, "view", *arguments],
            env=self.environment(),
            cwd=self.folder.name,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        self.addCleanup(child.kill)
        return child

    def run_view(self, *arguments):
        child = self.start(*arguments)
        out, err = child.communicate(timeout=HANG)
        return child.returncode, out, err

    def tool(self, *words):
        return subprocess.run(["xdotool", *words], env=self.environment(), capture_output=True, text=True).stdout

    def wait_for(self, child, title):
        """Until the window has this title; its number."""
        until = time.monotonic() + HANG
        while time.monotonic() < until and child.poll() is None:
            found = self.tool("search", "--name", f"^{re.escape(title)}$").split()
            if found:
                return found[-1]
            time.sleep(0.1)
        said = child.stderr.read() if child.poll() is not None else "it runs"
        self.fail(f'there is no window "{title}": {said}')

    def speak_to(self, window):
        client = x11.Client(self.display, int(window))
        self.addCleanup(client.close)
        return client

    def close(self, child):
        child.send_signal(signal.SIGINT)
        out, err = child.communicate(timeout=HANG)
        self.assertEqual(child.returncode, 130, err)
        self.assertEqual(err, "weft: Interrupted.\n")

    def test_the_state_is_that_of_a_run(self):
        code, out, err = self.run_view("hanging", *SMALL, "--frames", "9")
        self.assertEqual((code, err), (0, ""))
        ran = subprocess.run(
            [WEFT, "run", "hanging", *SMALL, "--frames", "9"], capture_output=True, text=True, check=True
        )
        shown = re.search(r"state hash +([0-9a-f]{16})", out).group(1)
        self.assertEqual(shown, re.search(r"state hash +([0-9a-f]{16})", ran.stdout).group(1))
        self.assertRegex(out, r"^hanging: 9 frames in a window of 1280 x 800 pixels on llvmpipe")
        self.assertRegex(out, r"a frame +[0-9.]+ ms")

    def test_the_window_shows_cloth_and_panel(self):
        code, _, err = self.run_view(
            "hanging", *SMALL, "--frames", "60", "--size", "900x600", "--picture", self.path("a.png")
        )
        self.assertEqual((code, err), (0, ""))
        width, height, rows = read_png(self.path("a.png"))
        self.assertEqual((width, height), (900, 600))
        picture, panel = range(width - PANEL), range(width - PANEL, width)
        middle = range(width // 2 - PANEL // 2 - 100, width // 2 - PANEL // 2 + 100)
        # Background at all borders, the cloth's colours in the middle.
        self.assertEqual(share(rows, range(4), range(height), is_background), 1)
        self.assertEqual(share(rows, picture, range(height - 4, height), is_background), 1)
        self.assertGreater(share(rows, middle, range(height // 2 - 60, height // 2 + 60), is_colored), 0.3)
        # The panel is dark, with text and buttons of other colours in it.
        ground = rows[height - 2][width - PANEL + 3]
        self.assertLess(max(ground), 60)
        self.assertGreater(share(rows, panel, range(height), lambda color: color == ground), 0.3)
        self.assertGreater(share(rows, panel, range(height), lambda color: min(color) > 150), 0.01)

    def test_keys_and_the_mouse_are_heard(self):
        child = self.start("hanging", *SMALL, "--picture", self.path("a.png"))
        window = self.wait_for(child, "hanging - weft")
        place = re.search(r"Position: (-?\d+),(-?\d+)", self.tool("getwindowgeometry", window))
        left, top = int(place.group(1)), int(place.group(2))
        self.tool("mousemove", str(left + 40), str(top + 700))
        self.tool("key", "space")
        self.wait_for(child, "hanging (paused) - weft")
        self.tool("key", "4")  # stretch, with a legend at the lower left
        self.tool("key", "t")  # the light theme
        self.tool("key", "space")
        self.wait_for(child, "hanging - weft")  # so those before have been heard too
        # The first button of the panel is Pause.
        self.tool("mousemove", str(left + 1280 - PANEL + 50), str(top + 26))
        self.tool("mousedown", "1")
        self.tool("mouseup", "1")
        self.wait_for(child, "hanging (paused) - weft")
        self.close(child)
        width, height, rows = read_png(self.path("a.png"))
        self.assertGreater(min(rows[height - 2][width - PANEL + 3]), 200)
        legend = share(rows, range(16, 250), range(height - 90, height - 10), is_background)
        self.assertLess(legend, 0.5)

    def test_files_are_opened_by_drop(self):
        child = self.start("hanging", *SMALL, "--paused")
        window = self.wait_for(child, "hanging (paused) - weft")
        client = self.speak_to(window)
        scene = Path(self.path("little sheet.json"))  # a space comes as %20
        scene.write_text('{"format": "weft-scene/1", "cloths": [{"grid": [4, 4], "size": [1, 1], "density": 0.2}]}')
        self.assertTrue(client.drop([scene], 200, 200))
        self.wait_for(child, "little sheet (paused) - weft")
        mesh = Path(self.path("tent.obj"))
        mesh.write_text("v 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 1 0\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
        self.assertTrue(client.drop([mesh], 200, 200))
        self.tool("key", "Return")  # what it is asked first: an obstacle
        self.wait_for(child, "tent (paused) - weft")
        scene.write_text("no scene")
        self.assertTrue(client.drop([scene], 200, 200))  # said in the window, which goes on
        self.tool("key", "space")
        self.wait_for(child, "tent - weft")
        self.close(child)

    def test_the_window_follows_its_size_and_its_cross(self):
        child = self.start("hanging", *SMALL, "--record", "--out", self.path("film"), "--picture", self.path("a.png"))
        window = self.wait_for(child, "hanging - weft")
        self.tool("windowsize", "--sync", window, "700", "500")
        self.tool("key", "space")
        self.wait_for(child, "hanging (paused) - weft")  # drawn in its new size, since it hears in turn
        self.speak_to(window).ask_to_close()
        out, err = child.communicate(timeout=HANG)
        self.assertEqual((child.returncode, err), (0, ""))
        self.assertRegex(out, r"^\d+ pictures? and run.mp4 are in .*/film/hanging\.\n$")
        width, height, rows = read_png(self.path("a.png"))
        self.assertEqual((width, height), (700, 500))
        self.assertLess(max(rows[height - 2][width - PANEL + 3]), 60)
        self.assertEqual(share(rows, range(4), range(height), is_background), 1)

    def test_the_film_is_one_of_a_run(self):
        for folder in ("hanging", "hanging-2"):  # nothing is written over
            code, _, err = self.run_view("hanging", *SMALL, "--frames", "3", "--record", "--out", self.path("film"))
            self.assertEqual((code, err), (0, ""))
            names = sorted(path.name for path in Path(self.path("film"), folder).glob("*.png"))
            self.assertEqual(names, [f"frame_{i:05}.png" for i in range(3)])
            self.assertTrue(Path(self.path("film"), folder, "run.mp4").exists())

    def test_without_the_window_it_is_said_how_to_get_it(self):
        alone = self.path("weft")
        shutil.copy(WEFT, alone)
        ran = subprocess.run(
            [alone, "view", "hanging"],
            capture_output=True,
            text=True,
            env={**self.environment(), "LD_LIBRARY_PATH": str(WEFT.parent)},
        )
        self.assertEqual((ran.returncode, ran.stdout), (1, ""))
        self.assertEqual(
            ran.stderr,
            f"weft: There is no window: {alone}_window cannot be run (No such file or directory); "
            "./dev view SCENE installs GLFW and Dear ImGui and builds it.\n",
        )

    def test_what_cannot_be_shown_is_refused_in_one_sentence(self):
        code, out, err = self.run_view("hangin")
        self.assertEqual((code, out), (3, ""))
        self.assertRegex(err, r'^weft: There is no shipped scene "hangin", but there is "hanging".*\n$')
        code, _, err = self.run_view("hanging", "--set", "drag=-1")
        self.assertEqual(code, 3)
        self.assertRegex(err, r"^weft: .*drag.*\n$")
        code, _, err = self.run_view("hanging", "--size", "10x10")
        self.assertEqual(code, 2)
        self.assertRegex(err, r"^weft: --size: .*from 200 to 8192.*\n$")
        code, _, err = self.run_view("hanging", "--adapter", "no such GPU")
        self.assertEqual(code, 4)
        self.display, display = "", self.display
        try:
            code, _, err = self.run_view("hanging")
        finally:
            self.display = display
        self.assertEqual(code, 1)
        self.assertRegex(err, r"^weft: There is no display to open a window on: .*\n$")


unittest.main(argv=[sys.argv[0], "-v"])
