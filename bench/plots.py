#!/usr/bin/env python3
"""Draws docs/images/contact-*.svg from the results of `weft bench contact`: bench/results/h100_contact.json, or the file
that is named. Run by hand, with matplotlib; docs/performance.md has the commands.
"""
import json
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt
import matplotlib.ticker

from tables import ROOT, contact_ms, fit, share

matplotlib.rcParams.update({"svg.hashsalt": "weft", "font.size": 9, "axes.grid": True, "grid.alpha": 0.3,
                            "axes.axisbelow": True,
                            "svg.fonttype": "none", "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False})


def search_ms(row):
    return row["ms_per_search"]["median"]


def draw_line(axes, rows, over, cost, label, style):
    points = sorted((row[over], cost(row)) for row in rows if cost(row) > 0)
    if len({x for x, _ in points}) < 2:
        return
    exponent = f", exponent {fit(points)[0]:.2f}" if len(points) > 2 else ""
    axes.plot(*zip(*points), style, label=label + exponent, markersize=4)


def save(figure, name, results):
    figure.suptitle(f"{results['adapter']}, driver {results['driver']}", fontsize=9)
    figure.tight_layout()
    figure.savefig(ROOT / "docs/images" / name, metadata={"Date": None})


def draw_growth(results, rows):
    figure, (nodes, pairs, triangles) = plt.subplots(1, 3, figsize=(11, 3.8))
    single = [row for row in rows if row["sheets"] == 1]
    cloth = [row for row in single if not row["object_triangles"]]
    draped = [row for row in single if row["object_triangles"]]
    for pose, part in dict.fromkeys((row["pose"], row["part"]) for row in cloth):
        same = [row for row in cloth if (row["pose"], row["part"]) == (pose, part)]
        if len({row["nodes"] for row in same}) > 2:
            draw_line(nodes, same, "nodes", search_ms, pose + share(part), "o-" if part == 1 else "o--")
    nodes.set(xlabel="nodes", ylabel="ms a search")
    swept = max({row["nodes"] for row in cloth}, key=lambda n: sum(row["nodes"] == n for row in cloth))
    for pose in ("folded", "crumpled"):
        same = [row for row in cloth if (row["pose"], row["nodes"]) == (pose, swept)]
        draw_line(pairs, same, "pairs", search_ms, f"{pose}: a search", "o-")
        draw_line(pairs, same, "pairs", contact_ms, f"{pose}: contact a step", "o--")
    pairs.set(xlabel=f"listed pairs, {swept:,} nodes", ylabel="ms")
    if draped:
        swept = max({row["nodes"] for row in draped}, key=lambda n: sum(row["nodes"] == n for row in draped))
        for method in dict.fromkeys(row["method"] for row in draped):
            same = [row for row in draped if (row["method"], row["nodes"]) == (method, swept)]
            draw_line(triangles, same, "object_triangles", contact_ms, method, "o-")
        triangles.set(xlabel=f"object's triangles, {swept:,} nodes", ylabel="contact, ms a step")
    for axes in (nodes, pairs, triangles):
        axes.set(xscale="log", yscale="log")
        axes.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
        if axes.lines:
            axes.legend(fontsize=6)
    save(figure, "contact-growth.svg", results)


def draw_kernels(results, rows):
    timed = [row for row in rows if row.get("kernels") and search_ms(row) > 0 and row["part"] == 1]
    if not timed:
        return
    figure, panels = plt.subplots(1, 2, figsize=(11, 0.9 + 0.24 * len(timed)), sharey=True)
    names = [f"{row['pose']}, {row['nodes']:,}" + (f", {row['object_triangles']:,} △ {row['method']}" if row["object_triangles"] else "")
             for row in timed]
    for axes, per in zip(panels, ("search", "step")):
        kernels = list(dict.fromkeys(k["kernel"] for row in timed for k in row["kernels"] if k["per"] == per))
        left = [0.0] * len(timed)
        for kernel in kernels:
            whole = [sum(k["ms"] for k in row["kernels"] if k["per"] == per) for row in timed]
            ms = [sum(k["ms"] for k in row["kernels"] if (k["kernel"], k["per"]) == (kernel, per)) for row in timed]
            width = [100 * m / w if w > 0 else 0 for m, w in zip(ms, whole)]
            axes.barh(names, width, left=left, label=kernel)
            left = [a + b for a, b in zip(left, width)]
        axes.set(xlabel=f"% of the kernels' time a {per}", xlim=(0, 100))
        axes.legend(fontsize=7, ncols=3, loc="lower center", bbox_to_anchor=(0.5, 1))
    panels[0].invert_yaxis()
    save(figure, "contact-kernels.svg", results)


def main():
    file = sys.argv[1] if len(sys.argv) > 1 else ROOT / "bench/results/h100_contact.json"
    with open(file) as stream:
        results = json.load(stream)
    rows = [row for row in results["rows"] if "skipped" not in row]
    draw_growth(results, rows)
    draw_kernels(results, rows)


main()
