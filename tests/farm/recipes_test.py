"""The recipes for GNU parallel, Kubernetes and OpenCue: their own files, with stand-ins for what is not
here. Usage: recipes_test.py SPLITSUM_BAKE RECIPES"""

import os
import re
import shlex
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import yaml

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from small_library import SMALL, Baked, bake, files_of, write_library

# In place of ssh: `gone` cannot be reached, every other host is this one.
SSH = """\
#!/bin/sh
while case $1 in -*) true ;; *) false ;; esac; do shift; done
host=$1
shift
echo "$host" >>{hosts}
if [ "$host" = gone ]; then echo "ssh: no route to $host" >&2; exit 255; fi
exec /bin/sh -c "$*"
"""

# In place of PyOutline: keeps the layers, and runs their frames as OpenCue does.
OUTLINE = """\
import subprocess

def _run(layer):
    first, _, last = layer.settings["range"].partition("-")
    for frame in range(int(first), int(last or first) + 1):
        command = " ".join(layer.settings["command"]).replace("#IFRAME#", str(frame))
        print(layer.name, command, flush=True)
        subprocess.run(command, shell=True, check=True)

class Layer:
    def __init__(self, name, **settings):
        self.name, self.settings, self.after = name, settings, None

    def depend_all(self, layer):
        self.after = layer

class Outline:
    def __init__(self, name, show, shot, user):
        self.layers = []

    def add_layer(self, layer):
        assert layer.after in (None, *self.layers)
        self.layers.append(layer)

def launch(job, use_pycuerun):
    assert not use_pycuerun
    for layer in job.layers:
        _run(layer)
"""


class Recipe(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        # Names that a shell would take apart.
        self.library = write_library(self.folder / "a library's $HOME", 10)
        self.output = self.folder / "the output"
        self.environment = {**os.environ, "HOME": str(self.folder),
                            "PATH": f"{PROGRAM.parent}:{os.environ['PATH']}"}

    def run_recipe(self, *command, code: int = 0, **settings) -> subprocess.CompletedProcess:
        done = subprocess.run([str(part) for part in command], env={**self.environment, **settings},
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def expect_whole(self) -> None:
        alone = bake(PROGRAM, self.library, self.folder / "alone")
        self.assertEqual(alone.returncode, 0, alone.stderr)
        self.assertEqual(Baked(self.folder / "alone").complaints_about_whole(self.output), [])


class GnuParallel(Recipe):
    def test_bakes_here_and_on_other_computers(self):
        ssh = self.folder / "ssh"
        ssh.write_text(SSH.format(hosts=shlex.quote(str(self.folder / "hosts"))))
        ssh.chmod(0o755)
        self.run_recipe(RECIPES / "gnu-parallel/bake_library.sh", self.library, self.output, "5", *SMALL,
                        PARALLEL=f"--ssh {ssh} --sshlogin 1/:,1/near,1/gone")
        asked = set((self.folder / "hosts").read_text().split())
        self.assertEqual(asked, {"near", "gone"})
        self.expect_whole()

    def test_ends_with_the_code_of_the_merge(self):
        (self.library / "broken.hdr").write_bytes(b"no panorama")
        done = self.run_recipe(RECIPES / "gnu-parallel/bake_library.sh", self.library, self.output, "3",
                               *SMALL, code=1)
        self.assertIn("broken", done.stderr)


class Kubernetes(Recipe):
    def job(self, name: str) -> dict:
        documents = list(yaml.safe_load_all((RECIPES / "kubernetes" / name).read_text()))
        self.assertEqual(len(documents), 1)
        job = documents[0]
        self.assertEqual((job["apiVersion"], job["kind"]), ("batch/v1", "Job"))
        return job

    def run_container(self, job: dict, **variables) -> None:
        """Runs the command of a pod with the folders of this test at the places of its volumes."""
        container, = job["spec"]["template"]["spec"]["containers"]
        volumes = {volume["name"] for volume in job["spec"]["template"]["spec"]["volumes"]}
        places = {"library": self.library, "baked": self.output}
        words = container["command"] + container.get("args", [])
        for mount in container["volumeMounts"]:
            self.assertIn(mount["name"], volumes)
            at = re.compile(re.escape(mount["mountPath"]) + r"\b")
            name = str(places[mount["name"]])
            words = [at.sub(lambda _: shlex.quote(name) if " " in word else name, word) for word in words]
        variables |= {entry["name"]: entry["value"] for entry in container.get("env", [])}
        # The options that keep this test short stand where a user's own would.
        words[-1] = " ".join([words[-1], *SMALL]) if words[0] == "/bin/sh" else words[-1]
        more = [] if words[0] == "/bin/sh" else SMALL
        self.run_recipe(*words, *more, **variables)

    def test_every_pod_bakes_its_part(self):
        job = self.job("bake_library.yaml")
        spec = job["spec"]
        self.assertEqual(spec["completionMode"], "Indexed")
        self.assertLessEqual(spec["parallelism"], spec["completions"])
        # What the API server would refuse: a policy for failed pods asks for this.
        self.assertEqual(spec["template"]["spec"]["restartPolicy"], "Never")
        names = {container["name"] for container in spec["template"]["spec"]["containers"]}
        for rule in spec["podFailurePolicy"]["rules"]:
            self.assertIn(rule.get("onExitCodes", {}).get("containerName", "bake"), names)
        for index in range(spec["completions"]):
            self.run_container(job, JOB_COMPLETION_INDEX=str(index))
        self.run_container(self.job("merge_library.yaml"))
        self.expect_whole()

    def test_the_jobs_agree(self):
        bake_job, merge_job = self.job("bake_library.yaml"), self.job("merge_library.yaml")

        def pod(job):
            return job["spec"]["template"]["spec"]
        self.assertEqual(pod(bake_job)["containers"][0]["image"], pod(merge_job)["containers"][0]["image"])
        shards = [entry["value"] for entry in pod(bake_job)["containers"][0]["env"]
                  if entry["name"] == "SHARDS"]
        self.assertEqual(shards, [str(bake_job["spec"]["completions"])])


class OpenCue(Recipe):
    def test_every_frame_bakes_its_part(self):
        package = self.folder / "python/outline"
        (package / "modules").mkdir(parents=True)
        (package / "__init__.py").write_text(OUTLINE)
        (package / "cuerun.py").write_text("from outline import launch\n")
        (package / "modules/__init__.py").write_text("")
        (package / "modules/shell.py").write_text("from outline import Layer as Shell\n")
        done = self.run_recipe(sys.executable, RECIPES / "opencue/bake_library.py", "show", "shot",
                               self.library, self.output, "4", *SMALL,
                               PYTHONPATH=str(package.parent), PYTHONDONTWRITEBYTECODE="1")
        names = [line.split()[0] for line in done.stdout.splitlines() if "splitsum-bake" in line.split()]
        self.assertEqual(names, ["bake"] * 4 + ["merge"])
        self.expect_whole()
        self.assertEqual(sum(name.endswith("report.json") for name in files_of(self.output)), 10)


if __name__ == "__main__":
    PROGRAM, RECIPES = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
