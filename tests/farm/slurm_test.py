"""100 panoramas as a job array over two Slurm nodes, one of which dies half-way: its tasks are requeued,
the merge holds, and the bytes are those of one process alone.
Usage: slurm_test.py SPLITSUM_BAKE RECIPES"""

import contextlib
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))
from children import Children, command_of, descendants, environment_of
from slurm_cluster import SlurmCluster
from small_library import SMALL, Baked, bake, reports_below, write_library

PANORAMAS = 100
SHARDS = 10
SECONDS = 180


class Slurm(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        self.library = write_library(self.folder / "library", PANORAMAS)
        self.output = self.folder / "output"
        children = Children()
        children.__enter__()
        self.addCleanup(children.__exit__)
        for name in ("cluster", "logs"):
            (self.folder / name).mkdir()
        self.cluster = SlurmCluster(self.folder / "cluster", children)

    def submit(self) -> tuple[str, str]:
        environment = {**self.cluster.environment,
                       "PATH": f"{PROGRAM.parent}:{os.environ['PATH']}"}
        done = subprocess.run([RECIPES / "slurm/submit_library.sh", self.library, self.output,
                               str(SHARDS), *SMALL], env=environment, cwd=self.folder / "logs",
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        array, merge = done.stdout.split()
        return array, merge

    def bakes_on(self, node: str) -> list[int]:
        return [process for process in descendants(os.getpid())
                if os.path.basename(command_of(process)[0]) == "splitsum-bake"
                and environment_of(process).get("SLURMD_NODENAME") == node]

    def hold_a_bake_on(self, node: str) -> bool:
        """Stops a bake in its middle, so that it is still there when the node dies."""
        for process in self.bakes_on(node):
            with contextlib.suppress(ProcessLookupError):
                os.kill(process, signal.SIGSTOP)
        return bool(self.bakes_on(node))

    def wait_until(self, reached, what: str) -> None:
        deadline = time.monotonic() + SECONDS
        while not reached():
            if time.monotonic() > deadline:
                self.fail(f"{what}: not after {SECONDS} s\n{self.output_of_jobs()}{self.cluster.logs()}")
            time.sleep(0.01)

    def output_of_jobs(self) -> str:
        return "".join(f"--- {log.name}\n{log.read_text()}"
                       for log in sorted((self.folder / "logs").iterdir()))

    def states(self, job: str) -> list[str]:
        return [task["JobState"] for task in self.cluster.tasks(job)]

    def wait_for(self, job: str) -> None:
        over = {"COMPLETED", "FAILED", "CANCELLED", "NODE_FAIL", "TIMEOUT", "OUT_OF_MEMORY"}

        def ended() -> bool:
            time.sleep(0.2)  # Slurm is asked less often than the disk
            return set(self.states(job)) <= over
        self.wait_until(ended, f"the end of job {job}")

    def test_a_library_survives_the_loss_of_a_node(self):
        array, merge = self.submit()
        self.wait_until(lambda: reports_below(self.output) > PANORAMAS // 3
                        and self.hold_a_bake_on("far"), "a third of the library")
        self.assertGreater(self.cluster.kill_node("far"), 2)
        self.assertEqual(self.bakes_on("far"), [])

        self.wait_for(array)
        self.assertEqual(set(self.states(array)), {"COMPLETED"}, self.output_of_jobs())
        restarts = sum(int(task["Restarts"]) for task in self.cluster.tasks(array))
        self.assertGreater(restarts, 0, "no task was requeued")
        self.assertTrue(self.cluster.node_state("far").startswith("down"))

        self.wait_for(merge)
        self.assertEqual(self.states(merge), ["COMPLETED"], self.output_of_jobs())

        alone = bake(PROGRAM, self.library, self.folder / "alone")
        self.assertEqual(alone.returncode, 0, alone.stderr)
        whole = Baked(self.folder / "alone")
        self.assertEqual(whole.complaints_about_whole(self.output), [])
        self.assertEqual(reports_below(self.output), PANORAMAS)

    def test_the_merge_fails_where_a_shard_is_missing(self):
        write_library(self.library / "more", 2)
        (self.library / "more/broken.hdr").write_bytes(b"no panorama")
        array, merge = self.submit()
        self.wait_for(array)
        self.wait_for(merge)
        self.assertEqual(self.states(array).count("FAILED"), 1, self.output_of_jobs())
        self.assertEqual(self.states(merge), ["FAILED"], self.output_of_jobs())
        log = (self.folder / f"logs/slurm-{merge}.out").read_text()
        self.assertIn("broken", log)


if __name__ == "__main__":
    PROGRAM, RECIPES = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
