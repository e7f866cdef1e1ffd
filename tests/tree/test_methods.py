"""A method is a folder and a row: code names it there, where its words stand in the scene, and nowhere else."""

import pathlib
import re
import unittest

from scripts import lines

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROOMS = ("src/", "apps/", "packages/", "include/", "bench/paper/", "examples/", "cmake/", "scripts/")
COMMENT = {
    **dict.fromkeys((".cpp", ".hpp", ".wgsl", ".ts", ".js"), re.compile(r"//.*|/\*.*?\*/|^\s*/?\*.*", re.MULTILINE)),
    **dict.fromkeys((".py", ".sh", ".cmake", ".txt"), re.compile(r"#.*")),
}

# Where every method has a line: its row, its two factories, its sources, its words and keys.
LINES = {
    "packages/weft/src/scene_types.ts",
    "src/method/CMakeLists.txt",
    "src/method/solvers.cpp",
    "src/method/steppers.cpp",
    "src/method/table.cpp",
    "src/scene/format.cpp",
    "src/scene/names.hpp",
    "src/scene/scene.hpp",
}
# What is about one method by its own account: experiments, as scene files are, the integrators of the lessons, and the
# system of nodes and springs that every stepper moves, which lies with the oldest of them.
NAMED = {
    "mass_spring": {
        "apps/cli/cloths.cpp",
        "apps/web/teach/integrators.ts",
        "src/bench/contact.cpp",
        "src/bench/hanging_sheet.cpp",
        "src/bench/multigrid.cpp",
        "src/bench/sheet_runs.cpp",
        "src/method/blow_step.cpp",
        "src/method/multigrid/reference/implicit_step.hpp",
        "src/method/stepper.hpp",
        "src/reference/simulation.hpp",
        "src/validate/trial.cpp",
    },
    "multigrid": {
        "apps/cli/bench.cpp",
        "apps/cli/bench_command.cpp",
        "apps/cli/bench_rows.hpp",
        "apps/cli/completion.cpp",
        "apps/web/teach/integrators.ts",
        "bench/paper/__main__.py",
        "bench/paper/cases.py",
        "bench/paper/facts.py",
        "bench/paper/measure.py",
        "bench/paper/plots.py",
        "bench/paper/report.py",
        "bench/paper/store.py",
        "examples/cpp/own_mesh.cpp",
        "scripts/make_garment.py",
        "scripts/measure_fabrics.py",
        "src/bench/CMakeLists.txt",
        "src/bench/multigrid.cpp",
    },
    "vbd": {"apps/web/teach/integrators.ts"},
}


def words():
    """The word and the enumerator of every method, from the scene's own lists: {"multigrid": "Multigrid"}."""
    names = (ROOT / "src/scene/names.hpp").read_text()
    kinds = (ROOT / "src/scene/scene.hpp").read_text()
    listed = re.findall(r'"(\w+)"', re.search(r"kSolverKindNames\[\] = {(.*?)}", names, re.DOTALL)[1])
    body = COMMENT[".hpp"].sub("", re.search(r"enum class SolverKind {(.*?)}", kinds, re.DOTALL)[1])
    found = dict(zip(listed, re.findall(r"\w+", body), strict=True))
    assert found.pop("auto") == "Auto"
    return found


def uses(texts, word, enumerator):
    """The files whose code names the method."""
    name = re.compile(rf"\b{word}\b|\bSolverKind::{enumerator}\b")
    return {path for path, text in texts.items() if name.search(COMMENT[pathlib.Path(path).suffix].sub("", text))}


def stray(texts, word, enumerator):
    return sorted(
        path
        for path in uses(texts, word, enumerator) - LINES - NAMED.get(word, set())
        if not path.startswith(f"src/method/{word}/")
    )


def tree():
    paths = [path for path in lines.tracked() if path.startswith(ROOMS) and (ROOT / path).is_file()]
    return {path: (ROOT / path).read_text() for path in paths if pathlib.Path(path).suffix in COMMENT}


class Methods(unittest.TestCase):
    def test_code_names_a_method_in_its_folder_its_row_and_its_words_alone(self):
        texts = tree()
        for word, enumerator in words().items():
            with self.subTest(word):
                self.assertTrue(any(path.startswith(f"src/method/{word}/") for path in texts))
                self.assertTrue((ROOT / f"docs/solvers/{word}.md").is_file())
                self.assertEqual(stray(texts, word, enumerator), [])

    def test_what_stands_in_the_lists_here_is_there(self):
        texts = tree()
        for word, paths in NAMED.items():
            self.assertEqual(sorted(paths - uses(texts, word, words()[word])), [])

    def test_a_second_list_of_words_and_a_branch_on_a_kind_are_found(self):
        for word, enumerator in words().items():
            for path, text in {
                "apps/cli/options.cpp": f'constexpr const char* kSolvers[] = {{"{word}"}};  // not',
                "apps/web/src/solvers.ts": f'const SOLVERS = ["{word}"];',
                "src/sim/world.cpp": f"if (kind == scene::SolverKind::{enumerator}) return;",
                "src/state/state.cpp": f'#include "method/{word}/plan.hpp"',
            }.items():
                self.assertEqual(stray({path: text}, word, enumerator), [path])
            told = {"src/sim/world.cpp": f"// As {word} does.", "src/sim/a.hpp": f"/// {word}\nint {word}_count;"}
            self.assertEqual(stray(told, word, enumerator), [])


if __name__ == "__main__":
    unittest.main()
