#!/usr/bin/env python3
"""Holds the #include lines of lib/splitsum to the module table in lib/CMakeLists.txt.

A module may include itself and the modules its line lists; a line may list earlier lines only, so
the graph has no cycles; a third-party header may be included by the module whose EXTERNAL names its
library; public headers start with #pragma once.

Usage: check_includes.py SOURCE_FOLDER. Prints one line for each violation; exit code 1 if any.
"""

import pathlib
import re
import sys

# Which CMake target brings a third-party header. Headers that are not listed here and not in
# EXTERNAL_PREFIXES are the compiler's, the C library's or the system's.
EXTERNAL_PREFIXES = {
    "glm/": ["glm::glm"],
    "OpenImageIO/": ["OpenImageIO::OpenImageIO"],
    "OpenEXR/": ["OpenEXR::OpenEXR"],
    # Half floats are Imath's; OpenEXR's interface is written in Imath's types.
    "Imath/": ["Imath::Imath", "OpenEXR::OpenEXR"],
    "OpenColorIO/": ["OpenColorIO::OpenColorIO"],
    "hwy/": ["hwy::hwy"],
    "oneapi/": ["TBB::tbb"],
    "tbb/": ["TBB::tbb"],
    "zstd": ["zstd"],
    "zdict": ["zstd"],
    "xxhash": ["xxhash"],
    "xxh3": ["xxhash"],
    "png.h": ["PNG::PNG"],
    "nlohmann/": ["nlohmann_json::nlohmann_json"],
    "CLI/": ["CLI11::CLI11"],
    "toml++/": ["tomlplusplus"],
    "json/": ["jsoncpp"],
}
# OpenEXR and Imath headers are also found without their folder.
BARE_EXTERNALS = [
    (re.compile(r"(Imf|Iex|IlmThread|openexr)\w*\.h"), ["OpenEXR::OpenEXR"]),
    (re.compile(r"(Imath|half)\w*\.h"), ["Imath::Imath", "OpenEXR::OpenEXR"]),
]

MODULE_LINE = re.compile(r"splitsum_module\(\s*([^)]*)\)")
INCLUDE_LINE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')
SOURCE_SUFFIXES = {".h", ".hpp", ".cpp", ".inl"}


class Module:
    """One line of the table."""

    def __init__(self, words):
        self.name = words[0]
        self.uses = []
        self.external = []
        target = None
        for word in words[1:]:
            if word in ("USES", "EXTERNAL"):
                target = self.uses if word == "USES" else self.external
            else:
                target.append(word)


def read_table(source):
    text = (source / "lib/CMakeLists.txt").read_text()
    text = re.sub(r"#.*", "", text)
    return [Module(match.group(1).split()) for match in MODULE_LINE.finditer(text)]


def check_order(table):
    """A line that uses only earlier lines cannot be part of a cycle."""
    earlier = set()
    for module in table:
        for used in module.uses:
            if used not in earlier:
                yield (f"lib/CMakeLists.txt: {module.name} uses {used}, "
                       "which is not on an earlier line")
        earlier.add(module.name)


def targets_of(header):
    """The CMake targets that may bring `header`, or None for a system header."""
    for prefix, targets in EXTERNAL_PREFIXES.items():
        if header.startswith(prefix):
            return targets
    for pattern, targets in BARE_EXTERNALS:
        if pattern.fullmatch(header):
            return targets
    return None


def problem_with(header, module, names):
    """What is wrong with `module` including `header`, or None."""
    if header.startswith("splitsum/"):
        used = header.split("/")[1]
        if used not in names:
            return f"there is no module {used}"
        if used != module.name and used not in module.uses:
            return f"{module.name} may not use {used}"
        return None
    targets = targets_of(header)
    if targets and not set(targets) & set(module.external):
        return f"{module.name} may not use {targets[0]} ({header})"
    return None


def check_file(path, shown, module, names):
    lines = path.read_text().splitlines()
    if path.suffix in (".h", ".hpp"):
        code = [line for line in lines if line.strip() and not line.lstrip().startswith("//")]
        # Highway compiles such a file once per instruction set: it must not be guarded.
        per_target = any("HWY_TARGET_INCLUDE" in line or "HWY_TARGET_TOGGLE" in line
                         for line in lines)
        if not per_target and (not code or code[0].strip() != "#pragma once"):
            yield f"{shown}:1: a header starts with #pragma once"
    for number, line in enumerate(lines, start=1):
        match = INCLUDE_LINE.match(line)
        problem = match and problem_with(match.group(1), module, names)
        if problem:
            yield f"{shown}:{number}: {problem}"


def check_sources(source, table):
    modules = {module.name: module for module in table}
    root = source / "lib/splitsum"
    for path in sorted(root.rglob("*")):
        if path.suffix not in SOURCE_SUFFIXES:
            continue
        shown = path.relative_to(source).as_posix()
        name = path.relative_to(root).parts[0]
        if name in modules:
            yield from check_file(path, shown, modules[name], modules.keys())
        else:
            yield f"{shown}: {name} is not in the module table of lib/CMakeLists.txt"


def violations(source):
    table = read_table(source)
    if not table:
        yield "lib/CMakeLists.txt: no splitsum_module lines found"
    yield from check_order(table)
    yield from check_sources(source, table)


def main():
    if len(sys.argv) != 2:
        print("usage: check_includes.py SOURCE_FOLDER", file=sys.stderr)
        return 2
    found = list(violations(pathlib.Path(sys.argv[1])))
    print("\n".join(found) if found else "every include is allowed")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
