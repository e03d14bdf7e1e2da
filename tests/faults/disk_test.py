"""splitsum-bake on a disk that fails at every one of its changes in turn: whatever is seen is whole, the
exit code says what happened, and running again completes the library.
Usage: disk_test.py SPLITSUM_BAKE FAULT_SHIM"""

import os
import shutil
import sys
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from small_library import Baked, bake, files_of, is_hidden, write_library

PANORAMAS = 1  # every change of one panorama, the table and the bookkeeping


class DiskThatFails(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = Path(temporary.name)
        cls.library = write_library(cls.folder / "library", PANORAMAS)
        count = cls.folder / "count"
        run = cls.bake(cls.folder / "whole", "none", 0, SPLITSUM_FAULT_COUNT=str(count))
        assert run.returncode == 0, run.stderr
        cls.whole = Baked(cls.folder / "whole")
        cls.calls = int(count.read_text())

    @classmethod
    def bake(cls, output: Path, fault: str, at: int, *options, **settings):
        environment = {**os.environ, "LD_PRELOAD": str(SHIM), "SPLITSUM_FAULT": fault,
                       "SPLITSUM_FAULT_AT": str(at), "SPLITSUM_FAULT_FOLDER": str(output),
                       "ASAN_OPTIONS": "verify_asan_link_order=0", **settings}
        return bake(PROGRAM, cls.library, output, "--threads", "1", *options, env=environment)

    def every_call(self, fault: str, codes: set[int], step: int = 1, may_leave_work: bool = True):
        """Each call in turn meets the fault; then the program is run again without it."""
        def complaints(at: int) -> tuple[list[str], int]:
            output = self.folder / f"{fault} {at}"
            run = self.bake(output, fault, at)
            wrong = self.whole.complaints_about_part(output)
            if run.returncode not in codes:
                wrong.append(f"exit code {run.returncode}: {run.stderr}")
            if run.returncode == 0:  # it was complete by then, or what failed does not matter
                wrong += self.whole.complaints_about_whole(output)
            if not may_leave_work:
                wrong += [f"left over: {name}" for name in files_of(output)
                          if is_hidden(name) and name not in self.whole.files]
            again = bake(PROGRAM, self.library, output, "--threads", "1")
            if again.returncode != 0:
                wrong.append(f"again, exit code {again.returncode}: {again.stderr}")
            wrong += self.whole.complaints_about_whole(output)
            shutil.rmtree(output, ignore_errors=True)
            return wrong, run.returncode

        moments = range(0, self.calls, step)
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            outcomes = list(pool.map(complaints, moments))
        for at, (wrong, _) in zip(moments, outcomes):
            self.assertEqual(wrong, [], f"{fault} at call {at} of {self.calls}")
        self.assertGreater(sum(code != 0 for _, code in outcomes), 0.8 * len(outcomes))

    def test_the_shim_sees_every_file(self):
        files = [name for name, digest in self.whole.files.items() if digest]
        self.assertGreater(len(files), 5)
        # Each is at least made, written, made durable and renamed.
        self.assertGreater(self.calls, 3 * len(files))

    def test_killed_at_every_change(self):
        self.every_call("kill", {-9})

    def test_full_from_every_change_on(self):
        self.every_call("full", {4, 0})

    def test_read_only_from_some_changes_on(self):
        self.every_call("read-only", {4, 0}, step=3)

    def test_terminated_at_some_changes(self):
        self.every_call("terminate", {130, 0}, step=3, may_leave_work=False)


if __name__ == "__main__":
    PROGRAM, SHIM = Path(sys.argv[1]), Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
