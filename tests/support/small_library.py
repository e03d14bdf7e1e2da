"""A library of small panoramas for tests that bake one many times, and what a bake of it must be."""

import hashlib
import os
import random
import subprocess
from pathlib import Path

WIDTH, HEIGHT = 64, 32
# The quickest bake that still makes every asset.
SMALL = ("--size", "16", "--levels", "3", "--irradiance-size", "4", "--table-size", "8",
         "--probes", "1", "--no-picture")


def write_panorama(file: Path, key: int) -> None:
    """A Radiance file of light that is lopsided in every direction and different for every key."""
    numbers = random.Random(key)
    sun = numbers.randrange(WIDTH * HEIGHT)
    tint = [numbers.randrange(40, 255) for _ in range(3)]
    texels = bytearray()
    for y in range(HEIGHT):
        for x in range(WIDTH):
            exponent = 136 if y * WIDTH + x == sun else 129
            texels += bytes((128 + x * tint[0] // (2 * WIDTH), 128 + y * tint[1] // (2 * HEIGHT),
                             128 + (x + y) * tint[2] // (2 * (WIDTH + HEIGHT)), exponent))
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (HEIGHT, WIDTH) + texels)


def write_library(folder: Path, count: int) -> Path:
    """Panoramas in the folder and in one below it."""
    for key in range(count):
        write_panorama(folder / ("" if key % 3 else "below") / f"sky{key:03}.hdr", key)
    return folder


def bake_command(program: Path, library: Path, output: Path, *options) -> list[str]:
    return [str(part) for part in (program, library, "-o", output, *SMALL, "--quiet", *options)]


def bake(program: Path, library: Path, output: Path, *options, **process) -> subprocess.CompletedProcess:
    return subprocess.run(bake_command(program, library, output, *options), stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, timeout=300, **process)


def is_hidden(name: str) -> bool:
    """Bookkeeping, or work in progress."""
    return name.endswith(".part") or any(part.startswith(".") for part in name.split("/"))


def files_of(folder: Path) -> dict[str, str]:
    """Every file and folder below, hidden ones too, with a hash of its bytes; "" for folders."""
    found = {}
    for parent, folders, files in os.walk(folder):
        for name in (*folders, *files):
            path = Path(parent) / name
            try:
                data = path.read_bytes() if name in files else b""
            except FileNotFoundError:
                continue  # gone meanwhile, with the process that another one replaced
            found[str(path.relative_to(folder))] = hashlib.sha256(data).hexdigest() if name in files else ""
    return found


def reports_below(folder: Path) -> int:
    """How many panoramas are complete. Folders may come and go meanwhile."""
    return sum("report.json" in files for parent, _, files in os.walk(folder)
               if not is_hidden(os.path.relpath(parent, folder)))


def visible(files: dict[str, str]) -> dict[str, str]:
    """What a user sees: without bookkeeping and work in progress."""
    return {name: digest for name, digest in files.items() if not is_hidden(name) and digest}


class Baked:
    """What an uninterrupted bake leaves: the measure of interrupted ones."""

    def __init__(self, output: Path):
        self.files = files_of(output)

    def complaints_about_whole(self, output: Path) -> list[str]:
        """What is wrong with a completed bake: anything missing, different or left over."""
        found = files_of(output)
        wrong = [f"missing: {name}" for name in self.files if name not in found]
        wrong += [f"left over: {name}" for name in found if name not in self.files]
        return wrong + self.complaints_about_part(output)

    def complaints_about_part(self, output: Path) -> list[str]:
        """What is wrong at any moment: a file that is not whole, a report before what it reports."""
        found = visible(files_of(output))
        wrong = [f"other bytes: {name}" for name in found if found[name] != self.files.get(name)]
        for name in found:
            folder, _, file = name.rpartition("/")
            if file == "report.json":
                wrong += [f"{name} is there, {other} is not" for other in visible(self.files)
                          if other.rpartition("/")[0] == folder and other not in found]
        return wrong
