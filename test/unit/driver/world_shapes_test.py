import os
import tempfile
import unittest

import numpy as np

from driver import world_shapes
from driver.world_file import WorldFileError

_WORLDS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..",
                       "..", "worlds")


class WorldShapesTest(unittest.TestCase):

    def read(self, text, name="w.yaml"):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, name)
            with open(file, "w") as stream:
                stream.write(text)
            return world_shapes.read(file)

    def test_what_stands(self):
        shapes = self.read("version: 1\n"
                           "walls: [{points: [[0, 0], [4, 0]], thickness: 0.2}]\n"
                           "boxes: [{pose: [1, 2, 0], size: [2, 1]}]\n"
                           "cylinders: [{position: [5, 5], radius: 0.5}]\n"
                           "polygons: [{outline: [[0, 0], [1, 0], [0, 1]]}]\n")
        wall, box, cylinder, polygon = shapes.standing
        for outline, low, high in (
                (wall, (-0.1, -0.1), (4.1, 0.1)), (box, (0, 1.5), (2, 2.5)),
                (cylinder, (4.5, 4.5), (5.5, 5.5)), (polygon, (0, 0), (1, 1))):
            np.testing.assert_allclose(outline.min(axis=0), low)
            np.testing.assert_allclose(outline.max(axis=0), high)
            np.testing.assert_allclose(outline[0], outline[-1], atol=1e-9)
        self.assertFalse(shapes.appearing)

    def test_a_box_turns(self):
        box, = self.read("version: 1\nboxes: [{pose: [0, 0, 1.5707963], "
                         "size: [2, 1]}]\n").standing
        np.testing.assert_allclose(box.max(axis=0), (0.5, 1.0), atol=1e-6)

    def test_a_closed_wall_has_as_many_sides_as_corners(self):
        shapes = self.read("version: 1\nwalls: [{closed: true, points: "
                           "[[0, 0], [4, 0], [4, 3]]}]\n")
        self.assertEqual(len(shapes.standing), 3)

    def test_what_moves(self):
        shapes = self.read(
            "version: 1\nmovers:\n"
            "  - {shape: {cylinder: {radius: 0.3}}, speed: 1, "
            "waypoints: [[1, 1], [2, 1]]}\n"
            "  - {shape: {box: {size: [1, 1]}}, "
            "keyframes: [[0, 5, 5], [1, 6, 5]]}\n")
        self.assertEqual(len(shapes.appearing), 2)
        np.testing.assert_allclose(shapes.ways[0], [(1, 1), (2, 1)])
        np.testing.assert_allclose(shapes.ways[1], [(5, 5), (6, 5)])

    def test_the_packages_own_worlds(self):
        for name in sorted(os.listdir(_WORLDS)):
            with self.subTest(name):
                self.assertTrue(world_shapes.read(
                    os.path.join(_WORLDS, name)).standing)

    def test_other_formats_have_none(self):
        self.assertFalse(self.read("<sdf/>", "w.world").standing)
        self.assertFalse(self.read("image: m.pgm\n").standing)
        with self.assertRaises(WorldFileError):
            self.read("a: [")


if __name__ == "__main__":
    unittest.main()
