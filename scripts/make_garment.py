#!/usr/bin/env python3
"""Makes a garment, cut and sewn from a front and a back, as an OBJ file in metres.

usage: scripts/make_garment.py dress|shirt|tunic FILE [--vertices N] [--seed N] [--slivers N] [--panels]

  --vertices N  about how many (5000)
  --seed N      of the irregular mesh; the same numbers give the same bytes (1)
  --slivers N   how many long edges the hem has in front and at the back, as far as there is room, each with a fan of
                triangles down to an aspect of 100, of a tunic 250 (4)
  --panels      the flat front and back instead, FILE-front.obj and FILE-back.obj, and FILE.json, a scene that lays them
                about the mannequin and sews them on (a tunic fits her)

The panels are flat triangulations of jittered points, Delaunay but for the fans, a little bulged, and welded at their
seams. Neck, hem and sleeves are open, a dress is open at its top, and a tunic has armholes for sleeves.
"""

import argparse
import json
import math
import pathlib
import random
from typing import NamedTuple

BULGE, BULGE_WIDTH = 0.02, 0.06  # m: how far apart from the middle a panel is, and how far from its seams on
JITTER = 0.35  # of the spacing, each way
HEM = 0.5  # height of the row of fans, of the spacing
FAN = 6  # short edges to a long one: the thinnest triangle has an aspect of FAN^2 / HEM, 72 in the flat


class Cut(NamedTuple):
    """Half of a symmetric outline, lengths in m; a dress has no sleeves, and its neck is all of its top."""

    half_width: float
    height: float
    neck_half_width: float
    neck_depth: float
    sleeve_length: float
    sleeve_width: float  # of an armhole, without sleeves
    flare: float  # of the hem's width over the top's, less 1


CUTS = {
    "dress": Cut(0.22, 0.9, 0.22, 0, 0, 0, 0.5),
    "shirt": Cut(0.25, 0.68, 0.1, 0.06, 0.2, 0.2, 0),
    "tunic": Cut(0.165, 0.85, 0.085, 0.07, 0, 0.25, 0.9),
}


class Outline:
    """The cut in cells of a grid, its lower left corner at (0, 0)."""

    def __init__(self, cut, spacing):
        def cells(length):
            return round(length / spacing)

        self.cut, self.spacing = cut, spacing
        self.sleeve, self.body, self.height = cells(cut.sleeve_length), 2 * cells(cut.half_width), cells(cut.height)
        self.width = self.body + 2 * self.sleeve
        self.arm = self.height - cells(cut.sleeve_width)  # where sleeves begin
        self.neck, self.neck_bottom = cells(cut.neck_half_width), self.height - cells(cut.neck_depth)

    def has_cell(self, i, j):
        if not (0 <= i < self.width and 0 <= j < self.height):
            return False
        if not self.sleeve <= i < self.width - self.sleeve and j < self.arm:
            return False
        return not (abs(2 * i + 1 - self.width) < 2 * self.neck and j >= self.neck_bottom)

    def is_open(self, a, b):
        """Of an edge of the outline: hem, end of a sleeve, neck."""
        (i, j), (k, m) = a, b
        at_end = i == k and i in (0, self.width) and min(j, m) >= self.arm
        in_neck = all(abs(2 * n - self.width) <= 2 * self.neck for n in (i, k)) and min(j, m) >= self.neck_bottom
        return j == m == 0 or at_end or in_neck

    def rim(self):
        for i in range(self.width + 1):
            for j in range(self.height + 1):
                if self.has_cell(i, j) != self.has_cell(i - 1, j):
                    yield (i, j), (i, j + 1)
                if self.has_cell(i, j) != self.has_cell(i, j - 1):
                    yield (i, j), (i + 1, j)

    def sewn(self):
        return {point for edge in self.rim() if not self.is_open(*edge) for point in edge}

    def points(self):
        corners = ((0, 0), (1, 0), (0, 1), (1, 1))
        cells = ((i, j) for i in range(self.width) for j in range(self.height) if self.has_cell(i, j))
        return sorted({(i + k, j + m) for i, j in cells for k, m in corners})


