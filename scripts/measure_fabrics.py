#!/usr/bin/env python3
"""Measures the fabrics that weft knows by name as a textile laboratory does, and writes docs/fabrics.md's tables.

usage: scripts/measure_fabrics.py [--weft PROGRAM] [--rings N] [--seeds N] [--only NAME,...] [--jobs N]
       scripts/measure_fabrics.py --docs [--weft PROGRAM]

  --weft PROGRAM  the program to measure with (build/weft)
  --rings N       of nodes from the middle of a sheet for Cusick's test to its rim (30)
  --seeds N       sheets of different irregular triangles to take the mean of (3)
  --only NAME,... only these fabrics; all others keep what bench/fabrics.json has of them
  --jobs N        how many runs at a time (1)
  --docs          measures nothing: writes the tables from bench/fabrics.json and `weft fabrics`

Bending length (ASTM D1388, cantilever): a strip 25 mm wide is pushed over an edge until the line from the edge to its
tip is 41.5 degrees below the horizontal. Half of what hangs over is the bending length; B is its cube by the weight.
Drape coefficient (Cusick; BS 5058): a sheet of 30 cm lies on a disc of 18 cm, held flat there. The coefficient is the
part of the overhanging ring that its shadow covers.
Both are run by implicit steps with drag until they are at rest. Results: bench/fabrics.json.
"""

import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import random
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
RESULTS = "bench/fabrics.json"
DOCS = "docs/fabrics.md"
GRAVITY = 9.81  # m/s^2
ANGLE = math.radians(41.5)
STRIP_WIDTH, STRIP_CELLS = 0.025, 4  # m, across
SHEET, DISC = 0.15, 0.09  # m, radii
JITTER = 0.25  # of the distance of rings: where nodes of the overhang are, off an even ring
PIXEL = 0.0005  # m, of the shadow


def run(weft, scene, folder):
    """The summary of a run, and the places of its nodes and its triangles at the end."""
    path = pathlib.Path(folder) / "scene.json"
    path.write_text(json.dumps(scene), "utf-8")
    out = pathlib.Path(folder) / "out"
    quiet = {**os.environ, "PATH": ""}  # no video
    done = subprocess.run([weft, "run", path, "--out", out, "--json"], capture_output=True, text=True, env=quiet)
    if done.returncode != 0:
        raise SystemExit(f"measure_fabrics: weft run ended with {done.returncode}: {done.stderr.strip()}")
    nodes, triangles = [], []
    for line in (out / "final.obj").read_text("utf-8").splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            nodes.append(tuple(float(word) for word in words[1:4]))
        elif words[:1] == ["f"]:
            triangles.append(tuple(int(word.split("/")[0]) - 1 for word in words[1:4]))
    return json.loads(done.stdout), nodes, triangles


def scene_of(cloth, frames, drag, substeps):
    return {
        "format": "weft-scene/1",
        "drag": drag,
        "time": {"frames": frames, "substeps": substeps},
        "solver": {"kind": "multigrid"},
        "contact": {"method": "none"},
        "render": {"size": [16, 16]},
        "cloths": [cloth],
    }


