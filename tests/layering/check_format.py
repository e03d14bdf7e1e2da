#!/usr/bin/env python3
"""Checks that the C++ files of lib, tools and tests are as clang-format would write them.

Usage: check_format.py CLANG_FORMAT SOURCE_FOLDER. Prints the files that differ; exit code 1 if any,
77 (skipped) where clang-format is not version 14: other versions break lines elsewhere.
"""

import pathlib
import re
import subprocess
import sys

VERSION = 14
SKIPPED = 77


def version_of(program):
    text = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
    match = re.search(r"version (\d+)\.", text)
    return int(match.group(1)) if match else None


def sources(root):
    for folder in ("lib", "tools", "tests"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".h", ".hpp", ".cpp") and path.is_file():
                yield path


def is_formatted(program, path):
    text = path.read_text()
    wanted = subprocess.run([program, "--style=file", f"--assume-filename={path}"], input=text,
                            capture_output=True, text=True, check=True).stdout
    return text == wanted


def main():
    program, root = sys.argv[1], pathlib.Path(sys.argv[2])
    if version_of(program) != VERSION:
        print(f"skipped: {program} is not clang-format {VERSION}")
        return SKIPPED
    wrong = [path for path in sources(root) if not is_formatted(program, path)]
    for path in wrong:
        print(f"{path.relative_to(root)}: run clang-format -i")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
