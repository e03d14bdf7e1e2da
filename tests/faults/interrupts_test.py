"""splitsum-bake asked to stop, and losing a panorama under its hands.
Usage: interrupts_test.py SPLITSUM_BAKE"""

import random
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from small_library import Baked, bake, bake_command, files_of, is_hidden, reports_below, write_library


class Interrupted(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def start(self, library: Path, output: Path, *options) -> subprocess.Popen:
        process = subprocess.Popen(bake_command(PROGRAM, library, output, *options),
                                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.kill)
        return process

    def test_a_signal_ends_a_run_cleanly_and_another_completes_it(self):
        library = write_library(self.folder / "library", 20)
        start = time.monotonic()
        self.assertEqual(bake(PROGRAM, library, self.folder / "whole", "--threads", "2").returncode, 0)
        seconds = time.monotonic() - start
        whole = Baked(self.folder / "whole")
        moments = random.Random(7)
        stopped = 0
        for attempt in range(16):
            output = self.folder / f"output {attempt}"
            process = self.start(library, output, "--threads", "2")
            # Before main a signal ends the process as it ends any other.
            time.sleep(moments.uniform(0.35, 0.9) * seconds)
            process.send_signal(moments.choice((signal.SIGINT, signal.SIGTERM)))
            message = process.communicate(timeout=60)[1]
            code = process.returncode
            before_main = code in (-signal.SIGINT, -signal.SIGTERM)
            self.assertTrue(code in (0, 130) or (before_main and not files_of(output)), message)
            if code == 130:
                stopped += 1
                self.assertIn("the same command", message)  # how to go on
            self.assertEqual(whole.complaints_about_part(output), [])
            self.assertEqual([name for name in files_of(output)
                              if is_hidden(name) and name not in whole.files], [])
            again = bake(PROGRAM, library, output)
            self.assertEqual(again.returncode, 0, again.stderr)
            self.assertEqual(whole.complaints_about_whole(output), [])
        self.assertGreater(stopped, 4, "hardly any signal came in time")

    def test_a_panorama_that_disappears_fails_itself_only(self):
        library = write_library(self.folder / "library", 60)
        output = self.folder / "output"
        process = self.start(library, output, "--threads", "1")
        deadline = time.monotonic() + 60
        while reports_below(output) == 0 and time.monotonic() < deadline:
            time.sleep(0.001)
        waiting = [file for file in sorted(library.rglob("*.hdr")) if not self.begun(library, output, file)]
        # From both ends of the list, as the order of work is nobody's business.
        victims = [waiting[-1], waiting[-2], waiting[0]]
        for victim in victims:
            victim.unlink()
        message = process.communicate(timeout=120)[1]
        lost = [victim for victim in victims if not (self.target(library, output, victim) / "report.json").exists()]
        self.assertTrue(lost, "all of them had been read before they went")
        self.assertEqual(process.returncode, 3, message)
        for victim in lost:
            self.assertIn(victim.name, message)
        for file in library.rglob("*.hdr"):
            self.assertTrue((self.target(library, output, file) / "report.json").exists(), file)

    @staticmethod
    def target(library: Path, output: Path, panorama: Path) -> Path:
        return output / panorama.relative_to(library).with_suffix("")

    def begun(self, library: Path, output: Path, panorama: Path) -> bool:
        return self.target(library, output, panorama).exists()


if __name__ == "__main__":
    PROGRAM = Path(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]], verbosity=2)
