"""A run's meshes as animations, read back by trimesh, usd-core and alembic3d; meshes of USD as cloth."""

import importlib
import json
import os
import pathlib
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
from typing import Any

import numpy as np
import scenes
import trimesh
import weft
import weft.exchange.usd as usd
from numpy.typing import NDArray
from pxr import Gf, Usd, UsdGeom, UsdShade, Vt  # type: ignore[import-untyped]

SCENE = {
    "format": "weft-scene/1",
    "time": {"frame": 0.05, "frames": 7},
    "contact": {"method": "none"},
    "cloths": [
        {"name": "the flag", "grid": [6, 5], "size": [1, 1], "density": 0.2, "pins": ["top"], "color": [1, 0.5, 0]},
        {"name": "the-flag", "grid": [4, 4], "size": [1, 1], "density": 0.2, "transform": {"translate": [2, 0, 0]}},
    ],
}
FRAMES = [0, 2, 4, 6]
Abc: Any = importlib.import_module("alembic3d.Abc")  # a module that mypy does not find
AbcGeom: Any = importlib.import_module("alembic3d.AbcGeom")
SIZES = [30, 16]


def load(path: pathlib.Path) -> Any:
    return trimesh.load(path, process=False, maintain_order=True)


class Exports(unittest.TestCase):
    folder: pathlib.Path
    run_folder: pathlib.Path

    @classmethod
    def setUpClass(cls) -> None:
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)
        cls.run_folder = cls.folder / "run"
        (cls.folder / "scene.json").write_text(json.dumps(SCENE))
        words = ["--out", str(cls.run_folder), "--meshes-every", "2", "--no-pictures"]
        scenes.command_line(str(cls.folder / "scene.json"), *words)

    def setUp(self) -> None:
        before = sorted(self.folder.iterdir())
        self.addCleanup(self.remove_all_but, before)

    def remove_all_but(self, kept: list[pathlib.Path]) -> None:
        for path in self.folder.iterdir():
            if path in kept:
                continue
            if path.is_dir():
                shutil.rmtree(path)
            else:
                path.unlink()

    def beside(self) -> list[str]:
        return sorted(path.name for path in self.folder.iterdir())

    def mesh(self, frame: int) -> Any:
        """The run's own file, by trimesh: texts of OBJ in double, which f32 makes the same again."""
        return load(self.run_folder / f"mesh_{frame:05}.obj")

    def places(self, frame: int) -> NDArray[np.float32]:
        lines = (self.run_folder / f"mesh_{frame:05}.obj").read_text().splitlines()
        return np.array([line.split()[1:] for line in lines if line.startswith("v ")], np.float32)

    def command(self, *words: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [sys.executable, "-m", "weft", "export", *words], capture_output=True, text=True, check=False
        )