def turn(a, b, c):
    """Twice the area of a triangle, positive if it turns to the left."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def in_circle(a, b, c, d):
    rows = [(p[0] - d[0], p[1] - d[1], (p[0] - d[0]) ** 2 + (p[1] - d[1]) ** 2) for p in (a, b, c)]
    (ax, ay, aa), (bx, by, bb), (cx, cy, cc) = rows
    return ax * (by * cc - bb * cy) - ay * (bx * cc - bb * cx) + aa * (bx * cy - by * cx) > 1e-9


def flip_to_delaunay(triangles, place):
    """Lawson's flips, over all inner edges until none is left to do."""
    opposite = {}
    for a, b, c in triangles:
        opposite[a, b], opposite[b, c], opposite[c, a] = c, a, b
    waiting = sorted(opposite)
    while waiting:
        a, b = waiting.pop()
        if (a, b) not in opposite or (b, a) not in opposite:
            continue
        c, d = opposite[a, b], opposite[b, a]
        if not in_circle(place[a], place[b], place[c], place[d]):
            continue
        if turn(place[a], place[d], place[c]) <= 0 or turn(place[d], place[b], place[c]) <= 0:
            continue
        del opposite[a, b], opposite[b, a]
        for p, q, r in ((a, d, c), (d, b, c)):
            opposite[p, q], opposite[q, r], opposite[r, p] = r, p, q
        waiting += [(a, d), (d, b), (b, c), (c, a)]
    return sorted({min((a, b, c), (b, c, a), (c, a, b)) for (a, b), c in opposite.items()})


