"""Programs that a test starts, and their end: whatever they start in turn, under whatever session or
parent, is found and ended when the block is left, also after a failure."""

import ctypes
import os
import signal
import subprocess
import time
from pathlib import Path

_PR_SET_PDEATHSIG = 1
_PR_SET_CHILD_SUBREAPER = 36
_libc = ctypes.CDLL(None, use_errno=True)


def descendants(ancestor: int) -> list[int]:
    """Every process below `ancestor`, parents before their children."""
    children: dict[int, list[int]] = {}
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            fields = (folder / "stat").read_text().rpartition(")")[2].split()
        except OSError:
            continue  # it has ended meanwhile
        children.setdefault(int(fields[1]), []).append(int(folder.name))
    found = [ancestor]
    for process in found:
        found += children.get(process, [])
    return found[1:]


def environment_of(process: int) -> dict[str, str]:
    """What a process was started with; nothing where it may not be read."""
    try:
        entries = Path(f"/proc/{process}/environ").read_bytes().split(b"\0")
    except OSError:
        return {}
    return dict(entry.decode(errors="replace").split("=", 1) for entry in entries if b"=" in entry)


def command_of(process: int) -> list[str]:
    """The program and its arguments; one empty string where it has ended."""
    try:
        return Path(f"/proc/{process}/cmdline").read_bytes().decode(errors="replace").split("\0")
    except OSError:
        return [""]


def end(process: int) -> None:
    try:
        os.kill(process, signal.SIGKILL)
    except ProcessLookupError:
        pass


def _die_with_parent() -> None:
    _libc.prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)


class Children:
    """with Children() as children: no descendant of this process outlives the block."""

    def __enter__(self) -> "Children":
        # Daemons whose parent ends become children of this process instead of the system's first.
        if _libc.prctl(_PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0) != 0:
            raise OSError(ctypes.get_errno(), "cannot adopt the processes of a test")
        self._started: list[subprocess.Popen] = []
        return self

    def start(self, command: list, log: Path, **options) -> subprocess.Popen:
        """A program in the background that prints into `log`."""
        with open(log, "ab") as stream:
            child = subprocess.Popen([str(part) for part in command], stdin=subprocess.DEVNULL,
                                     stdout=stream, stderr=stream, preexec_fn=_die_with_parent,
                                     **options)
        self._started.append(child)
        return child

    def __exit__(self, *_) -> None:
        deadline = time.monotonic() + 20
        while (left := descendants(os.getpid())) and time.monotonic() < deadline:
            for process in left:
                end(process)
            for child in self._started:
                child.poll()
            self._reap()
            time.sleep(0.02)
        if left:
            raise RuntimeError(f"cannot end the processes {left}")

    @staticmethod
    def _reap() -> None:
        try:
            while os.waitpid(-1, os.WNOHANG)[0]:
                pass
        except ChildProcessError:
            pass
