#!/usr/bin/env python3
"""Writes the tables of docs/performance.md from bench/results/*.json.

Each table stands between <!-- table FILE --> or <!-- table FILE PART --> and <!-- end -->; the text around it is kept, and
so is a table whose results are not there.
"""
import json
import math
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/performance.md"


def number(value, digits=3):
    return f"{value:.{digits}g}" if value < 1000 else f"{value:,.0f}"


def hanging(rows):
    yield "| nodes | variant | ms a step | substeps at 60 Hz | real time | dispatches | GB/s of state | state hash |"
    yield "|---:|---|---:|---:|---:|---:|---:|---|"
    for row in rows:
        if "skipped" in row:
            yield f"| {row['nodes']:,} | {row['variant']} | skipped: {row['skipped']} | | | | | |"
            continue
        ms = row["ms_per_step"]["median"]
        yield (f"| {row['nodes']:,} | {row['variant']} | {ms:.4f} | {row['substeps']:,} | {number(row['real_time_factor'])} × | "
               f"{row['dispatches_per_step']:g} | {row['bytes_per_step'] / ms * 1e-6:,.0f} | `{row['state_hash']}` |")


def pull(rows):
    yield "| object | nodes | contact | ms a step | of it contact | substeps at 60 Hz | real time | hits in 2 steps | state hash after them |"
    yield "|---|---:|---|---:|---:|---:|---:|---:|---|"
    free = {(r["object"], r["nodes"]): r["ms_per_step"]["median"] for r in rows if r["variant"] == "none"}
    for row in rows:
        if "skipped" in row:
            yield f"| {row['object']} | {row['nodes']:,} | {row['variant']} | skipped: {row['skipped']} | | | | | |"
            continue
        ms = row["ms_per_step"]["median"]
        contact = ms - free[row["object"], row["nodes"]]
        yield (f"| {row['object']} | {row['nodes']:,} | {row['variant']} | {ms:.4f} | "
               f"{'' if row['variant'] == 'none' else f'{contact:.4f}'} | {row['substeps']:,} | "
               f"{number(row['real_time_factor'])} × | {row['contacts']:,} | `{row['state_hash']}` |")


def hosts(rows):
    names = ["native", "Node", "Chromium"]
    yield f"| nodes | {' | '.join(f'{name}, ms a step' for name in names)} | state hash, all three |"
    yield "|---:|---:|---:|---:|---|"
    for nodes in dict.fromkeys(row["nodes"] for row in rows):
        at = {row["host"]: row for row in rows if row["nodes"] == nodes}
        hashes = {row["state_hash"] for row in at.values()}
        assert len(hashes) == 1, f"{nodes} nodes end in different bits: {hashes}"
        times = " | ".join(f"{at[name]['ms_per_step']['median']:.4f}" for name in names)
        yield f"| {nodes:,} | {times} | `{hashes.pop()}` |"


def share(part):
    """Of a sheet, that is folded."""
    return "" if part == 1 else f", {part:g} of it"


def contact_self(rows):
    yield "| pose | nodes | sheets | ms a search | searches at 60 Hz | ms a step | of it contact | pairs | candidates | contacts a step | crossings | dispatches a step | state hash |"
    yield "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---|"
    for row in rows:
        if row["object_triangles"]:
            continue
        start = f"| {row['pose']}{share(row['part'])} | {row['nodes']:,} | {row['sheets']} |"
        if "skipped" in row:
            yield f"{start} skipped: {row['skipped']} | | | | | | | | | |"
            continue
        yield (f"{start} {row['ms_per_search']['median']:.4f} | {number(row['searches_per_frame'])} | {row['ms_per_step']['median']:.4f} | "
               f"{contact_ms(row):.4f} | {row['pairs']:,} | {row['candidates']:,} | {row['contacts'] / row['counted_steps']:,.0f} | "
               f"{row['crossings']} | {row['dispatches_per_step']:g} | `{row['state_hash']}` |")