def strip_angle(weft, fabric, axis, overhang):
    """How far below the horizontal the tip of a strip is that hangs over by so much [rad]."""
    cells = 24
    cell = overhang / cells
    held = 2 * cell  # two rows of nodes and their cells between: clamped level
    length = overhang + held
    along, across = (cells + 2) + 1, STRIP_CELLS + 1
    grid, size = ([along, across], [length, STRIP_WIDTH])
    low, high = [-length / 2 - cell / 2, -1, -1], [-length / 2 + held + cell / 2, 1, 1]
    if axis == "weft":
        grid, size = grid[::-1], size[::-1]
        low, high = low[::-1], high[::-1]
    cloth = {"grid": grid, "size": size, "plane": "xz", "fabric": fabric, "pins": [{"box": {"min": low, "max": high}}]}
    with tempfile.TemporaryDirectory() as folder:
        _, nodes, _ = run(weft, scene_of(cloth, 240, 2 * math.sqrt(GRAVITY / overhang), 1), folder)
    k = 0 if axis == "warp" else 2
    tip = max(range(len(nodes)), key=lambda n: n % grid[0] if axis == "warp" else n // grid[0])
    reach = nodes[tip][k] - (-length / 2 + held)
    return math.atan2(-nodes[tip][1], reach)


def bending_length(weft, fabric, axis, guess):
    """Half of the overhang at which the tip stands at 41.5 degrees [m], by the secants of angle over length."""
    a, b = 2 * guess, 2.05 * guess
    at_a, at_b = strip_angle(weft, fabric, axis, a), strip_angle(weft, fabric, axis, b)
    for _ in range(4):
        a, b, at_a = b, b + (ANGLE - at_b) * (b - a) / (at_b - at_a), at_b
        at_b = strip_angle(weft, fabric, axis, b)
        if abs(at_b - ANGLE) < math.radians(0.1):  # 0.13 % of the length
            return b / 2
    raise SystemExit(f"measure_fabrics: {fabric} along the {axis}: no overhang was found that hangs at 41.5 degrees.")


def disc(rings, seed):
    """A round sheet of rings of 6 k nodes. Those of the overhang are put off it, so that no fold is prepared."""
    rng = random.Random(seed)
    spacing = SHEET / rings
    held = round(DISC / spacing)
    nodes, first = [(0.0, 0.0)], [0]
    for k in range(1, rings + 1):
        first.append(len(nodes))
        for j in range(6 * k):
            radius, turn = k * spacing, 2 * math.pi * j / (6 * k)
            if held < k < rings:
                radius += spacing * JITTER * rng.uniform(-1, 1)
                turn += JITTER * rng.uniform(-1, 1) * spacing / radius
            nodes.append((radius * math.cos(turn), radius * math.sin(turn)))
    triangles = []
    for k in range(1, rings + 1):
        inner, outer = 6 * (k - 1), 6 * k
        for side in range(6):
            for j in range(k):
                out = first[k] + side * k + j
                after = first[k] + (side * k + j + 1) % outer
                inside = first[k - 1] + ((side * (k - 1) + j) % inner if inner else 0)
                triangles.append((out, inside, after))
                if j + 1 < k:
                    triangles.append((inside, first[k - 1] + (side * (k - 1) + j + 1) % inner, after))
    return nodes, triangles, held * spacing


def shadow(nodes, triangles):
    """The area that triangles cover as seen from above [m^2], in pixels."""
    side = 2 * math.ceil(1.2 * SHEET / PIXEL)
    rows = [bytearray(side) for _ in range(side)]
    for triangle in triangles:
        corners = [(nodes[n][0] / PIXEL + side / 2, nodes[n][2] / PIXEL + side / 2) for n in triangle]
        low, high = min(c[1] for c in corners), max(c[1] for c in corners)
        for y in range(math.ceil(low - 0.5), math.floor(high - 0.5) + 1):
            crossings = []
            for (xa, ya), (xb, yb) in zip(corners, corners[1:] + corners[:1]):
                if (ya <= y + 0.5) != (yb <= y + 0.5):
                    crossings.append(xa + (y + 0.5 - ya) * (xb - xa) / (yb - ya))
            if len(crossings) == 2:
                begin, end = math.ceil(min(crossings) - 0.5), math.floor(max(crossings) - 0.5) + 1
                if end > begin:
                    rows[y][begin:end] = b"\1" * (end - begin)
    return sum(sum(row) for row in rows) * PIXEL * PIXEL


def folds(nodes, rings):
    """How many waves the rim has: how often it rises through its mean height."""
    rim = [place[1] for place in nodes[-6 * rings :]]
    mean = sum(rim) / len(rim)
    return sum(1 for before, after in zip(rim, rim[1:] + rim[:1]) if before < mean <= after)


def drape(weft, fabric, rings, seed, frames=200, drag=3, substeps=1):
    """Cusick's drape coefficient [%], and the folds of the rim."""
    nodes, triangles, held = disc(rings, seed)
    lines = [f"v {x!r} 0 {z!r}" for x, z in nodes] + ["f " + " ".join(str(n + 1) for n in t) for t in triangles]
    cloth = {
        "mesh": "sheet.obj",
        "fabric": {"name": fabric, "warp_direction": [1, 0, 0]},
        "pins": [{"near": {"point": [0, 0, 0], "radius": held + 0.1 * SHEET / rings}}],
    }
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "sheet.obj").write_text("\n".join(lines) + "\n", "utf-8")
        summary, hung, triangles = run(weft, scene_of(cloth, frames, drag, substeps), folder)
    inner = math.pi * held * held
    covered = (shadow(hung, triangles) - inner) / (math.pi * SHEET * SHEET - inner)
    return {"percent": 100 * covered, "folds": folds(hung, rings), "adapter": summary["adapter"]}


def mean_and_range(values):
    return {"mean": sum(values) / len(values), "least": min(values), "most": max(values)}


def measure(weft, fabric, rings, seeds):
    density = fabric["density"]["value"]
    lengths = {}
    for axis in ("warp", "weft"):
        stiffness = fabric["bending_" + axis]["value"]
        peirce = (stiffness / (density * GRAVITY)) ** (1 / 3)
        lengths[axis] = {"measured": bending_length(weft, fabric["name"], axis, peirce), "from_b": peirce}
    drapes = [drape(weft, fabric["name"], rings, seed) for seed in range(1, seeds + 1)]
    return {
        "bending_length_m": lengths,
        "drape_percent": mean_and_range([one["percent"] for one in drapes]),
        "folds": mean_and_range([one["folds"] for one in drapes]),
        "rings": rings,
        "seeds": seeds,
        "adapter": drapes[0]["adapter"],
    }