class Usds(Exports):
    def test_points_normals_and_times_are_those_of_the_run_to_the_bit(self) -> None:
        for ending in ("usda", "usdc"):
            path = weft.export(self.run_folder, ending)
            self.assertEqual(path, self.folder / f"run.{ending}")
            stage = Usd.Stage.Open(str(path))
            self.assertEqual(stage.GetTimeCodesPerSecond(), 20)
            self.assertEqual(stage.GetFramesPerSecond(), 20)
            self.assertEqual((stage.GetStartTimeCode(), stage.GetEndTimeCode()), (0, 6))
            self.assertEqual(UsdGeom.GetStageMetersPerUnit(stage), 1)
            self.assertEqual(UsdGeom.GetStageUpAxis(stage), "Y")
            self.assertEqual(stage.GetDefaultPrim().GetPath(), "/run")
            first = 0
            for name, shown, count in zip(("the_flag", "the_flag_2"), ("the flag", "the-flag"), SIZES, strict=True):
                mesh = UsdGeom.Mesh(stage.GetPrimAtPath(f"/run/{name}"))
                self.assertEqual(mesh.GetPrim().GetDisplayName(), shown)
                self.assertEqual(mesh.GetPointsAttr().GetTimeSamples(), FRAMES)
                self.assertEqual(mesh.GetNormalsAttr().GetTimeSamples(), FRAMES)
                self.assertEqual(mesh.GetNormalsInterpolation(), "vertex")
                self.assertEqual(mesh.GetSubdivisionSchemeAttr().Get(), "none")
                for frame in FRAMES:
                    points = np.array(mesh.GetPointsAttr().Get(frame))
                    self.assertEqual(points.dtype, np.float32)
                    np.testing.assert_array_equal(points, self.places(frame)[first : first + count])
                    extent = np.array(mesh.GetExtentAttr().Get(frame))
                    np.testing.assert_array_equal(extent, [points.min(axis=0), points.max(axis=0)])
                    normals = np.array(mesh.GetNormalsAttr().Get(frame))
                    wanted = self.mesh(frame).vertex_normals[first : first + count]
                    np.testing.assert_allclose(normals, wanted, atol=1e-6)
                between = np.array(mesh.GetPointsAttr().Get(3.0))  # USD goes linearly from sample to sample
                ends = [self.places(frame)[first : first + count].astype(np.float64) for frame in (2, 4)]
                np.testing.assert_allclose(between, (ends[0] + ends[1]) / 2, atol=1e-6)
                first += count

    def test_triangles_texture_and_materials_are_those_of_the_run(self) -> None:
        stage = Usd.Stage.Open(str(weft.export(self.run_folder, "usdc")))
        whole = self.mesh(0)
        first = 0
        for name, shown, count in zip(("the_flag", "the_flag_2"), ("the flag", "the-flag"), SIZES, strict=True):
            mesh = UsdGeom.Mesh(stage.GetPrimAtPath(f"/run/{name}"))
            corners = np.array(mesh.GetFaceVertexIndicesAttr().Get()).reshape(-1, 3) + first
            inside = (whole.faces >= first).all(axis=1) & (whole.faces < first + count).all(axis=1)
            np.testing.assert_array_equal(corners, whole.faces[inside])
            self.assertEqual(set(mesh.GetFaceVertexCountsAttr().Get()), {3})
            texture = UsdGeom.PrimvarsAPI(mesh).GetPrimvar("st")
            self.assertEqual(texture.GetInterpolation(), "vertex")
            wanted = whole.visual.uv[first : first + count].astype(np.float32)
            np.testing.assert_array_equal(np.array(texture.Get()), wanted)
            material = UsdShade.MaterialBindingAPI(mesh.GetPrim()).ComputeBoundMaterial()[0]
            self.assertEqual(material.GetPath(), f"/run/materials/{name}")
            self.assertEqual(material.GetPrim().GetDisplayName(), shown)
            color = UsdShade.Shader(stage.GetPrimAtPath(f"/run/materials/{name}/surface")).GetInput("diffuseColor")
            if name == "the_flag":
                np.testing.assert_allclose(color.Get(), [1, 0.21404114, 0], rtol=1e-6)  # sRGB's 0.5, linear
            else:
                self.assertFalse(color)
            first += count

    def test_a_range_is_exported_and_a_single_mesh_has_no_times(self) -> None:
        path = weft.export(self.run_folder, "usdc", self.folder / "a.usd", first=1, last=6, every=2)
        several = Usd.Stage.Open(str(path))
        mesh = UsdGeom.Mesh(several.GetPrimAtPath("/a/the_flag"))
        self.assertEqual(mesh.GetPointsAttr().GetTimeSamples(), [2, 6])
        one = Usd.Stage.Open(str(weft.export(self.run_folder, "usda", self.folder / "b.usda", last=1)))
        points = UsdGeom.Mesh(one.GetPrimAtPath("/b/the_flag")).GetPointsAttr()
        self.assertEqual(points.GetTimeSamples(), [])
        np.testing.assert_array_equal(np.array(points.Get()), self.places(0)[:30])

    def test_a_long_animation_is_saved_as_it_comes(self) -> None:
        self.addCleanup(setattr, usd, "_SAVED_EVERY", usd._SAVED_EVERY)
        usd._SAVED_EVERY = 1  # after each mesh
        stage = Usd.Stage.Open(str(weft.export(self.run_folder, "usdc")))
        points = UsdGeom.Mesh(stage.GetPrimAtPath("/run/the_flag")).GetPointsAttr()
        for frame in FRAMES:
            np.testing.assert_array_equal(np.array(points.Get(frame)), self.places(frame)[:30])

    def test_what_was_exported_is_cloth_again(self) -> None:
        path = weft.export(self.run_folder, "usdc")
        for time, frame in ((None, 0), (4, 4)):
            positions, triangles = weft.read_usd(path, time=time)
            np.testing.assert_array_equal(positions, self.places(frame))
            np.testing.assert_array_equal(triangles, self.mesh(0).faces)
        part = weft.read_usd(path, "/run/the_flag")
        scene = {"format": "weft-scene/1", "cloths": [{"mesh": "flag", "density": 0.2}]}
        world = weft.World(scene, meshes={"flag": part})
        np.testing.assert_array_equal(world.positions, self.places(0)[:30])


