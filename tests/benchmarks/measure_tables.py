#!/usr/bin/env python3
"""Measures every table that splitsum-brdf makes, and writes the page tables.md.

Each table, geometry term, format and size: the largest error at texels, between them and in the outer
half texel, as the tool itself measures them, and the time of the whole process, the median of several.
Then the methods beside each other and beside the scalar loop with 1024 Hammersley points, from the
benchmark split_sum in the same run.

Usage: measure_tables.py --build BUILD -o tables.md [--repeats N] [--quick]
"""

import argparse
import json
import os
import pathlib
import platform
import re
import statistics
import subprocess
import sys
import tempfile
import time

TERMS = ["height-correlated", "schlick-half", "schlick-sqrt"]
SPLIT_SUM_KINDS = ["ggx", "ggx-multiscatter", "energy", "energy-lost"]


def run(command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def kinds_of(tool):
    """The names that --help lists under --table."""
    text = run([tool, "--help"])
    block = text[text.index("--table NAME"):text.index("--method NAME")]
    return re.findall(r"^\s+([a-z][a-z-]*):", block, re.MULTILINE)


def bake(tool, folder, arguments, repeats):
    """The tool's own figures, and the median time of the process."""
    formula = "ggx-fit" in arguments
    output = pathlib.Path(folder) / ("table.hpp" if formula else "table.ktx2")
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        text = run([tool, "-o", str(output), "--json", "--quiet", *arguments])
        times.append(time.perf_counter() - start)
    return json.loads(text), statistics.median(times)


def row(tool, folder, arguments, repeats, shown):
    figures, seconds = bake(tool, folder, arguments, repeats)
    return [*shown, *(f"{figures[key]:.1e}" for key in
                      ("max_abs", "max_abs_between", "max_abs_in_rim")), f"{1000 * seconds:.0f}"]


def page(head, rows):
    return ["| " + " | ".join(cells) + " |" for cells in (head, ["---"] * len(head), *rows)]


HEAD = ["table", "geometry", "layout", "format", "size", "max_abs at texels", "between",
        "outer half texel", "ms"]


def split_sum_rows(tool, folder, options):
    sizes = ["64"] if options.quick else ["64", "256", "512"]
    for kind in SPLIT_SUM_KINDS:
        for term in TERMS:
            for form in ("rg16f", "rg32f", "rg16unorm"):
                for size in sizes:
                    yield row(tool, folder, ["--table", kind, "--geometry", term, "--format", form,
                                             "--size", size], options.repeats,
                              [kind, term, "centre", form, size])
    for size in sizes:
        yield row(tool, folder, ["--layout", "edge", "--format", "rg32f", "--size", size],
                  options.repeats, ["ggx", TERMS[0], "edge", "rg32f", size])
    for term in TERMS:
        yield row(tool, folder, ["--table", "ggx-fit", "--geometry", term], options.repeats,
                  ["ggx-fit", term, "", "formula", ""])


def other_rows(tool, folder, options):
    for kind in kinds_of(tool):
        if kind in SPLIT_SUM_KINDS or kind == "ggx-fit":
            continue
        form, layout = ("rgba16f", "edge") if kind.startswith("ltc") else ("rg16f", "centre")
        size = "16" if options.quick else "64"
        yield row(tool, folder, ["--table", kind, "--format", form, "--size", size, "--layout",
                                 layout], options.repeats, [kind, "", layout, form, size])


def method_rows(build, options):
    """From the benchmark: milliseconds and the error in the same run."""
    pattern = "height-correlated/128" if options.quick else "height-correlated|scalar"
    with tempfile.NamedTemporaryFile(suffix=".json") as output:
        run([str(build / "benchmarks" / "split_sum"), f"--benchmark_filter={pattern}",
             f"--benchmark_out={output.name}", "--benchmark_out_format=json"])
        cases = json.load(output)["benchmarks"]
    for case in cases:
        yield [case["name"].replace("/real_time", ""), f"{case['real_time']:.1f}",
               f"{case['max_abs']:.1e}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True)
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--quick", action="store_true", help="small tables only, to try the script")
    options = parser.parse_args()
    tool = str(options.build / "bin" / "splitsum-brdf")

    with tempfile.TemporaryDirectory() as folder:
        tables = [*split_sum_rows(tool, folder, options), *other_rows(tool, folder, options)]
    lines = ["# Tables: errors and times", "",
             f"Written by measure_tables.py on {platform.machine()} with {os.cpu_count()} cores, load "
             f"{os.getloadavg()[0]:.1f}; whole processes, median of "
             f"{options.repeats}; the errors are those of the tool's own check against nested "
             "quadrature.", "", *page(HEAD, tables), "",
             "## Methods beside each other", "",
             "Benchmark split_sum in one run: the table alone, without its check and its file; "
             "scalar is one thread with 1024 Hammersley points.", "",
             *page(["case", "ms", "max_abs"], method_rows(options.build, options)), ""]
    options.output.write_text("\n".join(lines), encoding="utf-8")
    print(options.output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
