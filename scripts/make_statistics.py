"""Makes what C++, WGSL, TypeScript and the docs know of statistics from the table src/state/statistics.txt.

usage: scripts/make_statistics.py [--check]   --check: say what is not as it would be made, and end with 1
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE = "src/state/statistics.txt"
MADE = f"// Made by scripts/make_statistics.py from {TABLE}."
CPP = {"u32": "std::uint32_t", "f32": "float"}
ADD = {
    "sum": "totals.{0} += frame.{0};",
    "wrap": "totals.{0} += frame.{0};",
    "max": "totals.{0} = std::max(totals.{0}, frame.{0});",
    "last": "totals.{0} = frame.{0};",
    # The same as the sum of the microseconds, in any order.
    "seconds": "totals.{1} = (std::round(1e6 * totals.{1}) + frame.{0}) / 1e6;",
}


def rows_of(text):
    """The rows of the table as dictionaries: name, type, clear, total, meaning."""
    lines = [line for line in text.split("\n") if line]
    keys = [key.strip(" #") for key in [line for line in lines if line.startswith("#")][-1].split("|")]
    rows = [dict(zip(keys, map(str.strip, line.split("|")), strict=True)) for line in lines if line[0] != "#"]
    groups = [("-", "frame", "reset").index(row["clear"]) for row in rows]
    if groups != sorted(groups):
        raise ValueError("The rows of the host come first, then those of a frame, then those that a reset clears.")
    for row in rows:
        if row["type"] not in CPP or row["total"] not in {*ADD, "host", "-"} or not row["name"].islower():
            raise ValueError(f"{row} has a word that no column knows.")
        if (row["clear"] == "-") != (row["total"] == "host"):
            raise ValueError(f"{row['name']} is counted by the host and by the GPU, or by neither.")
        if (row["total"] == "seconds") != row["name"].endswith("_us"):
            raise ValueError(f"{row['name']} is in microseconds and not added up to seconds, or the reverse.")
    return rows


def sentence(row):
    return row["meaning"][0].upper() + row["meaning"][1:]


def of_all(row):
    """The meaning of a total."""
    return sentence(row) + (", the most of any" if row["total"] == "max" else "")


def camel(name):
    return re.sub("_(.)", lambda found: found[1].upper(), name)


def total_name(row):
    return row["name"].removesuffix("_us") + "_s" if row["total"] == "seconds" else row["name"]


def total_type(row):
    return {"sum": "std::uint64_t", "seconds": "double"}.get(row["total"], CPP[row["type"]])


def shader(words):
    constants = "".join(
        f"// {sentence(row)}{', as the bits of a positive f32' if row['type'] == 'f32' else ''}.\n"
        f"const kStat{camel('_' + row['name'])} = {number}u;\n"
        for number, row in enumerate(words)
    )
    return f"{MADE}\n// The words of a frame's report. Kernels bind it as array<atomic<u32>>.\n{constants}"


def members(rows, type_of, meaning):
    return "".join(f"  /// {meaning(row)}.\n  {type_of(row)} {row['name']} = 0;\n" for row in rows)


def visits(rows, of):
    return "".join(f'  visit("{row["name"]}", {of}.{row["name"]});\n' for row in rows)


def mirror(words):
    kept = next(row["name"] for row in words if row["clear"] == "reset")
    sums = "".join(
        f"  {ADD[row['total']].format(row['name'], total_name(row))}\n" for row in words if row["total"] != "-"
    )
    return f"""{MADE}
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "weft/totals.hpp"

namespace weft {{

/// What a frame reports. Mirror of src/state/statistics.wgsl.
struct Statistics {{
{members(words, lambda row: CPP[row["type"]], sentence)}}};
static_assert(sizeof(Statistics) == {len(words)} * sizeof(std::uint32_t));

/// The part that is cleared before each frame.
inline constexpr std::uint32_t kStatisticsPerFrameBytes = offsetof(Statistics, {kept});

/// Takes what a frame has reported into the totals.
inline void add(Totals& totals, const Statistics& frame) {{
{sums}}}

/// Calls visit(name, value) for each word, in their order.
template <class Visit>
void for_each(const Statistics& statistics, Visit&& visit) {{
{visits(words, "statistics")}}}

}}  // namespace weft
"""


def totals_header(totals):
    return f"""{MADE}
#pragma once

#include <cstdint>
#include <type_traits>

namespace weft {{

/// What the frames so far have reported.
struct Totals {{
{members(totals, total_type, of_all)}}};

/// Calls visit(name, value) for each of them, in their order.
template <class AnyTotals, class Visit>
requires std::is_same_v<std::remove_const_t<AnyTotals>, Totals>
void for_each(AnyTotals& totals, Visit&& visit) {{
{visits(totals, "totals")}}}

}}  // namespace weft
"""


def totals_module(totals):
    names = [camel(row["name"]) for row in totals]
    fields = "".join(f"  /** {of_all(row)}. */\n  {camel(row['name'])}: number;\n" for row in totals)
    return f"""{MADE}
/** What the frames so far have reported; up to three frames old. */
export interface Totals {{
{fields}}}

/** Their names, in the order in which the core gives them. */
export const TOTALS = [
{"".join(f'  "{name}",{chr(10)}' for name in names)}] as const satisfies readonly (keyof Totals)[];

/** Before the first frame. */
export function noTotals(): Totals {{
  return {{
{"".join(f"    {name}: 0,{chr(10)}" for name in names)}  }};
}}
"""


def page(text, totals):
    """docs/cli.md with a row for each total between its two marks."""
    made = "".join(f"| `{row['name']}` | {of_all(row)} |\n" for row in totals)
    begin, end = f"<!-- from {TABLE} -->\n", "<!-- end -->\n"
    head, rest = text.split(begin)
    return f"{head}{begin}| member | meaning |\n|---|---|\n{made}{end}{rest.split(end, 1)[1]}"


def made(table, docs):
    """Every file that follows from the table, by its path; `docs`: the text of docs/cli.md as it is."""
    rows = rows_of(table)
    words = [row for row in rows if row["clear"] != "-"]
    totals = [{**row, "name": total_name(row)} for row in rows if row["total"] != "-"]
    return {
        "src/state/statistics.wgsl": shader(words),
        "src/state/statistics.hpp": mirror(words),
        "include/weft/totals.hpp": totals_header(totals),
        "packages/weft/src/totals.ts": totals_module(totals),
        "docs/cli.md": page(docs, totals),
    }


def main(arguments):
    files = made((ROOT / TABLE).read_text("utf-8"), (ROOT / "docs/cli.md").read_text("utf-8"))
    old = [name for name, text in files.items() if not (ROOT / name).exists() or (ROOT / name).read_text() != text]
    for name in old:
        if arguments == ["--check"]:
            print(f"{name} is not as scripts/make_statistics.py makes it from {TABLE}.")
        else:
            (ROOT / name).write_text(files[name], "utf-8")
    return 1 if arguments == ["--check"] and old else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
