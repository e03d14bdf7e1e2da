#!/usr/bin/env python3
"""Runs measure_captures.py on a small panorama and holds its two files to what was asked for.

Usage: measure_captures_test.py BUILD_FOLDER PANORAMA
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).with_name("measure_captures.py")
BUILD = pathlib.Path(sys.argv[1])
PANORAMA = pathlib.Path(sys.argv[2])


def measure(folder, *arguments):
    return subprocess.run([sys.executable, "-B", SCRIPT, "--build", BUILD, "-o", folder, "--sizes",
                           "32x4", "--repeats", "1", "--samples", "256", *arguments],
                          capture_output=True, text=True)


class MeasureCaptures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.outcome = measure(cls.folder.name, PANORAMA, "--curves", "linear", "--probes", "64",
                          "--methods", "filtered", "importance", "--large", "64")
        output = pathlib.Path(cls.folder.name)
        if cls.outcome.returncode == 0:
            cls.document = json.loads((output / "measured.json").read_text())
            cls.page = (output / "measured.md").read_text()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def setUp(self):
        self.assertEqual(self.outcome.returncode, 0, self.outcome.stderr)

    def test_every_combination_is_there_with_all_levels(self):
        found = {(r["method"], r["format"], len(r["levels"])) for r in self.document["chains"]}
        self.assertEqual(found, {(m, f, 4) for m in ("filtered", "importance")
                                 for f in ("rgba16f", "rgba32f")})
        self.assertEqual([r["capture"] for r in self.document["large"]], 2 * ["generated_64"])

    def test_filtering_alone_is_timed_on_one_thread_and_on_all(self):
        found = {r["method"]: r for r in self.document["in_memory"]}
        self.assertEqual(set(found), {"filtered", "importance"})
        for result in found.values():
            self.assertGreater(result["ms_1_thread"], 0)
            self.assertGreater(result["ms_all"], 0)
            self.assertGreater(result["rel_rms"], 0)
        self.assertRegex(self.page, r"\| filtered \| .* ms \(1\.0\)")

    def test_the_figures_are_of_the_right_asset(self):
        for result in self.document["chains"]:
            roughness = [level["perceptual_roughness"] for level in result["levels"]]
            self.assertEqual(roughness[0::3], [0, 1])
            # The format alone is 2e-4 away, so 0 would mean that nothing was compared.
            for level in result["levels"]:
                self.assertGreater(level["max_rel"], 0)
                self.assertLess(abs(level["bias"]), 1)

    def test_times_are_beside_those_of_reading(self):
        for result in self.document["chains"] + self.document["large"]:
            self.assertGreater(result["read_only_s"], 0)
            self.assertAlmostEqual(result["beyond_reading_s"],
                                   result["process_s"] - result["read_only_s"])
            self.assertGreater(result["peak_mb"], 1)

    def test_the_page_has_a_row_for_every_level(self):
        rows = [line for line in self.page.splitlines() if line.startswith(f"| {PANORAMA.stem} |")]
        # Formats times (methods and levels), and methods in memory.
        self.assertEqual(len(rows), 2 * (2 + 4) + 2)

    def test_all_methods_are_measured_unless_some_are_named(self):
        with tempfile.TemporaryDirectory() as folder:
            run = measure(folder, PANORAMA, "--probes", "0", "--curves", "linear", "--formats",
                          "rgba16f")
            self.assertEqual(run.returncode, 0, run.stderr)
            document = json.loads((pathlib.Path(folder) / "measured.json").read_text())
            methods = [result["method"] for result in document["chains"]]
            self.assertIn("importance", methods)
            self.assertIn("filtered", methods)
            self.assertNotIn("reference", methods)

    def test_a_capture_that_cannot_be_read_leaves_no_page(self):
        with tempfile.TemporaryDirectory() as folder:
            run = measure(folder, pathlib.Path(folder) / "missing.hdr")
            self.assertEqual(run.returncode, 1)
            self.assertIn("missing.hdr", run.stderr)
            self.assertEqual(list(pathlib.Path(folder).iterdir()), [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
