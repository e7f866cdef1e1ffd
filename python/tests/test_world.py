"""A world: the bits of the command line's, arrays in and out, threads, Ctrl-C."""

import json
import pathlib
import signal
import struct
import tempfile
import threading
import time
import unittest
import zlib
from typing import Any

import numpy as np
import scenes
import weft


class Bits(unittest.TestCase):
    def test_a_shipped_scene_ends_in_the_bits_of_the_command_line(self) -> None:
        path = scenes.CHECKOUT / "scenes/hanging.json"
        there = scenes.command_line(str(path), "--frames", "5")
        for scene in ("hanging", path, weft.load_scene("hanging")):
            summary = weft.World(scene).run(5)
            self.assertEqual(summary.state_hash, there["state_hash"])
            self.assertEqual(summary.totals["max_stretch"], there["max_stretch"])
            self.assertEqual(summary.frames, 5)
            self.assertAlmostEqual(summary.simulated_s, 5 * scenes.FRAME)

    def test_changes_are_those_of_set(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "sheet.json"
            path.write_text(json.dumps(scenes.sheet()))
            there = scenes.command_line(str(path), "--frames", "3", "--set", "cloths.0.grid=[9,7]")
        world = weft.World(scenes.sheet(), changes={"cloths.0.grid": np.array([9, 7])})
        self.assertEqual(world.nodes, 63)
        self.assertEqual(world.run(3).state_hash, there["state_hash"])

    def test_a_reset_world_runs_again_in_the_same_bits(self) -> None:
        world = scenes.world()
        first = world.run(4).state_hash
        world.reset()
        self.assertEqual(world.frame, 0)
        self.assertEqual(world.run(4).state_hash, first)


class Arrays(unittest.TestCase):
    def test_a_free_sheet_falls_as_far_as_bodies_fall(self) -> None:
        world = scenes.world(pins=[])
        start = world.positions
        world.step(6)
        fallen = (start - world.positions)[:, 1]
        # Semi-implicit Euler of step h is g t (t + h) / 2 down after t; positions are f32 below 2 m.
        t, h = world.time, world.description["step_seconds"]
        np.testing.assert_allclose(fallen, scenes.GRAVITY * t * (t + h) / 2, atol=2e-6)
        # Springs answer the rounding of positions, but by forces that cancel; each step rounds a speed below 1 m/s.
        rounding = t / h * 2**-24
        speed = world.velocities.mean(0, np.float64)
        np.testing.assert_allclose(speed, [0, -scenes.GRAVITY * t, 0], rtol=0, atol=rounding)

    def test_arrays_are_the_callers(self) -> None:
        world = scenes.world()
        positions = world.positions
        self.assertEqual((positions.shape, positions.dtype), ((144, 3), np.float32))
        kept = positions.copy()
        positions[:] = 7
        np.testing.assert_array_equal(world.positions, kept)
        out = np.empty((144, 3), np.float32)
        self.assertIs(world.read_positions(out), out)
        np.testing.assert_array_equal(out, kept)
        wrongs: list[Any] = [np.empty((143, 3), np.float32), np.empty((144, 3)), np.empty((3, 144), np.float32).T]
        for wrong in wrongs:
            with self.assertRaisesRegex(weft.ShapeError, r"wanted is a writeable float32 \(144, 3\) in C order\.$"):
                world.read_velocities(wrong)

    def test_another_library_takes_the_array_as_it_is(self) -> None:
        positions = scenes.world().positions
        self.assertTrue(np.shares_memory(np.from_dlpack(positions), positions))

    def test_triangles_number_nodes(self) -> None:
        world = scenes.world()
        self.assertEqual(world.triangles.shape, (2 * 11 * 11, 3))
        self.assertEqual(world.triangles.max(), 143)
        np.testing.assert_allclose(world.stretch, 1, rtol=1e-5)
        np.testing.assert_allclose(abs(world.normals), np.tile([0, 1, 0], (144, 1)), atol=1e-5)

    def test_a_mesh_of_arrays_is_cloth(self) -> None:
        scene = scenes.sheet()
        scene["cloths"] = [{"mesh": "square", "density": 0.2}]
        square = np.array([[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]])
        world = weft.World(scene, meshes={"square": (square, [[0, 1, 2], [0, 2, 3]])})
        np.testing.assert_array_equal(world.positions, square)
        with self.assertRaisesRegex(weft.InputError, "adding mesh square"):
            weft.World(scene, meshes={"square": (square, [[0, 1, 4]])})
        with self.assertRaisesRegex(weft.ShapeError, r'positions of mesh "square" have shape \(4, 2\)'):
            weft.World(scene, meshes={"square": (square[:, :2], [[0, 1, 2]])})


class Setting(unittest.TestCase):
    def test_positions_and_velocities_go_in_as_they_come_out(self) -> None:
        world = scenes.world(pins=[])
        world.change("gravity", [0, 0, 0])
        start = world.positions
        world.positions = start + [1, 2, 0]
        world.velocities = np.tile([0, 0, 3.0], (144, 1))
        world.step(6)
        np.testing.assert_allclose(world.positions, start + [1, 2, 3 * 0.1], atol=1e-5)
        world.positions += np.array([0, 0, 1], np.float32)
        np.testing.assert_allclose(world.positions[:, 2], start[:, 2] + 1.3, atol=1e-5)

    def test_impulses_are_momentum(self) -> None:
        world = scenes.world(pins=[])
        world.change("gravity", [0, 0, 0])
        mass = 0.2 / 11**2  # of a node in the middle [kg]; all of them weigh 0.2
        impulses = np.zeros((144, 3))
        impulses[5 * 12 + 5] = [0, 0.01, 0]
        world.push(impulses)
        np.testing.assert_allclose(world.velocities[5 * 12 + 5], [0, 0.01 / mass, 0], rtol=1e-5)

    def test_given_nodes_follow_arrays(self) -> None:
        world = scenes.world(pins=[], motions=[{"kind": "given", "nodes": "top", "speed": 2}])
        nodes = world.given_nodes
        np.testing.assert_array_equal(nodes, np.arange(12))
        places = world.positions[nodes]
        for frame in range(10):
            places += np.array([0, 0.02 * np.sin(frame), 0.01], np.float32)
            world.move(places)
            world.step()
            np.testing.assert_allclose(world.positions[nodes], places, rtol=0, atol=2e-7)
        world.move(places[3:5] + np.array([0, 0.03, 0], np.float32), nodes[3:5])
        world.step(2)
        lifted = world.positions[nodes] - places
        np.testing.assert_allclose(lifted[:, 1], np.where(np.isin(nodes, [3, 4]), 0.03, 0), atol=2e-7)
        with self.assertRaisesRegex(weft.InputError, r"at 6 m/s; its motion has a speed of 2 m/s\."):
            world.move(world.positions[nodes] + np.array([0.1, 0, 0], np.float32))
        with self.assertRaisesRegex(weft.InputError, "Node 50 is not one of the 12 that"):
            world.move([[0, 0, 0]], [50])
        with self.assertRaisesRegex(weft.ShapeError, r"The places have shape \(1, 3\); wanted is \(12, 3\)\."):
            world.move([[0, 0, 0]])

    def test_what_does_not_fit_is_refused(self) -> None:
        world = scenes.world()
        with self.assertRaisesRegex(weft.ShapeError, r"The velocities have shape \(143, 3\); wanted is \(144, 3\)\."):
            world.velocities = np.zeros((143, 3))
        with self.assertRaisesRegex(weft.InputError, "Node 0 is pinned or moved, and stays at"):
            world.positions = world.positions + [0, 1, 0]
        with self.assertRaisesRegex(weft.InputError, "Number 3 of the impulses is not finite"):
            world.push(np.where(np.arange(144)[:, None] == 3, np.inf, np.zeros((144, 3))))


class Colliders(unittest.TestCase):
    FRAME = 1 / 64  # s, so that times are exact

    def scene(self, motion: dict[str, Any]) -> dict[str, Any]:
        scene = scenes.sheet(damping=0.005, stiffness={"structural": 40, "shear": 10, "bend": 0.3})
        scene["time"] = {"frame": self.FRAME, "substeps": 8}  # which are enough for a soft sheet
        scene["contact"] = {"method": "proximity"}
        scene["colliders"] = [{"kind": "sphere", "center": [0, -0.25, 0], "radius": 0.2, "motion": motion}]
        return scene

    def test_a_carried_ball_has_the_bits_of_the_same_path_of_its_scene(self) -> None:
        points = [[0.125, [0, 0.1875, 0]], [1, [0, 1.5, 0]]]
        there = weft.World(self.scene({"kind": "path", "points": points})).run(8)
        for by_matrix in (False, True):
            world = weft.World(self.scene({"kind": "given", "speed": 1.5}))
            self.assertEqual(world.given_colliders, [0])
            for frame in range(1, 9):
                place = [0, 1.5 * frame * self.FRAME, 0]
                matrix = np.eye(4)
                matrix[:3, 3] = place
                if by_matrix:
                    world.set_collider(0, matrix=matrix)
                else:
                    world.set_collider(0, place)
                world.step()
            self.assertEqual(world.run(0).state_hash, there.state_hash)

    def test_what_cannot_be_is_refused(self) -> None:
        world = weft.World(self.scene({"kind": "given", "speed": 1.5}))
        with self.assertRaisesRegex(weft.InputError, "Collider 0 would go up to 1 m in a frame, at 64 m/s; its motion"):
            world.set_collider(0, [0, 1, 0])
        with self.assertRaisesRegex(weft.InputError, "Collider 3 is not one of the 1 that"):
            world.set_collider(3)
        with self.assertRaisesRegex(weft.InputError, "Collider -1 is not one of"):
            world.set_collider(-1)
        with self.assertRaisesRegex(weft.InputError, "The rotation has length 2; a unit quaternion's is within 0.001"):
            world.set_collider(0, rotation=[0, 0, 0, 2])
        with self.assertRaisesRegex(weft.ShapeError, r"The rotation has shape \(3,\); wanted is \(4,\)."):
            world.set_collider(0, rotation=[0, 0, 1])
        with self.assertRaisesRegex(weft.InputError, "Column 0 of the matrix has length 2; a placement does not scale"):
            world.set_collider(0, matrix=np.diag([2, 1, 1, 1]))
        with self.assertRaisesRegex(weft.ShapeError, r"The matrix has shape \(3, 3\); wanted is \(4, 4\)."):
            world.set_collider(0, matrix=np.eye(3))


class Pictures(unittest.TestCase):
    def test_a_picture_shows_the_cloth_before_the_background(self) -> None:
        world = scenes.world()
        above = weft.Camera(eye=[0.5, 3, 0.5001], target=[0.5, 0, 0.5])
        centre = world.positions.mean(0)
        picture = world.render(64, 48, camera=weft.Camera(centre + [0, 3, 0.01], centre), legend=False)
        self.assertEqual((picture.shape, picture.dtype), ((48, 64, 4), np.uint8))
        self.assertTrue((picture[..., 3] == 255).all())
        self.assertTrue((picture[24, 32] != picture[0, 0]).any())
        self.assertEqual(weft.render(scenes.sheet(), width=32, height=16, camera=above).shape, (16, 32, 4))

    def test_a_ray_picks_a_node(self) -> None:
        world = scenes.world()
        node = 5 * 12 + 5
        place = world.positions[node]
        picked = world.pick(place + [0.001, 2, 0.001], [0, -1, 0])
        assert picked is not None
        self.assertEqual(picked.node, node)
        self.assertAlmostEqual(picked.distance, 2, places=5)
        self.assertIsNone(world.pick([9, 9, 9], [0, 1, 0]))

    def test_the_shape_is_a_file(self) -> None:
        world = scenes.world()
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "shape.obj"
            world.save(path)
            vertices = [line.split()[1:] for line in path.read_text().splitlines() if line.startswith("v ")]
            np.testing.assert_allclose(np.array(vertices, float), world.positions, atol=1e-6)
            world.save(path.with_suffix(".png"))
            file = path.with_suffix(".png").read_bytes()
        picture = world.render()
        self.assertEqual(struct.unpack(">II", file[16:24]), (picture.shape[1], picture.shape[0]))
        rows = np.frombuffer(zlib.decompress(file[41:-16]), np.uint8).reshape(picture.shape[0], -1)
        np.testing.assert_array_equal(rows[:, 1:].reshape(picture.shape), picture)


class Running(unittest.TestCase):
    def test_changes_and_hands_act_from_the_next_frame_on(self) -> None:
        world = scenes.world(pins=[])
        world.change("gravity", [0, 0, 0])
        before = world.positions
        world.step(3)
        np.testing.assert_allclose(world.positions, before, atol=1e-6)
        world.grab(77, before[77] + [0, 0.1, 0])
        world.drag(77, before[77] + [0, 0.2, 0])
        world.step(10)
        self.assertGreater(world.positions[77, 1], before[77, 1] + 0.1)
        world.release(77)
        with self.assertRaises(weft.InputError):
            world.release(77)

    def test_other_threads_run_while_a_world_waits(self) -> None:
        world = scenes.world(side=96)
        world.run(1)
        stamps: list[float] = []
        done = threading.Event()

        def count() -> None:
            while not done.is_set():
                stamps.append(time.monotonic())
                time.sleep(0.001)

        thread = threading.Thread(target=count)
        thread.start()
        world.step(3)
        start = time.monotonic()
        world.finish()
        end = time.monotonic()
        done.set()
        thread.join()
        # A thread that had to wait for the world would have no stamp between its quarters.
        quarter = (end - start) / 4
        self.assertGreater(sum(start + quarter < stamp < end - quarter for stamp in stamps), 0)

    def test_two_threads_take_turns_at_a_world(self) -> None:
        world = scenes.world()
        threads = [threading.Thread(target=world.run, args=(4,)) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        alone = scenes.world()
        self.assertEqual(world.state_hash(), alone.run(8).state_hash)

    def test_an_interrupt_ends_a_run_between_two_frames(self) -> None:
        code = """
import sys, weft, scenes
world = scenes.world()
print("ready", flush=True)
try:
    world.run(1000000)
except KeyboardInterrupt:
    print(world.frame, world.run(1).frames)
"""
        child = scenes.python(code, PYTHONPATH=str(pathlib.Path(__file__).parent))
        assert child.stdout is not None
        self.assertEqual(child.stdout.readline(), "ready\n")
        time.sleep(0.5)
        child.send_signal(signal.SIGINT)
        said, wrong = child.communicate(timeout=60)
        self.assertEqual((child.returncode, wrong), (0, ""))
        frame, next_frame = map(int, said.split())
        self.assertEqual(next_frame, frame + 1)


if __name__ == "__main__":
    unittest.main()
