#!/usr/bin/env python3
"""Measures what the programs make of captures: error, time and memory of every method, as a page.

Each combination of capture, method, size, curve and format is baked by splitsum-specular, in turn
with read_only on the same file, --repeats times over; the page shows medians and ratios of one run.
The chains are judged by splitsum-compare against exact integration. The benchmark `chain` adds the
time of filtering alone, from texels in memory. DIR gets measured.md and measured.json.

Example: measure_captures.py --build build -o measured --large 2048 4096 8192 16384 -- captures/*.hdr
"""

import argparse
import dataclasses
import itertools
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


class Failed(Exception):
    """A program did not do what was asked; the message says which and why."""


@dataclasses.dataclass
class Run:
    seconds: float
    peak_mb: float
    stdout: str


def run(command):
    """The command's wall-clock time and peak resident memory; Failed unless it exits with 0."""
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        start = time.perf_counter()
        process = subprocess.Popen([str(word) for word in command], stdout=out, stderr=err)
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.perf_counter() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        err.seek(0)
        if process.returncode != 0:
            message = err.read().decode(errors="replace").strip()
            raise Failed(f"{' '.join(map(str, command))}: exit {process.returncode}: {message}")
        # Never below this script's own 15 MB: Linux counts what the child was before exec.
        return Run(seconds, usage.ru_maxrss / 1024, out.read().decode())


@dataclasses.dataclass(frozen=True)
class Chain:
    """One thing to bake."""

    capture: pathlib.Path
    size: str  # "256x7": texels along an edge of level 0, levels
    curve: str
    format: str
    method: str

    def command(self, programs, output):
        face_size, levels = self.size.split("x")
        return [programs.tool("splitsum-specular"), self.capture, "-o", output, "--quiet",
                "--probes", 0, "--size", face_size, "--levels", levels, "--roughness", self.curve,
                "--format", self.format, "--method", self.method, "--samples", programs.samples,
                "--threads", programs.threads]


@dataclasses.dataclass
class Programs:
    build: pathlib.Path
    samples: int
    threads: int

    def tool(self, name):
        return self.build / "bin" / name

    def helper(self, name):
        return self.build / "benchmarks" / name

    def methods(self):
        """The methods that --help lists, without the judge, which takes a minute for a chain."""
        text = run([self.tool("splitsum-specular"), "--help"]).stdout
        block = re.search(r"^  --method NAME.*\n((?: {10,}[\w-]+: .*\n)+)", text, re.MULTILINE)
        if not block:
            raise Failed("splitsum-specular --help lists no methods")
        return [m for m in re.findall(r"^ +([\w-]+): ", block[1], re.MULTILINE) if m != "reference"]


def timed(programs, chains, repeats, scratch):
    """Runs of every chain and of read_only on every capture, all of them once a round."""
    captures = list(dict.fromkeys(chain.capture for chain in chains))
    runs = {thing: [] for thing in [*captures, *chains]}
    for repeat in range(repeats):
        for capture in captures:
            log(f"round {repeat + 1} of {repeats}: {capture.name}")
            runs[capture].append(run([programs.helper("read_only"), capture]))
            for chain in chains:
                if chain.capture == capture:
                    runs[chain].append(run(chain.command(programs, scratch / "chain.ktx2")))
    return runs


def figures(programs, chain, probes, scratch):
    """What splitsum-compare finds in each level."""
    asset = scratch / "compared.ktx2"
    run(chain.command(programs, asset))
    compared = run([programs.tool("splitsum-compare"), asset, "--panorama", chain.capture, "--json",
                    "--quiet", "--probes", probes])
    keys = ("level", "face_size", "perceptual_roughness", "rel_rms", "max_rel", "bias")
    return [{key: level[key] for key in keys} for level in json.loads(compared.stdout)["levels"]]


def median_of(runs, field):
    return statistics.median(getattr(one, field) for one in runs)


def result_of(chain, runs):
    """One row of the JSON file, without its levels."""
    seconds = median_of(runs[chain], "seconds")
    reading = median_of(runs[chain.capture], "seconds")
    return {
        "capture": chain.capture.stem, "size": chain.size, "curve": chain.curve,
        "format": chain.format, "method": chain.method,
        "process_s": seconds, "read_only_s": reading, "beyond_reading_s": seconds - reading,
        "peak_mb": median_of(runs[chain], "peak_mb"),
        "read_only_peak_mb": median_of(runs[chain.capture], "peak_mb"),
    }


def measure(programs, chains, options, scratch):
    """Times of all chains, and with `probes` their errors."""
    runs = timed(programs, chains, options.repeats, scratch)
    results = []
    for chain in chains:
        result = result_of(chain, runs)
        if options.probes:
            log(f"comparing {chain.capture.name} {chain.size} {chain.curve} {chain.method}")
            result["levels"] = figures(programs, chain, options.probes, scratch)
        results.append(result)
    return results


