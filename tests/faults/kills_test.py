"""splitsum-bake killed at random moments, again and again: after every kill what is seen is whole, and
in the end the library is what an uninterrupted run leaves.
Usage: kills_test.py SPLITSUM_BAKE KILLS alone|cache|pair [SEED]"""

import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from small_library import Baked, bake, bake_command, write_library

PANORAMAS = 8


def check(wrong: list[str], when: str) -> None:
    if wrong:
        sys.exit(f"{when}:\n  " + "\n  ".join(wrong))


class Killing:
    def __init__(self, program: Path, folder: Path, seed: int, with_cache: bool):
        self.program = program
        self.folder = folder
        self.output = folder / "output"
        self.moments = random.Random(seed)
        self.library = write_library(folder / "library", PANORAMAS)
        self.options = ["--threads", "2"]
        if with_cache:
            self.options += ["--cache", folder / "cache"]
        self.whole, self.seconds = self._uninterrupted()
        self.kills = 0
        self.completed = 0

    def _uninterrupted(self) -> tuple[Baked, float]:
        output = self.folder / "whole"
        start = time.monotonic()
        run = bake(self.program, self.library, output, "--threads", "2")
        seconds = time.monotonic() - start
        check([run.stderr] if run.returncode else [], "uninterrupted")
        return Baked(output), seconds

    def round(self, processes: int) -> None:
        """Some processes at once, one of which is killed unless it is done before."""
        command = bake_command(self.program, self.library, self.output, *self.options)
        running = [subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                    stderr=subprocess.PIPE, text=True) for _ in range(processes)]
        # Before main nothing can happen, and that is a third of the time.
        time.sleep(self.moments.uniform(0.25, 1) * self.seconds)
        victim = running[self.moments.randrange(processes)]
        victim.kill()
        messages = [process.communicate(timeout=120)[1] for process in running]
        killed = victim.returncode == -9
        self.kills += killed
        # As long as a run takes now: much of the library may be there, and the machine be busy.
        self.seconds *= 1.05 if killed else 0.9
        for process, message in zip(running, messages):
            if process.returncode not in (0, -9):
                check([message], f"exit code {process.returncode} beside a kill")
        check(self.whole.complaints_about_part(self.output), f"after kill {self.kills}")
        if all(process.returncode == 0 for process in running):
            self.complete()

    def complete(self) -> None:
        """Runs to the end, compares, and begins anew."""
        run = bake(self.program, self.library, self.output, *self.options)
        check([run.stderr] if run.returncode else [], f"completing after {self.kills} kills")
        check(self.whole.complaints_about_whole(self.output), f"complete after {self.kills} kills")
        self.completed += 1
        shutil.rmtree(self.output)
        # Now and then the cache has to be filled again.
        if self.completed % 3 == 0:
            shutil.rmtree(self.folder / "cache", ignore_errors=True)


def main(program: str, kills: str, manner: str, seed: str = "1") -> None:
    with tempfile.TemporaryDirectory() as folder:
        killing = Killing(Path(program), Path(folder), int(seed), manner == "cache")
        rounds = 0
        while killing.kills < int(kills):
            killing.round(2 if manner == "pair" else 1)
            rounds += 1
            if rounds % 10 == 0:
                killing.complete()
            if rounds > 5 * int(kills):
                sys.exit(f"only {killing.kills} kills in {rounds} rounds: the program ends too early")
        killing.complete()
        print(f"{killing.kills} kills in {rounds} rounds, {killing.completed} libraries completed")


if __name__ == "__main__":
    main(*sys.argv[1:])