def contact_objects(rows):
    yield "| object triangles | nodes | contact | ms a search | searches at 60 Hz | ms a step | of it contact | pairs | candidates | contacts a step | crossings | state hash |"
    yield "|---:|---:|---|---:|---:|---:|---:|---:|---:|---:|---:|---|"
    for row in rows:
        if not row["object_triangles"]:
            continue
        start = f"| {row['object_triangles']:,} | {row['nodes']:,} | {row['method']} |"
        if "skipped" in row:
            yield f"{start} skipped: {row['skipped']} | | | | | | | | |"
            continue
        searches = row["ms_per_search"]["median"]  # 0: the method searches in every step
        found = f"{searches:.4f} | {number(row['searches_per_frame'])}" if searches else " | "
        lists = f"{row['pairs']:,} | {row['candidates']:,}" if searches else " | "
        yield (f"{start} {found} | {row['ms_per_step']['median']:.4f} | {contact_ms(row):.4f} | {lists} | "
               f"{row['contacts'] / row['counted_steps']:,.0f} | {row['crossings'] if searches else ''} | `{row['state_hash']}` |")


def contact_ms(row):
    return row["ms_per_step"]["median"] - row["ms_per_step_without_contact"]["median"]


def contact_kernels(rows):
    """Of the rows of each pose with the most nodes."""
    timed = [row for row in rows if row.get("kernels") and row["part"] == 1 and row["method"] != "bvh"]
    if not timed:
        yield "This adapter has no timestamps."
        return
    largest = {}
    for row in timed:
        key = row["pose"], row["method"]
        if key not in largest or row["nodes"] > largest[key]["nodes"]:
            largest[key] = row
    yield "| pose | contact | nodes | a search, ms by kernel | a step, ms by kernel |"
    yield "|---|---|---:|---|---|"
    for row in largest.values():
        parts = [", ".join(f"{k['kernel']} {k['ms']:.4f}" for k in row["kernels"] if k["per"] == per) for per in ("search", "step")]
        yield f"| {row['pose']} | {row['method']} | {row['nodes']:,} | {parts[0]} | {parts[1]} |"


def fit(points):
    """The exponent of y over x by least squares of the logarithms, and how much of the variance it explains."""
    xs, ys = [math.log(x) for x, _ in points], [math.log(y) for _, y in points]
    mean_x, mean_y = sum(xs) / len(xs), sum(ys) / len(ys)
    xx = sum((x - mean_x) ** 2 for x in xs)
    xy = sum((x - mean_x) * (y - mean_y) for x, y in zip(xs, ys))
    yy = sum((y - mean_y) ** 2 for y in ys)
    return xy / xx, xy * xy / (xx * yy) if yy > 0 else 1


def contact_growth(rows):
    """How cost grows: with nodes for each pose, with pairs at one size, with an object's triangles."""
    rows = [row for row in rows if "skipped" not in row and row["sheets"] == 1]
    cloth = [row for row in rows if not row["object_triangles"]]
    draped = [row for row in rows if row["object_triangles"]]
    groups = []  # (what, over what, rows)
    for pose, part in dict.fromkeys((row["pose"], row["part"]) for row in cloth):
        groups.append((pose + share(part), "nodes", [r for r in cloth if (r["pose"], r["part"]) == (pose, part)]))
    for nodes in dict.fromkeys(row["nodes"] for row in cloth):
        for pose in ("folded", "crumpled"):
            groups.append((f"{pose}, {nodes:,} nodes", "pairs", [r for r in cloth if (r["pose"], r["nodes"]) == (pose, nodes)]))
    for method in dict.fromkeys(row["method"] for row in draped):
        same = [row for row in draped if row["method"] == method]
        for triangles in dict.fromkeys(row["object_triangles"] for row in same):
            groups.append((f"{method}, {triangles:,} object triangles", "nodes", [r for r in same if r["object_triangles"] == triangles]))
        for nodes in dict.fromkeys(row["nodes"] for row in same):
            groups.append((f"{method}, {nodes:,} nodes", "object_triangles", [r for r in same if r["nodes"] == nodes]))
    yield "| what | over | from | to | points | search: exponent (R²) | contact part of a step: exponent (R²) |"
    yield "|---|---|---:|---:|---:|---:|---:|"
    for what, over, group in groups:
        if len({row[over] for row in group}) < 3:
            continue
        cells = []
        for cost in (lambda row: row["ms_per_search"]["median"], contact_ms):
            points = [(row[over], cost(row)) for row in group if cost(row) > 0]
            cells.append("{:.2f} ({:.3f})".format(*fit(points)) if len(points) == len(group) else "")
        ends = [row[over] for row in group]
        yield f"| {what} | {over.replace('_', ' ')} | {min(ends):,} | {max(ends):,} | {len(group)} | {cells[0]} | {cells[1]} |"


