"""The garments of scripts/make_garment.py are manifold, open where they should be, and as thin as they say."""

import collections
import math
import statistics
import unittest

from scripts.make_garment import flat_panels, garment, obj_of


def altitude_and_aspect(a, b, c):
    sides = [math.dist(a, b), math.dist(b, c), math.dist(c, a)]
    u, v = ([q - p for p, q in zip(a, end, strict=True)] for end in (b, c))
    area = math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    return area / max(sides), max(sides) ** 2 / area if area else math.inf


def rims(triangles):
    """The closed boundary loops; an edge of more than two triangles, or two that disagree, is an error."""
    edges = collections.Counter(edge for a, b, c in triangles for edge in ((a, b), (b, c), (c, a)))
    assert set(edges.values()) == {1}, "two triangles go along an edge the same way"
    after = {a: b for a, b in edges if (b, a) not in edges}
    assert len(after) == sum((b, a) not in edges for a, b in edges), "two rims meet in a vertex"
    loops = 0
    while after:
        loops += 1
        start = vertex = next(iter(after))
        while (vertex := after.pop(vertex)) != start:
            pass
    return loops


class Garments(unittest.TestCase):
    def test_a_garment_is_manifold_and_open_at_neck_hem_and_sleeves(self):
        for kind, openings in (("dress", 2), ("shirt", 4), ("tunic", 4)):
            for vertices, seed, slivers in ((5000, 1, 4), (2000, 2, 0), (900, 3, 9)):
                with self.subTest(kind=kind, vertices=vertices):
                    positions, triangles = garment(kind, vertices, seed, slivers)
                    self.assertLess(abs(len(positions) / vertices - 1), 0.1)
                    self.assertEqual({n for triangle in triangles for n in triangle}, set(range(len(positions))))
                    self.assertEqual(rims(triangles), openings)
                    edges = {frozenset(e) for a, b, c in triangles for e in ((a, b), (b, c), (c, a))}
                    # A sphere with so many holes: one piece, and no vertex where two fans meet.
                    self.assertEqual(len(positions) - len(edges) + len(triangles), 2 - openings)

    def test_slivers_are_as_thin_as_stated_and_all_else_is_not(self):
        for kind, thinnest in (("dress", 200), ("shirt", 200), ("tunic", 280)):  # by how much the hem is flared
            for slivers in (0, 4):
                with self.subTest(kind=kind, slivers=slivers):
                    positions, triangles = garment(kind, 5000, 1, slivers)
                    shapes = [altitude_and_aspect(*(positions[n] for n in triangle)) for triangle in triangles]
                    self.assertTrue(0.006 < statistics.median(low for low, _ in shapes) < 0.011)
                    thin = sum(aspect > 40 for _, aspect in shapes)
                    self.assertGreaterEqual(
                        thin, 2 * slivers
                    )  # of six in each fan, in front and at the back, two or more
                    self.assertLessEqual(thin, 10 * slivers)
                    if slivers:
                        self.assertTrue(80 < max(aspect for _, aspect in shapes) < thinnest)
                        self.assertTrue(0.0004 < min(low for low, _ in shapes) < 0.0015)

    def test_the_same_seed_gives_the_same_bytes_and_another_one_others(self):
        texts = [obj_of(*garment("shirt", 1000, seed), "shirt") for seed in (1, 1, 2)]
        self.assertEqual(texts[0], texts[1])
        self.assertNotEqual(texts[0], texts[2])

    def test_panels_are_flat_face_outward_and_fit_at_their_seams(self):
        for kind, seams in (("dress", 2), ("shirt", 4), ("tunic", 4)):
            with self.subTest(kind=kind):
                front, back = flat_panels(kind, 900)
                self.assertEqual(len(front[2]), seams)
                for (positions, triangles, _), side in ((front, 1), (back, -1)):
                    self.assertEqual(rims(triangles), 1)
                    self.assertEqual({z for _, _, z in positions}, {0})
                    for a, b, c in triangles:
                        (ax, ay, _), (bx, by, _), (cx, cy, _) = (positions[n] for n in (a, b, c))
                        self.assertGreater(side * ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)), 0)
                for own, other in zip(front[2], back[2], strict=True):
                    self.assertEqual([front[0][n] for n in own], [back[0][n] for n in other])
                sewn = {n for run in front[2] for n in run}
                whole, _ = garment(kind, 900)
                self.assertEqual(len(front[0]) + len(back[0]) - len(sewn), len(whole))

    def test_too_few_vertices_are_refused(self):
        with self.assertRaises(ValueError):
            garment("shirt", 20)


if __name__ == "__main__":
    unittest.main()