class Alembics(Exports):
    """Read by the library's own reader: there is no other in Python."""

    def part(self, path: pathlib.Path, name: str) -> Any:
        """The schema of a mesh below the root, which has the file's name."""
        archive = Abc.IArchive(str(path))
        root = AbcGeom.IXform(archive.getTop(), path.stem)
        self.assertEqual([child.getName() for child in root.children], ["the flag", "the-flag"])
        return AbcGeom.IPolyMesh(root, name).getSchema()

    def check_positions(self, schema: Any, frames: list[int], first: int, count: int) -> None:
        self.assertEqual(schema.getNumSamples(), len(frames))
        for k, frame in enumerate(frames):
            time = schema.getTimeSampling().getSampleTime(k)
            self.assertAlmostEqual(time, frame * 0.05, 12)
            at = Abc.ISampleSelector(time)  # by an index it cannot be asked: the binding takes that for a time
            sample = schema.getValue(at)
            places = np.asarray(memoryview(sample.getPositions()))
            self.assertEqual(places.dtype, np.float32)
            np.testing.assert_array_equal(places, self.places(frame)[first : first + count])
            normals = np.asarray(memoryview(schema.getNormalsParam().getIndexedValue(at).getVals()))
            np.testing.assert_allclose(normals, self.mesh(frame).vertex_normals[first : first + count], atol=1e-6)

    def test_points_normals_and_times_are_those_of_the_run_to_the_bit(self) -> None:
        path = weft.export(self.run_folder, "abc")
        self.assertEqual(path, self.folder / "run.abc")
        whole, first = self.mesh(0), 0
        for name, count in zip(("the flag", "the-flag"), SIZES, strict=True):
            schema = self.part(path, name)
            self.check_positions(schema, FRAMES, first, count)
            at = Abc.ISampleSelector()
            sample = schema.getValue(at)
            corners = np.array(list(sample.getFaceIndices())).reshape(-1, 3)
            inside = (whole.faces >= first).all(axis=1) & (whole.faces < first + count).all(axis=1)
            np.testing.assert_array_equal(corners[:, ::-1] + first, whole.faces[inside])  # clockwise
            self.assertEqual(set(sample.getFaceCounts()), {3})
            texture = np.asarray(memoryview(schema.getUVsParam().getIndexedValue(at).getVals()))
            np.testing.assert_array_equal(texture, whole.visual.uv[first : first + count].astype(np.float32))
            self.assertEqual(list(schema.getFaceSetNames()), [name])
            first += count

    def test_meshes_at_unequal_distances_have_their_own_times(self) -> None:
        odd = self.folder / "odd"
        odd.mkdir()
        for name in ("meshes.json", "mesh_00000.obj", "mesh_00002.obj", "mesh_00006.obj"):
            (odd / name).write_bytes((self.run_folder / name).read_bytes())
        path = weft.export(odd, "abc")
        self.check_positions(self.part(path, "the-flag"), [0, 2, 6], 30, 16)
        later = weft.export(self.run_folder, "abc", self.folder / "later.abc", first=2, every=2)
        self.check_positions(self.part(later, "the flag"), [2, 6], 0, 30)
        one = weft.export(self.run_folder, "abc", self.folder / "one.abc", first=6)
        self.check_positions(self.part(one, "the flag"), [6], 0, 30)


