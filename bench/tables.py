#!/usr/bin/env python3
"""Writes the tables of docs/performance.md from bench/results/*.json.

Each table stands between <!-- table FILE --> and <!-- end -->; the text around it is kept.
"""
import json
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


def table(match):
    results = json.loads((ROOT / "bench/results" / match[1]).read_text())
    lines = {"hanging": hanging, "pull": pull, "hosts": hosts}[results["bench"]](results["rows"])
    driver = f", driver {results['driver']}" if "driver" in results else ""
    head = f"{results['adapter']}{driver}{', kernels without run-time checks' if results.get('unchecked') else ''}:"
    return f"<!-- table {match[1]} -->\n{head}\n\n" + "\n".join(lines) + "\n<!-- end -->"


PAGE.write_text(re.sub(r"<!-- table (\S+) -->.*?<!-- end -->", table, PAGE.read_text(), flags=re.S))
