"""An outside project that finds an installed Splitsum bakes with splitsum_bake: what has changed, and
nothing else. Usage: package_test.py BUILD_FOLDER SOURCE_FOLDER"""

import os
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
MANIFEST = """\
[[panoramas]]
file = "listed/night.hdr"
"""


def run(*command, folder: Path | None = None, fails: bool = False) -> str:
    """What a program prints; it must succeed, or fail where that is asked for."""
    done = subprocess.run([str(part) for part in command], cwd=folder, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300)
    if (done.returncode != 0) != fails:
        raise AssertionError(f"{command} ended with {done.returncode}:\n{done.stdout}")
    return done.stdout


def snapshot(folder: Path) -> dict[str, tuple[bytes, int]]:
    """Bytes and time of every file that is no bookkeeping."""
    return {str(file.relative_to(folder)): (file.read_bytes(), file.stat().st_mtime_ns)
            for file in sorted(folder.rglob("*")) if file.is_file() and not file.name.startswith(".")}


def touch(file: Path) -> None:
    """A new time, later than any file's."""
    later = time.time() + 2
    os.utime(file, (later, later))
    time.sleep(2.1)  # a file from the future would be newer than what is made from it


class OutsideProject:
    """Sources, and a build of them by one generator."""

    def __init__(self, folder: Path, generator: str):
        self.source = folder / "source of it"
        self.build = folder / "build of it"
        shutil.copytree(HERE / "outside", self.source)
        self.add("lopsided.exr", "the sky.exr")
        self.add("sunset.exr", "more/sunset.exr")
        self.add("one_texel.exr", "more/deeper/one.exr")
        self.add("night.hdr", "listed/night.hdr")
        (self.source / "bake.toml").write_text(MANIFEST)
        self.generator = generator
        self.configure()

    def add(self, sample: str, name: str) -> None:
        (self.source / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(PANORAMAS / sample, self.source / name)

    def configure(self, *settings) -> None:
        run("cmake", "-S", self.source, "-B", self.build, "-G", self.generator,
            f"-DCMAKE_PREFIX_PATH={prefix}", *settings)

    def make(self, **expected) -> str:
        return run("cmake", "--build", self.build, "--parallel", "4", **expected)

    def ran(self) -> dict[str, int]:
        """When each target's program ran last. Ninja alone knows when it need not."""
        stamps = {name: self.build / f"CMakeFiles/{name}.splitsum/stamp" for name in ("skies", "listed")}
        return {name: stamp.stat().st_mtime_ns for name, stamp in stamps.items() if stamp.exists()}


class SplitsumBake:
    """What must hold with every generator."""

    generator: str

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.project = OutsideProject(Path(cls.folder.name), cls.generator)
        cls.project.make()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def setUp(self):
        self.project.make()
        self.before = snapshot(self.project.build / "skies")
        self.ran = self.project.ran()

    def expect_runs(self, *targets):
        """After another build these ran once more, and then none has anything to do."""
        self.project.make()
        now = self.project.ran()
        if self.generator == "Ninja":
            self.assertEqual({name for name in now if now[name] != self.ran[name]}, set(targets))
        files = snapshot(self.project.build)
        self.project.make()
        self.assertEqual(self.project.ran(), now)
        self.assertEqual(self.baked(files), self.baked(snapshot(self.project.build)))

    @staticmethod
    def baked(files: dict) -> dict:
        """What a bake may write, and the rule that reads it."""
        return {name: state for name, state in files.items()
                if name.startswith(("skies/", "from a list/", "copied"))}

    def changed(self) -> set[str]:
        """The panoramas of `skies` whose files are not what they were, or have another time."""
        now = snapshot(self.project.build / "skies")
        names = [name for name in {*now, *self.before} if now.get(name) != self.before.get(name)]
        return {name.rpartition("/")[0] for name in names}

    def test_makes_every_asset(self):
        for name in ("skies/the sky", "skies/sunset", "skies/deeper/one", "from a list/night"):
            for asset in ("specular.ktx2", "irradiance.ktx2", "harmonics.json", "report.json"):
                self.assertTrue((self.project.build / name / asset).is_file(), f"{name}/{asset}")
        self.assertEqual((self.project.build / "copied.ktx2").read_bytes(),
                         (self.project.build / "skies/the sky/specular.ktx2").read_bytes())

    def test_does_nothing_twice(self):
        self.expect_runs()

    def test_a_touched_panorama_is_looked_at_and_left(self):
        touch(self.project.source / "more/sunset.exr")
        self.expect_runs("skies")
        self.assertEqual(self.changed(), set())

    def test_a_changed_panorama_is_baked_alone(self):
        self.project.add("studio.exr", "more/sunset.exr")
        touch(self.project.source / "more/sunset.exr")
        self.expect_runs("skies")
        self.assertEqual(self.changed(), {"sunset"})

    def test_a_new_panorama_of_a_folder_is_baked_alone(self):
        time.sleep(0.1)
        self.project.add("studio.exr", "more/deeper/new.exr")
        self.expect_runs("skies")
        self.assertEqual(self.changed(), {"deeper/new"})
        (self.project.source / "more/deeper/new.exr").unlink()
        self.project.make()  # a file that the last build read and that is gone is no error

    def test_a_panorama_in_a_folder_that_was_empty_is_found(self):
        (self.project.source / "more/empty").mkdir()
        self.project.make()
        self.ran = self.project.ran()
        time.sleep(0.1)
        self.project.add("studio.exr", "more/empty/new.exr")
        self.expect_runs("skies")
        self.assertEqual(self.changed(), {"empty/new"})
        shutil.rmtree(self.project.source / "more/empty")
        self.project.make()

    def test_a_changed_option_bakes_again(self):
        older = (self.project.build / "from a list/night/irradiance.ktx2").read_bytes()
        self.project.configure("-DWIDTH=16")
        self.expect_runs("listed")
        newer = (self.project.build / "from a list/night/irradiance.ktx2").read_bytes()
        self.assertGreater(len(newer), len(older))
        self.project.configure("-DWIDTH=8")
        self.project.make()
        self.assertEqual((self.project.build / "from a list/night/irradiance.ktx2").read_bytes(), older)

    def test_a_changed_manifest_bakes_again(self):
        time.sleep(0.1)
        (self.project.source / "bake.toml").write_text(MANIFEST + "exposure = 1\n")
        self.expect_runs("listed")

    def test_another_program_looks_at_everything(self):
        touch(prefix / "bin/splitsum-bake")
        self.expect_runs("skies", "listed")
        self.assertEqual(self.changed(), set())

    def test_a_lost_result_is_made_again(self):
        (self.project.build / "skies/the sky/specular.ktx2").unlink()
        self.expect_runs("skies")
        self.assertEqual(self.changed(), {"the sky"})

    def test_a_bad_panorama_fails_the_build_until_it_is_mended(self):
        time.sleep(0.1)
        (self.project.source / "more/bad.exr").write_bytes(b"no panorama")
        for _ in range(2):
            self.assertIn("bad.exr", self.project.make(fails=True))
        (self.project.source / "more/bad.exr").unlink()
        self.project.make()
        self.assertEqual(self.changed(), set())


class WithNinja(SplitsumBake, unittest.TestCase):
    generator = "Ninja"

    def test_ninja_says_that_nothing_is_to_do(self):
        self.assertIn("no work to do", self.project.make())


class WithMake(SplitsumBake, unittest.TestCase):
    generator = "Unix Makefiles"


class Package(unittest.TestCase):
    def configure(self, text: str) -> str:
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "CMakeLists.txt").write_text(
                f"cmake_minimum_required(VERSION 3.25)\nproject(p LANGUAGES NONE)\n{text}")
            return run("cmake", "-S", folder, "-B", f"{folder}/build", f"-DCMAKE_PREFIX_PATH={prefix}",
                       fails=True)

    def test_another_version_is_not_found(self):
        self.assertIn("compatible", self.configure("find_package(splitsum 0.2 REQUIRED)"))

    def test_nothing_to_bake_is_an_error(self):
        self.assertIn("nothing to bake",
                      self.configure("find_package(splitsum REQUIRED)\nsplitsum_bake(skies ALL)"))

    def test_an_unknown_option_is_an_error(self):
        with tempfile.TemporaryDirectory() as folder:
            project = OutsideProject(Path(folder), "Ninja")
            lists = project.source / "CMakeLists.txt"
            lists.write_text(lists.read_text().replace("--levels 3", "--levles 3"))
            self.assertIn("--levles", project.make(fails=True))

    def test_every_program_is_a_target(self):
        names = sorted(file.name for file in (prefix / "bin").iterdir())
        self.assertIn("splitsum-bake", names)
        checks = "".join(f"if(NOT TARGET splitsum::{name})\nmessage(FATAL_ERROR no-{name})\nendif()\n"
                         for name in names)
        output = self.configure(f"find_package(splitsum REQUIRED)\n{checks}message(FATAL_ERROR all-there)")
        self.assertIn("all-there", output)


if __name__ == "__main__":
    build, source = Path(sys.argv[1]), Path(sys.argv[2])
    PANORAMAS = source / "test_data/panoramas"
    with tempfile.TemporaryDirectory() as installed:
        prefix = Path(installed) / "in stalled"
        run("cmake", "--install", build, "--prefix", prefix)
        unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2, exit=False).result.wasSuccessful() \
            or sys.exit(1)