def in_memory(programs, captures, methods, repeats, scratch):
    """Medians of the benchmark `chain`: 256 x 256, 7 levels, linear, on one thread and on all."""
    if not captures:
        return []
    log("filtering in memory")
    names = "|".join(re.escape(capture.name) for capture in captures)
    out = scratch / "chain.json"
    run([programs.helper("chain"), f"--benchmark_filter=^({names})/({'|'.join(methods)})/",
         "--benchmark_min_time=0.2", f"--benchmark_repetitions={repeats}",
         "--benchmark_enable_random_interleaving=true",
         f"--benchmark_out={out}", "--benchmark_out_format=json", *captures])
    results = {(capture.name, method): {"capture": capture.stem, "method": method}
               for capture in captures for method in methods}
    for entry in json.loads(out.read_text())["benchmarks"]:
        if entry.get("aggregate_name", "median" if repeats == 1 else "") != "median":
            continue
        capture, method, threads = entry["run_name"].split("/")[:3]
        result = results[capture, method]
        result["rel_rms"] = entry["rel_rms"]
        result["ms_1_thread" if threads == "threads:1" else "ms_all"] = entry["real_time"]
    return list(results.values())


def make_large(programs, widths, extension, scratch):
    """Generated panoramas of these widths."""
    made = []
    for width in widths:
        path = scratch / f"generated_{width}.{extension}"
        log(f"making {path.name}")
        run([programs.helper("make_large_panorama"), width, path])
        made.append(path)
    return made


# The page.

def instruction_set():
    try:
        flags = set(re.search(r"^flags\s*:(.*)$", open("/proc/cpuinfo").read(), re.M)[1].split())
    except (OSError, TypeError):
        return platform.machine()
    for flag, name in (("avx512f", "AVX-512"), ("avx2", "AVX2"), ("sse4_2", "SSE4.2")):
        if flag in flags:
            return name
    return platform.machine()


def machine():
    return {"cores": len(os.sched_getaffinity(0)), "instruction_set": instruction_set(),
            "load_before": round(os.getloadavg()[0], 1)}


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    return lines + ["| " + " | ".join(row) + " |" for row in rows] + [""]


def worst_rel_rms(result):
    """Of the levels beyond the mirror image."""
    rough = [level["rel_rms"] for level in result["levels"] if level["perceptual_roughness"] > 0]
    return max(rough, default=0.0)


def time_cells(result, fastest):
    return [f"{result['process_s']:.2f} s", f"{result['beyond_reading_s']:.2f} s",
            f"{result['process_s'] / result['read_only_s']:.2f}",
            f"{result['beyond_reading_s'] / fastest:.1f}" if fastest > 0 else "-",
            f"{result['peak_mb']:.0f} MB ({result['read_only_peak_mb']:.0f})"]


TIME_HEAD = ["whole process", "beyond reading", "process / read_only", "beyond reading / fastest",
             "peak memory (read_only)"]


def time_table(results):
    """Speed with the worst error beside it."""
    rows = []
    for result in results:
        rivals = [r["beyond_reading_s"] for r in results if r["capture"] == result["capture"]]
        worst = [f"{worst_rel_rms(result):.1e}"] if "levels" in result else []
        rows.append([result["capture"], result["method"], *worst,
                     *time_cells(result, min(rivals))])
    head = ["capture", "method", *(["worst rel_rms"] if "levels" in results[0] else []), *TIME_HEAD]
    return table(head, rows)


def error_table(results):
    """rel_rms, max_rel and bias of every level, a column a method."""
    methods = list(dict.fromkeys(result["method"] for result in results))
    cells = {}
    for result in results:
        for level in result["levels"]:
            key = (result["capture"], level["level"], level["perceptual_roughness"])
            cells.setdefault(key, {})[result["method"]] = (
                f"{level['rel_rms']:.1e}, {level['max_rel']:.1e}, {level['bias']:+.1e}")
    rows = [[capture, f"{level}", f"{r:.3f}", *(found[m] for m in methods)]
            for (capture, level, r), found in cells.items()]
    return table(["capture", "level", "r", *methods], rows)


def in_memory_section(results):
    """Speed-ups are those over `filtered` where it was measured."""
    slow = {r["capture"]: r for r in results if r["method"] == "filtered"}
    def cell(result, key):
        rival = slow.get(result["capture"])
        ratio = f" ({rival[key] / result[key]:.1f})" if rival else ""
        return f"{result[key]:.1f} ms{ratio}"
    rows = [[r["capture"], r["method"], f"{r['rel_rms']:.1e}", cell(r, "ms_1_thread"),
             cell(r, "ms_all")] for r in results]
    return ["## Filtering alone, from texels in memory: 256x7, linear, floats", "",
            "In brackets: how many times faster than `filtered`.", "",
            *table(["capture", "method", "worst rel_rms", "1 thread", "all threads"], rows)]