def table_of(weft):
    return json.loads(subprocess.run([weft, "fabrics", "--json"], capture_output=True, text=True, check=True).stdout)


def number(cited, scale, digits):
    text = format(float(format(cited["value"] * scale, f".{digits}g")), "g")  # 2030, not 2.03e+03
    return text + "?" if cited["guess"] else text


def named_numbers(fabrics):
    lines = [
        "| fabric | what | g/m² | E warp | E weft | G | ν | B warp | B weft | twist | source |",
        "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---|",
    ]
    for f in fabrics:
        cells = [
            number(f[key], scale, 3)
            for key, scale in (
                ("density", 1e3),
                ("warp", 1),
                ("weft", 1),
                ("shear", 1),
                ("poisson", 1),
                ("bending_warp", 1e6),
                ("bending_weft", 1e6),
                ("bending_twist", 1e6),
            )
        ]
        lines.append(f"| `{f['name']}` | {f['what']} | {' | '.join(cells)} | {f['density']['source']} |")
    return lines


def measured_numbers(fabrics, measured):
    lines = [
        "| fabric | c warp, mm | by B | c weft, mm | by B | drape, % | of the sheets | folds | literature, % |",
        "|---|---:|---:|---:|---:|---:|---|---:|---|",
    ]
    for f in fabrics:
        m = measured.get(f["name"])
        if not m:
            continue
        c = [
            f"{1e3 * m['bending_length_m'][axis][key]:.1f}"
            for axis in ("warp", "weft")
            for key in ("measured", "from_b")
        ]
        d, literature = m["drape_percent"], f.get("drape_coefficient")
        said = "–"
        if literature:
            low, high = literature["least"], literature["most"]
            said = f"{low:g}" if low == high else f"{low:g}–{high:g}"
            said += f" ({literature['source']})"
        sheets = f"{d['least']:.0f}–{d['most']:.0f}" if m["seeds"] > 1 else "one"
        lines.append(
            f"| `{f['name']}` | {' | '.join(c)} | {d['mean']:.0f} | {sheets} | {m['folds']['mean']:.1f} | {said} |"
        )
    return lines


def notes(fabrics):
    return [f"- `{f['name']}` ({f['published_as']})" + (f": {f['note']}" if "note" in f else "") for f in fabrics]


def sources(table):
    return [f"- **{name}**: {citation}" for name, citation in table["sources"].items()]


def wrapped(lines):
    """List entries at most 120 columns wide."""
    out = []
    for line in lines:
        while len(line) > 120:
            cut = line.rfind(" ", 0, 121)
            out.append(line[:cut])
            line = "  " + line[cut + 1 :]
        out.append(line)
    return out


def made(docs, table, measured):
    """The page with its tables as these numbers make them."""
    parts = {
        "numbers": named_numbers(table["fabrics"]),
        "measured": measured_numbers(table["fabrics"], measured),
        "notes": wrapped(notes(table["fabrics"])),
        "sources": wrapped(sources(table)),
    }
    for name, lines in parts.items():
        before, found, rest = docs.partition(f"<!-- {name}: scripts/measure_fabrics.py --docs -->\n")
        _, end, after = rest.partition("<!-- end -->")
        if not found or not end:
            raise SystemExit(f"measure_fabrics: {DOCS} has no place for {name}.")
        docs = before + found + "\n".join(lines) + "\n" + end + after
    return docs


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--weft", default=str(ROOT / "build/weft"))
    parser.add_argument("--rings", type=int, default=30)
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--only", default="")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--docs", action="store_true")
    options = parser.parse_args()
    table = table_of(options.weft)
    results = ROOT / RESULTS
    measured = json.loads(results.read_text("utf-8")) if results.exists() else {}
    if not options.docs:
        wanted = [name for name in options.only.split(",") if name]
        fabrics = [f for f in table["fabrics"] if not wanted or f["name"] in wanted]
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            runs = {f["name"]: pool.submit(measure, options.weft, f, options.rings, options.seeds) for f in fabrics}
            for name, done in runs.items():
                measured[name] = done.result()
                print(name, json.dumps(measured[name]), flush=True)
                results.write_text(json.dumps(measured, indent=1) + "\n", "utf-8")
    page = ROOT / DOCS
    page.write_text(made(page.read_text("utf-8"), table, measured), "utf-8")


if __name__ == "__main__":
    main()
