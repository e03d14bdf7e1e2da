#!/usr/bin/env python3
"""Measures splitsum-bake on whole libraries, and writes the page batch.md: how the rate grows with
threads, what a second run costs, how long 10 000 finished outputs take to check, and the peak memory
under --memory.

Needs the benchmark make_large_panorama, and oiiotool of Debian's openimageio-tools.

Usage: measure_batch.py --build BUILD -o batch.md [--threads N] [--repeats N] [--quick]
"""

import argparse
import os
import pathlib
import platform
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

MEMORY = 600  # MB, as --memory takes it


class Sizes:
    """How much is measured: everything, or just enough to see that it works."""

    def __init__(self, quick):
        self.width, self.large_width = (64, 512) if quick else (1024, 8192)
        self.panoramas, self.outputs = (4, 200) if quick else (100, 10000)
        self.mixed_small, self.mixed_large = (4, 1) if quick else (24, 3)
        # The defaults, or what is quick.
        self.options = ["--size", "16", "--levels", "3", "--table-size", "8"] if quick else []


def run(command):
    """Seconds and peak memory in MB of a program, which must succeed."""
    start = time.perf_counter()
    child = subprocess.Popen([str(part) for part in command], stdin=subprocess.DEVNULL,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    output = child.stdout.read()
    _, status, usage = os.wait4(child.pid, 0)
    seconds = time.perf_counter() - start
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {child.returncode}\n"
                 + output.decode(errors="replace"))
    return seconds, usage.ru_maxrss * 1024 / 1e6


class Programs:
    def __init__(self, build):
        self.bake = build / "bin" / "splitsum-bake"
        self.make_large = build / "benchmarks" / "make_large_panorama"

    def library(self, folder, count, width):
        """Different panoramas of one width: one of them, turned by as many angles."""
        folder.mkdir(parents=True, exist_ok=True)
        base = folder.parent / f"base_{width}.exr"
        run([self.make_large, width, base])
        turns = []
        for i in range(count):
            turns += ["--dup", "--cshift", f"+{i * width // count}+0", "-o",
                      folder / f"sky{width}_{i:04}.hdr", "--pop"]
        run(["oiiotool", base, *turns])
        return folder

    def bake_library(self, library, output, options, *more):
        return run([self.bake, library, "-o", output, "--quiet", *options, *more])


def rate_rows(programs, folder, sizes, threads, repeats):
    """Rows of the page, and the medians of the first and the second run."""
    library = programs.library(folder / "library", sizes.panoramas, sizes.width)
    first, again = {}, {}
    # Round by round, so that a busy moment of the machine hits all of them.
    for _ in range(repeats):
        for count in (1, threads):
            output = folder / "output"
            options = [*sizes.options, "--threads", count]
            first.setdefault(count, []).append(programs.bake_library(library, output, options)[0])
            again.setdefault(count, []).append(programs.bake_library(library, output, options)[0])
            shutil.rmtree(output)
    start_up = statistics.median(run([programs.bake, "--version"])[0] for _ in range(5))
    one, many = (statistics.median(first[count]) for count in (1, threads))
    second = statistics.median(again[threads])
    kind = f"{sizes.panoramas} panoramas, {sizes.width}×{sizes.width // 2}"
    return [
        [f"{kind}, 1 thread", f"{60 * sizes.panoramas / one:.0f} a minute, {one:.1f} s", ""],
        [f"{kind}, {threads} threads", f"{60 * sizes.panoramas / many:.0f} a minute, {many:.1f} s", ""],
        [f"rate over {threads} × that of 1 thread", f"{one / many / threads:.2f}", "at least 0.8"],
        ["second run, nothing to do", f"{second:.2f} s, of which {start_up:.2f} s before main", ""],
        ["second run over the first", f"{100 * second / many:.1f} %", "under 2 %"],
    ]


def check_rows(programs, folder, sizes):
    """Finished outputs: one, linked into as many folders. The links to its panorama come first, as a
    new link counts as a change of the file, and a moment passes, as a file written just now is not
    trusted to be left alone."""
    library, output = folder / "many", folder / "many_output"
    small = ["--size", "16", "--levels", "3", "--table-size", "16"]
    one = programs.library(folder / "one", 1, 64) / "sky64_0000.hdr"
    for i in range(sizes.outputs):
        (library / f"{i:05}").mkdir(parents=True)
        os.link(one, library / f"{i:05}" / one.name)
    time.sleep(3)
    programs.bake_library(library / "00000", output / "00000", small)
    for i in range(1, sizes.outputs):
        target = output / f"{i:05}" / one.stem
        target.mkdir(parents=True)
        for file in (output / "00000" / one.stem).iterdir():
            os.link(file, target / file.name)
    before = time.time()
    seconds, memory = programs.bake_library(library, output, small)
    redone = sum(report.stat().st_mtime > before for report in output.glob("*/*/report.json"))
    if redone:
        sys.exit(f"{redone} of {sizes.outputs} outputs were not up to date")
    return [[f"{sizes.outputs} outputs that are up to date", f"{seconds:.2f} s, {memory:.0f} MB",
             "under 10 s"]], seconds


def memory_rows(programs, folder, sizes, threads):
    mixed = folder / "mixed"
    programs.library(mixed, sizes.mixed_small, sizes.width)
    programs.library(mixed, sizes.mixed_large, sizes.large_width)
    rows = []
    for limit in ([], ["--memory", f"{MEMORY}M"]):
        output = folder / "mixed_output"
        options = [*sizes.options, "--threads", threads, *limit]
        seconds, memory = programs.bake_library(mixed, output, options)
        shutil.rmtree(output)
        rows.append([f"{sizes.mixed_small} of {sizes.width} and {sizes.mixed_large} of "
                     f"{sizes.large_width} texels across, {' '.join(limit) or 'no limit'}",
                     f"peak {memory:.0f} MB, {seconds:.1f} s",
                     f"under {MEMORY} MB" if limit else ""])
    return rows, memory


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True)
    parser.add_argument("--threads", type=int, default=min(4, os.cpu_count()))
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--quick", action="store_true", help="small libraries only, to try the script")
    options = parser.parse_args()
    programs, sizes = Programs(options.build), Sizes(options.quick)

    load = os.getloadavg()[0]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        rows = rate_rows(programs, folder, sizes, options.threads, options.repeats)
        checked, seconds = check_rows(programs, folder, sizes)
        mixed, memory = memory_rows(programs, folder, sizes, options.threads)
    lines = ["# Libraries: rate, second runs, memory", "",
             f"Written by measure_batch.py on {platform.machine()} with {os.cpu_count()} cores, load "
             f"{load:.1f} before it began; whole processes, median of {options.repeats}, the default "
             "options. A ratio that needs quiet cores is a lower bound on busy ones.", "",
             "| what | measured | target |", "| --- | --- | --- |"]
    lines += ["| " + " | ".join(row) + " |" for row in [*rows, *checked, *mixed]]
    options.output.write_text("\n".join(lines) + "\n")
    # What does not depend on how busy the machine is, or hardly.
    if memory >= MEMORY:
        sys.exit(f"--memory {MEMORY}M: {memory:.0f} MB were used")
    if seconds > 60:
        sys.exit(f"{sizes.outputs} checks took {seconds:.0f} s")


if __name__ == "__main__":
    main()
