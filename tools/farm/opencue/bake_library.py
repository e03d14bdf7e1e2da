#!/usr/bin/env python3
"""A library as an OpenCue job: a frame for each shard, then one that checks the result.

    bake_library.py SHOW SHOT LIBRARY OUTPUT SHARDS [OPTION of splitsum-bake]...

Needs OpenCue's PyOutline, and a Cuebot that it is configured for."""

import getpass
import shlex
import sys

import outline
import outline.cuerun
import outline.modules.shell


def layers(library: str, output: str, shards: int, options: list[str]) -> list:
    # OpenCue joins a command with spaces and hands it to a shell; #IFRAME# is the frame's number.
    def quoted(*words: str) -> list[str]:
        return [shlex.quote(word) for word in ("splitsum-bake", library, "-o", output, *words, *options)]

    bake = outline.modules.shell.Shell(
        "bake", command=quoted() + ["--shard", f"#IFRAME#/{shards}"], range=f"1-{shards}", chunk=1)
    merge = outline.modules.shell.Shell("merge", command=quoted("--merge"), range="1", chunk=1)
    merge.depend_all(bake)
    return [bake, merge]


def main(arguments: list[str]) -> int:
    if len(arguments) < 5:
        print(__doc__, file=sys.stderr)
        return 2
    show, shot, library, output, shards, *options = arguments
    job = outline.Outline("splitsum_bake", show=show, shot=shot, user=getpass.getuser())
    for layer in layers(library, output, int(shards), options):
        job.add_layer(layer)
    # The commands are run as they are, without PyOutline on the hosts that render.
    outline.cuerun.launch(job, use_pycuerun=False)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
