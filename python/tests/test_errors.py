"""What fails is an exception of its kind, with a sentence that has the value and the limit."""

import pathlib
import unittest

import numpy as np
import scenes
import weft


class Errors(unittest.TestCase):
    def test_a_scene_that_is_wrong_says_where(self) -> None:
        with self.assertRaisesRegex(weft.InputError, r"cloths\[0\]\.density is -1"):
            weft.World(scenes.sheet(density=-1))
        with self.assertRaises(ValueError):
            weft.World(scenes.sheet(density=float("nan")))
        with self.assertRaisesRegex(weft.InputError, "cannot be written as JSON"):
            weft.World(scenes.sheet(density=object()))

    def test_a_name_that_is_not_shipped_says_which_are(self) -> None:
        with self.assertRaisesRegex(weft.InputError, 'no scene "hangin".*drag, .*hanging, '):
            weft.World("hangin")
        with self.assertRaisesRegex(weft.InputError, "nowhere.json cannot be read: No such file"):
            weft.World(pathlib.Path("nowhere.json"))

    def test_a_model_that_is_not_there_says_how_to_get_it(self) -> None:
        with self.assertRaisesRegex(weft.InputError, 'model "dragon" is not at /nowhere/dragon.ply; .*WEFT_MODELS'):
            weft.World("pull-dragon", models="/nowhere")

    def test_what_the_gpu_cannot_do(self) -> None:
        with self.assertRaisesRegex(weft.NoAdapterError, 'No adapter\'s name contains "no such"'):
            weft.World(scenes.sheet(), adapter="no such")
        with self.assertRaises(weft.LimitError):
            scenes.world().render(1000000, 10)

    def test_wrong_arguments_leave_the_world_as_it_was(self) -> None:
        world = scenes.world()
        before = world.run(1).state_hash
        for wrong in (
            lambda: world.step(-1),
            lambda: world.change("cloths.0.density", 3),
            lambda: world.grab(0, [0, 0, 0]),
            lambda: world.grab(144, [0, 0, 0]),
            lambda: world.grab(5, [0, np.nan, 0]),
            lambda: world.pick([0, 0, 0], [0, 0, 0]),
            lambda: world.render(0, 5),
            lambda: world.render(view="pretty"),
            lambda: world.mesh_file("fbx"),
        ):
            with self.assertRaises(weft.InputError):
                wrong()
        with self.assertRaisesRegex(weft.ShapeError, r"The target has shape \(2,\); wanted is \(3,\)\."):
            world.grab(5, [0, 0])
        self.assertEqual(world.state_hash(), before)

    def test_a_world_that_diverges_keeps_its_last_good_state(self) -> None:
        scene = scenes.sheet(stiffness={"structural": 1e8, "shear": 1e8, "bend": 1e8})
        world = weft.World(scene, changes={"time.substeps": 1})
        with self.assertRaisesRegex(weft.DivergedError, "nodes is not finite"):
            world.run(100)
        self.assertTrue(np.isfinite(world.positions).all())
        world.reset()
        self.assertEqual(world.frame, 0)


if __name__ == "__main__":
    unittest.main()
