"""A Slurm of its own on the loopback interface: munged, slurmctld and two slurmd, as the current
user, with every file in one temporary folder and ports that were free."""

import os
import pwd
import re
import shutil
import socket
import subprocess
import time
from pathlib import Path

from children import Children, command_of, descendants, end, environment_of

NODES = ("near", "far")

# A dead node is noticed after seconds, and its tasks may start again as soon: cred_expire is also how
# long Slurm holds back a task that it has requeued, two minutes unless told otherwise.
CONFIGURATION = """\
ClusterName=loopback
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort={controller_port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmctldPidFile={folder}/slurmctld.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdPidFile={folder}/%n.pid
SlurmdLogFile={folder}/%n.log
SlurmdSpoolDir={folder}/spool_%n
SlurmdTimeout=3
MessageTimeout=2
TCPTimeout=1
SlurmctldTimeout=10
KillWait=2
MinJobAge=3600
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
ReturnToService=1
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=100000
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
"""
NODE = "NodeName={name} NodeHostname=localhost NodeAddr=127.0.0.1 Port={port} CPUs=2 State=UNKNOWN\n"
PARTITION = "PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP\n"


def program(name: str) -> str:
    """Where a program is; those of the system's administrator are not in everybody's PATH."""
    found = shutil.which(name, path=os.environ.get("PATH", "") + ":/usr/sbin:/sbin")
    if not found:
        raise FileNotFoundError(f"there is no {name}; Debian's slurm-wlm and munge have it")
    return found


def free_ports(count: int) -> list[int]:
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [listening.getsockname()[1] for listening in sockets]
    for listening in sockets:
        listening.close()
    return ports


class SlurmCluster:
    def __init__(self, folder: Path, children: Children):
        self.folder = folder
        self.children = children
        self.environment = {**os.environ, "SLURM_CONF": str(folder / "slurm.conf")}
        self._write_configuration()
        self._start_munge()
        self._start(["slurmctld", "-D"], "slurmctld.out")
        for name in NODES:
            self.start_node(name)
        self._wait_for_nodes()

    def start_node(self, name: str) -> None:
        self._start(["slurmd", "-D", "-N", name], f"{name}.out")

    def kill_node(self, name: str) -> int:
        """Ends all processes of a node at once, as a power cut does, and waits until they are gone, with
        those that were just being started. Returns how many there were."""
        killed: set[int] = set()

        def gone() -> bool:
            mine = [process for process in descendants(os.getpid()) if self._is_of_node(process, name)]
            for process in mine:
                end(process)
            killed.update(mine)
            return not mine
        self._wait(gone, f"the end of node {name}", pause=0)
        return len(killed)

    def run(self, *command) -> str:
        """The output of a command of Slurm."""
        done = subprocess.run([program(command[0]), *map(str, command[1:])], env=self.environment,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60)
        if done.returncode != 0:
            raise RuntimeError(f"{' '.join(map(str, command))}: {done.stderr}{self.logs()}")
        return done.stdout

    def tasks(self, job: str) -> list[dict[str, str]]:
        """What Slurm knows about each task of a job: JobState, Restarts, NodeList, ..."""
        lines = self.run("scontrol", "show", "job", "-o", job).splitlines()
        return [dict(re.findall(r"(\w+)=(\S*)", line)) for line in lines if "JobId=" in line]

    def node_state(self, name: str) -> str:
        return self.run("sinfo", "-h", "-N", "-n", name, "-o", "%T").strip()

    def logs(self) -> str:
        """The end of every log, for a message."""
        text = ""
        for log in sorted([*self.folder.glob("*.log"), *self.folder.glob("*.out")]):
            lines = log.read_text(errors="replace").splitlines()[-25:]
            text += f"\n--- {log.name}\n" + "\n".join(lines)
        return text

    # slurmd itself, what it started for jobs, and slurmstepd, which stands between the two and has
    # a session of its own: the parent comes first, so that it cannot report the end of its child.
    def _is_of_node(self, process: int, name: str) -> bool:
        command = command_of(process)
        if os.path.basename(command[0]) == "slurmd":
            return name in command
        tree = [process, *descendants(process)] if command[0].startswith("slurmstepd") else [process]
        return any(environment_of(part).get("SLURMD_NODENAME") == name for part in tree)

    def _write_configuration(self) -> None:
        ports = free_ports(1 + len(NODES))
        text = CONFIGURATION.format(folder=self.folder, user=pwd.getpwuid(os.getuid()).pw_name,
                                    controller_port=ports[0])
        for name, port in zip(NODES, ports[1:]):
            text += NODE.format(name=name, port=port)
            (self.folder / f"spool_{name}").mkdir()
        (self.folder / "state").mkdir()
        (self.folder / "slurm.conf").write_text(text + PARTITION)

    def _start_munge(self) -> None:
        key = self.folder / "munge.key"
        key.touch(mode=0o600)
        key.write_bytes(os.urandom(128))
        files = [f"--{use}={self.folder}/munge.{ending}"
                 for use, ending in (("socket", "socket"), ("pid-file", "pid"), ("log-file", "log"),
                                     ("seed-file", "seed"), ("key-file", "key"))]
        # The folder is this user's alone, which munged takes for a mistake unless forced.
        self._start(["munged", "--foreground", "--force", *files], "munged.out")
        self._wait(lambda: (self.folder / "munge.socket").exists(), "munged")

    def _wait_for_nodes(self) -> None:
        def ready() -> bool:
            try:
                return all(self.node_state(name) == "idle" for name in NODES)
            except RuntimeError:
                return False  # the controller does not answer yet
        self._wait(ready, "the nodes")

    def _start(self, command: list[str], log: str) -> None:
        self.children.start([program(command[0]), *command[1:]], self.folder / log,
                            env=self.environment)

    def _wait(self, ready, what: str, seconds: float = 60, pause: float = 0.2) -> None:
        deadline = time.monotonic() + seconds
        while not ready():
            if time.monotonic() > deadline:
                raise RuntimeError(f"{what}: not ready after {seconds} s{self.logs()}")
            time.sleep(pause)