class OtherFormats(Exports):
    def test_trimesh_reads_the_first_mesh_of_a_glb_file_by_its_names(self) -> None:
        loaded = load(weft.export(self.run_folder, "glb"))
        first = 0
        for name, count in zip(("the flag", "the-flag"), SIZES, strict=True):
            mesh = loaded.geometry[name]
            np.testing.assert_array_equal(mesh.vertices.astype(np.float32), self.places(0)[first : first + count])
            wanted = self.mesh(0).visual.uv[first : first + count].astype(np.float32)
            np.testing.assert_allclose(mesh.visual.uv, wanted, atol=1e-7)
            first += count

    def test_caches_have_the_places_of_every_mesh_to_the_bit(self) -> None:
        wanted = np.stack([self.places(frame) for frame in FRAMES])
        pc2 = weft.export(self.run_folder, "pc2").read_bytes()
        self.assertEqual(struct.unpack("<12siiffi", pc2[:32]), (b"POINTCACHE2\0", 1, 46, 0.0, 2.0, 4))
        np.testing.assert_array_equal(np.frombuffer(pc2[32:], "<f4").reshape(4, 46, 3), wanted)
        mdd = weft.export(self.run_folder, "mdd").read_bytes()
        self.assertEqual(struct.unpack(">ii", mdd[:8]), (4, 46))
        np.testing.assert_array_equal(np.frombuffer(mdd[8:24], ">f4"), np.array([0, 0.1, 0.2, 0.3], np.float32))
        np.testing.assert_array_equal(np.frombuffer(mdd[24:], ">f4").reshape(4, 46, 3), wanted)
        rest = load(self.folder / "run.obj")
        np.testing.assert_array_equal(rest.vertices.astype(np.float32), wanted[0])
        np.testing.assert_array_equal(rest.faces, self.mesh(0).faces)

    def test_trimesh_reads_a_sequence_with_its_normals(self) -> None:
        folder = weft.export(self.run_folder, "ply", self.folder / "sequence")
        for frame in FRAMES:
            mesh = load(folder / f"mesh_{frame:05}.ply")
            np.testing.assert_array_equal(mesh.vertices.astype(np.float32), self.places(frame))
            np.testing.assert_array_equal(mesh.faces, self.mesh(0).faces)
            smooth = trimesh.Trimesh(mesh.vertices, mesh.faces, process=False).vertex_normals
            self.assertGreater(np.einsum("ij,ij->i", mesh.vertex_normals, smooth).min(), 0.99)