def section(title, results):
    lines = [f"## {title}", "", *time_table(results)]
    if "levels" in results[0]:
        lines += ["rel_rms, max_rel, bias:", "", *error_table(results)]
    return lines


def page(document):
    about = document["measured_with"]
    lines = [
        "# Measured on captures", "",
        f"{about['version']}; {about['cores']} cores, {about['instruction_set']}, load "
        f"{about['load_before']} before the run; {about['samples']} samples a texel, medians of "
        f"{about['repeats']} rounds; errors at {about['probes']} texels a level against exact "
        "integration. What the figures mean: README.md beside measure_captures.py.", ""]
    if document["in_memory"]:
        lines += in_memory_section(document["in_memory"])
    keys = ("size", "curve", "format")
    for results in (document["chains"], document["large"]):
        groups = itertools.groupby(results, key=lambda r: tuple(r[k] for k in keys))
        for (size, curve, form), members in groups:
            kind = "Generated panoramas, " if results is document["large"] else ""
            lines += section(f"{kind}{size}, {curve}, {form}", list(members))
    return "\n".join(lines)


def write_whole(path, text):
    part = path.with_name(path.name + ".part")
    part.write_text(text)
    part.replace(path)


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    add = parser.add_argument
    add("captures", nargs="*", type=pathlib.Path, help="2:1 lat-long images, .hdr or .exr")
    add("--build", type=pathlib.Path, default="build", help="the build folder (default build)")
    add("-o", "--output", type=pathlib.Path, required=True, metavar="DIR",
        help="where measured.md and measured.json go")
    add("--methods", nargs="+", metavar="NAME",
        help="default: all of splitsum-specular --help but the slow judge, `reference`")
    add("--sizes", nargs="+", default=["256x7", "512x9"], metavar="SIZExLEVELS",
        help="default 256x7 512x9")
    add("--curves", nargs="+", default=["linear", "filament"], metavar="CURVE",
        help="default linear filament")
    add("--formats", nargs="+", default=["rgba16f", "rgba32f"], metavar="FORMAT",
        help="default rgba16f rgba32f")
    add("--samples", type=int, default=1024, help="a texel, of sampling methods (default 1024)")
    add("--probes", type=int, default=64,
        help="texels a level that are compared; 0 measures time alone (default 64)")
    add("--repeats", type=int, default=3, help="rounds whose medians are shown (default 3)")
    add("--threads", type=int, default=0, help="of the programs; 0, the default: all cores")
    add("--large", nargs="+", type=int, default=[], metavar="WIDTH",
        help="also time generated panoramas of these widths, in the first size, curve and format")
    add("--large-format", choices=["hdr", "exr"], default="hdr", help="half .exr (zip) or .hdr")
    options = parser.parse_args()
    if not options.captures and not options.large:
        parser.error("no captures and no --large: nothing to measure")
    if options.repeats < 1:
        parser.error("--repeats must be at least 1")
    if wrong := [s for s in options.sizes if not re.fullmatch(r"\d+x\d+", s)]:
        parser.error(f"--sizes {wrong[0]}: not of the form 256x7")
    return options


def collect(options, scratch):
    """The whole JSON document."""
    programs = Programs(options.build.resolve(), options.samples, options.threads)
    about = {"version": run([programs.tool("splitsum-specular"), "--version"]).stdout.strip(),
             **machine(), "samples": options.samples, "repeats": options.repeats,
             "probes": options.probes, "threads": options.threads}
    methods = options.methods or programs.methods()
    chains = [Chain(capture, *rest, method)
              for rest in itertools.product(options.sizes, options.curves, options.formats)
              for capture in options.captures for method in methods]
    document = {"measured_with": about,
                "in_memory": in_memory(programs, options.captures, methods, options.repeats,
                                       scratch),
                "chains": measure(programs, chains, options, scratch)}

    large = make_large(programs, options.large, options.large_format, scratch)
    first = (options.sizes[0], options.curves[0], options.formats[0])
    chains = [Chain(capture, *first, method) for capture in large for method in methods]
    time_alone = argparse.Namespace(repeats=options.repeats, probes=0)
    document["large"] = measure(programs, chains, time_alone, scratch)
    return document


def log(text):
    print(text, file=sys.stderr, flush=True)


def main():
    options = parse_arguments()
    try:
        options.output.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix="splitsum-measure-") as scratch:
            document = collect(options, pathlib.Path(scratch))
        write_whole(options.output / "measured.json", json.dumps(document, indent=1) + "\n")
        write_whole(options.output / "measured.md", page(document))
    except (Failed, OSError) as error:
        log(f"measure_captures.py: {error}")
        return 1
    print(options.output / "measured.md")
    return 0


if __name__ == "__main__":
    sys.exit(main())
