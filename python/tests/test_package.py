"""The package as installed: its command line, its types, its scenes."""

import ast
import os
import pathlib
import re
import subprocess
import sys
import unittest

import scenes
import weft
import weft._core

PACKAGE = pathlib.Path(weft.__file__).parent


class Package(unittest.TestCase):
    def test_it_is_the_installed_one_and_brings_all_but_models(self) -> None:
        self.assertTrue(PACKAGE.is_relative_to(sys.prefix))
        self.assertFalse((PACKAGE / "models").exists())
        there = sorted(path.stem for path in (scenes.CHECKOUT / "scenes").glob("*.json"))
        self.assertEqual(weft.scene_names(), there)
        self.assertEqual(weft.schema()["$schema"], "https://json-schema.org/draft/2020-12/schema")

    def test_the_command_line_is_the_same_by_either_name(self) -> None:
        script = pathlib.Path(sys.prefix) / "bin/weft"
        said = [
            subprocess.run([*command, "--version"], capture_output=True, text=True, check=True).stdout
            for command in ([script], [sys.executable, "-m", "weft"])
        ]
        self.assertEqual(said[0], said[1])
        self.assertRegex(said[0], rf"^weft {re.escape(weft.__version__)} \(.*wgpu-native [0-9.]+\)\n$")
        missing = subprocess.run([script, "check", "nowhere.json"], capture_output=True, text=True, check=False)
        self.assertEqual(missing.returncode, 3)

    def test_the_stub_names_what_the_module_has(self) -> None:
        stub = ast.parse((PACKAGE / "_core.pyi").read_text(encoding="utf-8"))
        for name, said, there in (
            ("the module", stub.body, weft._core),
            ("World", next(c for c in stub.body if isinstance(c, ast.ClassDef)).body, weft._core.World),
        ):
            names = {part.name for part in said if isinstance(part, ast.FunctionDef | ast.ClassDef)}
            self.assertEqual(names - {"__new__"}, {n for n in dir(there) if not n.startswith("_")}, name)

    def test_every_public_name_is_documented(self) -> None:
        for name in weft.__all__:
            if name == "__version__":
                continue
            item = getattr(weft, name)
            self.assertTrue(item.__doc__, name)
            for part, value in vars(item).items() if isinstance(item, type) else ():
                if not part.startswith("_") and (callable(value) or isinstance(value, property)):
                    self.assertTrue(value.__doc__, f"{name}.{part}")

    def test_types_are_whole(self) -> None:
        for what in (["-p", "weft"], [str(path) for path in sorted(pathlib.Path(__file__).parent.glob("*.py"))]):
            done = subprocess.run(
                [sys.executable, "-m", "mypy", "--strict", "--cache-dir", os.devnull, *what],
                capture_output=True,
                text=True,
                check=False,
            )
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_adapters_have_names(self) -> None:
        names = [adapter.name for adapter in weft.adapters()]
        self.assertIn(weft.World(scenes.sheet()).adapter, names)


class Commands(unittest.TestCase):
    def test_a_benchmark_has_rows(self) -> None:
        result = weft.bench("copy", "--quick")
        self.assertEqual(result["bench"], "copy")
        self.assertEqual([row["what"] for row in result["rows"]], ["copy", "dispatch"])
        with self.assertRaises(weft.InputError):
            weft.bench("copy", "--sides", "0")

    def test_laws_are_rows(self) -> None:
        rows = weft.validate(solver="mass_spring", only=["fall"])["rows"]
        self.assertGreater(len(rows), 0)
        self.assertEqual({row["law"] for row in rows}, {"fall"})
        with self.assertRaisesRegex(weft.InputError, 'does not know "glue"'):
            weft.validate(solver="glue")


if __name__ == "__main__":
    unittest.main()