class Refusals(Exports):
    def test_what_cannot_be_exported_is_one_sentence_and_nothing_is_left(self) -> None:
        before = self.beside()
        cut = self.folder / "cut"
        cut.mkdir()
        for path in self.run_folder.glob("mesh*"):
            (cut / path.name).write_bytes(path.read_bytes())
        text = (cut / "mesh_00004.obj").read_text()
        (cut / "mesh_00004.obj").write_text(text[: len(text) // 2])
        run = str(self.run_folder)
        for words, code, said in (
            ((run, "--format", "usdc", "-o", str(self.folder / "a.usda")), 3, "would not be read as usdc"),
            (
                (run, "--format", "usdc", "-o", str(self.folder / "no/a.usdc")),
                1,
                "a.usdc cannot be written: there is no folder",
            ),
            ((run, "--format=usda", "--first", "9"), 3, "has no mesh of the frames 9 to 6"),
            ((str(self.folder / "none"), "--format", "usda"), 3, "none cannot be read: No such file or directory."),
            ((str(cut), "--format", "usdc"), 3, "mesh_00004.obj"),
            ((run, "--format", "abc", "-o", str(self.folder / "a.usdc")), 3, "would not be read as abc"),
            ((run, "--format", "abc", "--first", "9"), 3, "has no mesh of the frames 9 to 6"),
            ((str(cut), "--format", "abc"), 3, "mesh_00004.obj"),
        ):
            done = self.command(*words)
            self.assertEqual((done.returncode, done.stdout), (code, ""), done.stderr)
            self.assertRegex(done.stderr, r"^weft: [^\n]+\n$")
            self.assertIn(said, done.stderr)
            self.assertEqual(self.beside(), sorted([*before, "cut"]))
        self.assertEqual(self.command(run, "--format", "usdc", "--every", "0").returncode, 2)
        with self.assertRaisesRegex(weft.InputError, "mesh_00004.obj"):
            weft.export(cut, "glb")
        with self.assertRaisesRegex(weft.InputError, 'does not know "fbx"'):
            weft.export(run, "fbx")

    def test_the_command_writes_and_says_where(self) -> None:
        for words, name in (("usdc", "run.usdc"), ("glb", "run.glb")):
            done = self.command(str(self.run_folder), "--format", words)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(str(self.folder / name), done.stdout)
            self.assertIn(name, self.beside())

    def test_text_over_the_limit_is_refused_with_both_numbers(self) -> None:
        self.addCleanup(setattr, usd, "MOST_BYTES_OF_TEXT", usd.MOST_BYTES_OF_TEXT)
        usd.MOST_BYTES_OF_TEXT = 4415  # 4 * 46 * 24 = 4416
        with self.assertRaisesRegex(weft.LimitError, "are 4416 bytes, more than the limit of 4415 for usda"):
            weft.export(self.run_folder, "usda")
        weft.export(self.run_folder, "usdc")
        self.assertEqual(self.beside(), ["run", "run.usdc", "scene.json"])

    def test_without_its_library_one_sentence_says_what_to_install(self) -> None:
        for module, name, extra, format in (
            ("pxr", "usd-core", "usd", "usdc"),
            ("alembic3d", "alembic3d", "alembic", "abc"),
        ):
            code = f"""if True:
                import importlib.util, sys, weft
                sys.modules["{module}"] = None
                importlib.util.find_spec = lambda name: None
                weft.export(sys.argv[1], "{format}")"""
            other = scenes.python(code, str(self.run_folder))
            said = f"weft.errors.Error: The format {format} needs {name}: pip install 'weft[{extra}]'."
            self.assertIn(said, other.communicate()[1])

    def test_a_full_disk_is_one_sentence_and_leaves_nothing(self) -> None:
        before = self.beside()
        for format in ("usda", "usdc", "abc"):
            words = (
                f"trap '' XFSZ; ulimit -f 4; exec {sys.executable} -m weft export {self.run_folder} --format {format}"
            )
            done = subprocess.run(["/bin/bash", "-c", words], capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stdout), (1, ""), done.stderr)
            self.assertRegex(done.stderr, rf"^weft: File [^\n]*run.{format} cannot be written: [^\n]+\.\n$")
            self.assertEqual(self.beside(), before)

    def test_an_interrupt_leaves_nothing(self) -> None:
        long = self.folder / "long"
        long.mkdir()
        (long / "meshes.json").write_bytes((self.run_folder / "meshes.json").read_bytes())
        for frame in range(20000):
            (long / f"mesh_{frame:05}.obj").symlink_to(self.run_folder / "mesh_00000.obj")
        code = """if True:
            import sys, weft.exchange.command as command, weft.exchange.usd as usd
            add = usd._Writer.add
            def interrupted(self, shape):
                add(self, shape)
                if shape.frame == 100:
                    raise KeyboardInterrupt
            usd._Writer.add = interrupted
            sys.exit(command.main([sys.argv[1], "--format", "usdc"]))"""
        other = scenes.python(code, str(long))
        self.assertEqual(other.communicate()[1], "weft: Interrupted; nothing is written.\n")
        self.assertEqual(other.returncode, 130)
        self.assertEqual(self.beside(), ["long", "run", "scene.json"])
        for format in ("usdc", "abc"):
            words = [sys.executable, "-m", "weft", "export", str(long), "--format", format]
            for send, number in ((os.killpg, signal.SIGINT), (os.kill, signal.SIGTERM)):  # by a terminal; by a program
                child = subprocess.Popen(words, stderr=subprocess.PIPE, text=True, start_new_session=True)
                while child.poll() is None and len(self.beside()) == 3:
                    time.sleep(0.01)  # the temporary file comes
                send(child.pid, number)
                self.assertEqual(child.communicate()[1], "weft: Interrupted; nothing is written.\n")
                self.assertEqual(child.returncode, 130)
                self.assertEqual(self.beside(), ["long", "run", "scene.json"])


class Reading(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "a.usda")
        self.stage = Usd.Stage.CreateNew(self.path)
        UsdGeom.SetStageMetersPerUnit(self.stage, 1)  # else centimetres

    def mesh(self, path: str, points: Any, counts: Any, corners: Any) -> Any:
        mesh = UsdGeom.Mesh.Define(self.stage, path)
        mesh.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(np.array(points, np.float32)))
        mesh.CreateFaceVertexCountsAttr(counts)
        mesh.CreateFaceVertexIndicesAttr(corners)
        return mesh

    def read(self, *words: Any) -> tuple[NDArray[np.float32], NDArray[np.uint32]]:
        self.stage.GetRootLayer().Save()
        return weft.read_usd(self.path, *words)

    SQUARE = ([0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0])

    def test_places_are_in_metres_with_y_up_where_the_prims_put_them(self) -> None:
        UsdGeom.SetStageMetersPerUnit(self.stage, 0.01)
        UsdGeom.SetStageUpAxis(self.stage, UsdGeom.Tokens.z)
        parent = UsdGeom.Xform.Define(self.stage, "/a")
        parent.AddTranslateOp().Set(Gf.Vec3d(100, 200, 300))
        mesh = self.mesh("/a/b", self.SQUARE, [4], [0, 1, 2, 3])
        mesh.AddScaleOp().Set(Gf.Vec3f(100, 100, 100))
        positions, triangles = self.read()
        # (x, y, z) of centimetres with z up is (x, z, -y) of metres.
        np.testing.assert_allclose(positions, [[1, 3, -2], [2, 3, -2], [2, 3, -3], [1, 3, -3]], rtol=1e-7)
        self.assertEqual((positions.dtype, triangles.dtype), (np.float32, np.uint32))
        np.testing.assert_array_equal(triangles, [[0, 1, 2], [0, 2, 3]])

    def test_polygons_are_fans_without_holes_and_what_is_turned_inside_out_is_turned_back(self) -> None:
        points = [*self.SQUARE, [0.5, 2, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1]]
        counts, corners = [5, 3, 3], [0, 1, 2, 4, 3, 5, 6, 7, 0, 1, 2]
        fans = [[0, 1, 2], [0, 2, 4], [0, 4, 3]]
        mesh = self.mesh("/a", points, counts, corners)
        mesh.CreateHoleIndicesAttr([1])
        np.testing.assert_array_equal(self.read()[1], [*fans, [0, 1, 2]])
        mesh.CreateOrientationAttr(UsdGeom.Tokens.leftHanded)
        np.testing.assert_array_equal(self.read()[1], [fan[::-1] for fan in [*fans, [0, 1, 2]]])
        mesh.AddScaleOp().Set(Gf.Vec3f(-1, 1, 1))  # mirrored as well
        np.testing.assert_array_equal(self.read()[1], [*fans, [0, 1, 2]])

    def test_instances_count_and_what_is_hidden_or_a_guide_does_not(self) -> None:
        self.mesh("/shape/a", self.SQUARE, [4], [0, 1, 2, 3])
        for k in range(3):
            prim = UsdGeom.Xform.Define(self.stage, f"/scene/copy_{k}")
            prim.AddTranslateOp().Set(Gf.Vec3d(10 * k, 0, 0))
            prim.GetPrim().GetReferences().AddInternalReference("/shape")
            prim.GetPrim().SetInstanceable(True)
        self.mesh("/scene/hidden", self.SQUARE, [4], [0, 1, 2, 3]).MakeInvisible()
        self.mesh("/scene/guide", self.SQUARE, [4], [0, 1, 2, 3]).CreatePurposeAttr(UsdGeom.Tokens.guide)
        positions, triangles = self.read("/scene")
        self.assertEqual(positions.shape, (12, 3))
        np.testing.assert_array_equal(positions[::4, 0], [0, 10, 20])
        np.testing.assert_array_equal(triangles[4:], [[8, 9, 10], [8, 10, 11]])

    def test_a_time_chooses_the_shape_and_without_one_the_first_is_read(self) -> None:
        mesh = self.mesh("/a", self.SQUARE, [4], [0, 1, 2, 3])
        mesh.GetPointsAttr().Clear()
        for frame in (3, 5):
            mesh.GetPointsAttr().Set(Vt.Vec3fArray.FromNumpy(np.array(self.SQUARE, np.float32) * frame), frame)
        self.assertEqual(self.read()[0].max(), 3)
        self.assertEqual(self.read("/", 4.0)[0].max(), 4)

    def test_what_is_wrong_is_one_sentence_with_the_mesh_and_the_value(self) -> None:
        for counts, corners, said in (
            ([4], [0, 1, 2, 4], "mesh /a: a face names point 4, but there are 4, from 0."),
            ([4], [0, 1, 2, -1], "mesh /a: a face names point -1, but there are 4, from 0."),
            ([2, 4], [0, 1, 0, 1, 2, 3], "mesh /a: a face has 2 corners, fewer than 3."),
            ([4], [0, 1, 2], "mesh /a: its faces have 4 corners, but 3 are listed."),
            ([], [], 'has no visible mesh at or below "/".'),
        ):
            self.mesh("/a", self.SQUARE, counts, corners)
            with self.assertRaises(weft.InputError) as caught:
                self.read()
            self.assertIn(said, str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))
        for prim in ("/nowhere", "not a path"):
            with self.assertRaisesRegex(weft.InputError, f'has no prim "{prim}"'):
                self.read(prim)
        with self.assertRaisesRegex(weft.InputError, "there is no such file"):
            weft.read_usd(self.path + "x")
        broken = pathlib.Path(self.path).with_name("b.usda")
        broken.write_text("#usda 1.0\ndef Mesh {")
        with self.assertRaises(weft.InputError) as caught:
            weft.read_usd(broken)
        self.assertRegex(str(caught.exception), r"^File [^\n]*b.usda cannot be read as USD: [^\n]+\.$")