def compare(rows):
    """Of the page /compare: ms a step, ms a frame, frames a second."""
    titles = {"weft-node": "weft, by node", "weft-spring": "weft, by spring", "three-webgpu": "three.js, WebGPU",
              "webgl2": "WebGL 2 shaders", "cpu": "CPU, JavaScript"}
    at = {(row["path"], row["nodes"]): row for row in rows}
    paths = list(dict.fromkeys(row["path"] for row in rows))
    for what, cell in (("a step [ms]", lambda row: number(row["ms_per_step"]["median"])),
                       ("a frame [ms]", lambda row: f"{number(row['ms_per_frame']['median'])} ({number(row['fps'])} fps)")):
        yield f"| nodes, {what} | {' | '.join(titles[path] for path in paths)} |"
        yield "|---:" * (1 + len(paths)) + "|"
        for nodes in dict.fromkeys(row["nodes"] for row in rows):
            cells = (cell(at[path, nodes]) if at[path, nodes]["ms_per_frame"] else at[path, nodes]["note"] for path in paths)
            yield f"| {nodes:,} | {' | '.join(cells)} |"
        yield ""


def page(rows):
    """Of bench/web/page.ts."""
    yield "| address | nodes | steps a frame | first moving frame [ms] | real time | frames a second | page's thread, a frame [ms] |"
    yield "|---|---:|---:|---:|---:|---:|---:|"
    for row in rows:
        yield (f"| `{row['query']}` | {row['nodes']:,} | {row['substeps']:,} | {row['first_frame_ms']:,.0f} | {number(row['real_time_factor'])} × | "
               f"{row['frames_per_second']:.1f} | {row['host_ms']:.2f} |")


def embree(rows):
    yield "| query | nodes | object triangles | pairs, equal | their hash | weft, ms | Embree's tree, ms | Embree's query, ms | Embree's faster way | weft over Embree |"
    yield "|---|---:|---:|---:|---|---:|---:|---:|---|---:|"
    for row in rows:
        best = row["embree_ms"][row["embree_best"]]
        objects = f"{row['object_triangles']:,}" if row["object_triangles"] else ""
        yield (f"| {row['pose']} | {row['nodes']:,} | {objects} | {row['pairs']:,} | `{row['pair_hash']}` | "
               f"{row['weft_ms']['median']:.1f} | {best['update']['median']:.1f} | {best['collide']['median']:.1f} | "
               f"{row['embree_best'].replace('_', ' ')} | {row['ratio']:.1f} |")


TABLES = {"hanging": hanging, "pull": pull, "hosts": hosts, "embree": embree, "contact self": contact_self,
          "contact objects": contact_objects, "contact kernels": contact_kernels, "contact growth": contact_growth, "compare": compare, "page": page}


def table(match):
    file = ROOT / "bench/results" / match[1]
    if not file.exists():
        return match[0]
    results = json.loads(file.read_text())
    part = match[2] or ""
    lines = TABLES[results["bench"] + part](results["rows"])
    driver = f", driver {results['driver']}" if "driver" in results else ""
    host = f"{results['processor']}, {results['threads']} threads, Embree {results['embree']}; " if "embree" in results else ""
    head = f"{host}{results['adapter']}{driver}{', kernels without run-time checks' if results.get('unchecked') else ''}:"
    return f"<!-- table {match[1]}{part} -->\n{head}\n\n" + "\n".join(lines) + "\n<!-- end -->"


if __name__ == "__main__":
    PAGE.write_text(re.sub(r"<!-- table (\S+)( \w+)? -->.*?<!-- end -->", table, PAGE.read_text(), flags=re.S))