def hem_corners(outline, slivers, rng):
    """The points of the grid that the hem keeps. One edge at least is short: the front's hem is never the back's."""
    first, last = outline.sleeve, outline.width - outline.sleeve
    count = min(slivers, (last - first - 1) // FAN)
    steps = [FAN] * count + [1] * (last - first - FAN * count)
    rng.shuffle(steps)
    corners = [first]
    for step in steps:
        corners.append(corners[-1] + step)
    return corners


def panel(outline, slivers, rng):
    """Points of the grid by their places, and triangles of them that face +z."""
    rim = {point for edge in outline.rim() for point in edge}
    place = {}
    for i, j in outline.points():
        inner = (i, j) not in rim
        place[i, j] = (i + inner * rng.uniform(-JITTER, JITTER), j + inner * rng.uniform(-JITTER, JITTER))
    for i in range(outline.width + 1):  # a straight row above the fans, so that they are thin everywhere
        if (i, 1) in place:
            place[i, 1] = (place[i, 1][0], HEM)
    triangles = []
    for i in range(outline.width):
        for j in range(1, outline.height):
            if outline.has_cell(i, j):
                a, b, c, d = (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)
                triangles += [(a, b, c), (a, c, d)] if rng.random() < 0.5 else [(a, b, d), (b, c, d)]
    triangles = flip_to_delaunay(triangles, place)
    corners = hem_corners(outline, slivers, rng)
    for left, right in zip(corners, corners[1:], strict=False):
        peak = rng.choice((left, right))  # all points see one end, and the end of the row sees both
        triangles.append(((left, 0), (right, 0), (left + right - peak, 1)))
        triangles += [((peak, 0), (i + 1, 1), (i, 1)) for i in range(left, right)]
    return place, triangles


def outline_of(kind, vertices):
    cut = CUTS[kind]
    body = 2 * cut.half_width * cut.height + 2 * cut.sleeve_length * cut.sleeve_width
    outline = Outline(cut, math.sqrt(2 * (body - 2 * cut.neck_half_width * cut.neck_depth) / vertices))
    arm = outline.height - outline.arm if cut.sleeve_width else 2
    if min(arm, outline.body) < 2 or outline.height < 3:
        raise ValueError(f"{vertices} vertices are too few for a {kind}.")
    return outline


def worn(outline, cut, x, y):
    """Where a point of the grid is, from the middle of the top [m]."""
    wide = 1 + cut.flare * (1 - y / outline.height)
    return (x - 0.5 * outline.width) * outline.spacing * wide, (y - outline.height) * outline.spacing


def garment(kind, vertices=5000, seed=1, slivers=4):
    """Positions [m] and triangles (numbers from 0) that face outward."""
    cut = CUTS[kind]
    outline = outline_of(kind, vertices)
    rng = random.Random(seed)
    sewn = outline.sewn()
    near = math.ceil(BULGE_WIDTH / outline.spacing)
    positions, triangles, number = [], [], {}
    for side in (1, -1):
        place, faces = panel(outline, slivers, rng)
        for point in sorted({point for face in faces for point in face}):
            if point in sewn and side == -1:
                continue  # the front has it
            x, y = place[point]
            close = [math.dist((x, y), seam) for seam in sewn if abs(seam[0] - x) <= near and abs(seam[1] - y) <= near]
            part = min(1.0, outline.spacing * min(close, default=near + 1) / BULGE_WIDTH)
            z = side * BULGE * math.sqrt(part * (2 - part))
            number[side, point] = len(positions)
            if point in sewn:
                number[-side, point] = len(positions)
            positions.append((*worn(outline, cut, x, y), z))
        for face in faces:
            triangles.append(tuple(number[side, point] for point in face[::side]))
    return positions, triangles


def seam_runs(outline):
    """The points of each seam, along it."""
    beside = {}
    for edge in outline.rim():
        if not outline.is_open(*edge):
            for a, b in (edge, edge[::-1]):
                beside.setdefault(a, []).append(b)
    runs, seen = [], set()
    for end in sorted(point for point, others in beside.items() if len(others) == 1):
        if end in seen:
            continue
        run = [end]
        while following := [point for point in beside[run[-1]] if point not in run[-2:]]:
            run += following
        seen.update(run)
        runs.append(run)
    return runs


def flat_panels(kind, vertices=5000, seed=1, slivers=4):
    """Of the front and the back their positions [m], triangles that face outward, and the numbers along each seam."""
    cut = CUTS[kind]
    outline = outline_of(kind, vertices)
    rng = random.Random(seed)
    made = []
    for side in (1, -1):
        place, faces = panel(outline, slivers, rng)
        points = sorted({point for face in faces for point in face})
        number = {point: k for k, point in enumerate(points)}
        positions = [(*worn(outline, cut, *place[point]), 0.0) for point in points]
        triangles = [tuple(number[point] for point in face[::side]) for face in faces]
        made.append((positions, triangles, [[number[point] for point in run] for run in seam_runs(outline)]))
    return made


TOP, AWAY, CHEST, HELD = 1.46, 0.16, (0.08, -0.18), 1.8  # m, m, m from the top's middle, s


def sewn_scene(panels, files):
    """Hands hold the panels beside the mannequin until they are sewn."""
    rows = [[{"panel": p, "nodes": {"nodes": run}} for run in runs] for p, (_, _, runs) in enumerate(panels)]
    grabs, first = [], 0
    for side, (positions, _, _) in zip((1, -1), panels, strict=True):
        for x in (-CHEST[0], CHEST[0]):
            near = [math.dist((x, CHEST[1]), place[:2]) for place in positions]
            node = near.index(min(near))
            point = [round(positions[node][0], 4), round(TOP + positions[node][1], 4), side * AWAY]
            path = [{"time": 0, "point": point}, {"time": HELD, "point": [*point[:2], side * 0.125]}]
            grabs.append({"node": {"nodes": [first + node]}, "end": HELD, "path": path})
        first += len(positions)
    return {
        "format": "weft-scene/1",
        "title": "A tunic that is sewn on",
        "description": "A front and a back are laid about a person, sewn on, and let go",
        "time": {"frames": 240},
        "solver": {"kind": "multigrid"},
        "contact": {"method": "proximity", "thickness": 0.004},
        "cloths": [
            {
                "panels": [
                    {"mesh": file, "transform": {"translate": [0, TOP, side * AWAY]}}
                    for side, file in zip((1, -1), files, strict=True)
                ],
                "seams": [{"first": a, "second": b} for a, b in zip(*rows, strict=True)],
                "density": 0.15,
                "stiffness": {"structural": 1000, "shear": 300, "bend": 10},
                "damping": 0.05,
                "grabs": grabs,
                "color": [0.75, 0.2, 0.16],
            }
        ],
        "colliders": [
            {"kind": "mesh", "mesh": "mannequin", "friction": 0.3},
            {"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]},
        ],
        "camera": {"eye": [1.5, 1.5, 2.4], "target": [0, 0.95, 0], "fov_degrees": 36},
    }


def obj_of(positions, triangles, title):
    lines = [f"# {title}: scripts/make_garment.py of weft"]
    lines += [f"v {x:.7f} {y:.7f} {z:.7f}" for x, y, z in positions]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in triangles]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n")[0])
    parser.add_argument("kind", choices=sorted(CUTS))
    parser.add_argument("file", type=pathlib.Path)
    parser.add_argument("--vertices", type=int, default=5000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--slivers", type=int, default=4)
    parser.add_argument("--panels", action="store_true")
    given = parser.parse_args()
    title = f"{given.kind}, {given.vertices} vertices, seed {given.seed}, {given.slivers} slivers"
    try:
        if given.panels:
            panels = flat_panels(given.kind, given.vertices, given.seed, given.slivers)
            files = [given.file.with_name(f"{given.file.stem}-{name}.obj") for name in ("front", "back")]
            for file, (positions, triangles, _) in zip(files, panels, strict=True):
                file.write_text(obj_of(positions, triangles, title), "utf-8")
            scene = json.dumps(sewn_scene(panels, [file.name for file in files]), indent=1)
            given.file.with_suffix(".json").write_text(scene + "\n", "utf-8")
            return
        made = garment(given.kind, given.vertices, given.seed, given.slivers)
    except ValueError as error:
        parser.error(str(error))
    given.file.write_text(obj_of(*made, title), "utf-8")


if __name__ == "__main__":
    main()
