#!/usr/bin/env python3
"""check_report_schema.py SPLITSUM_BAKE SCHEMA PANORAMA...

Bakes every panorama in several ways and holds each report.json to the published schema, by a
validator that is not ours. Then spoils a report in every place: the schema must notice.
Exits with 77 (skipped) where Python has no jsonschema.
"""
import copy
import json
import pathlib
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    print("skipped: this Python has no jsonschema (Debian: python3-jsonschema)")
    sys.exit(77)

SMALL = ["--size", "8", "--levels", "3", "--irradiance-size", "4", "--table-size", "4", "--quiet"]
WAYS = [
    [],
    ["--no-verify"],
    ["--probes", "1000", "--format", "rgb9e5", "--no-picture"],
    ["--method", "importance", "--irradiance-store-e", "--exposure", "-1.5", "--rotate", "30"],
    ["--roughness", "0,0.3,1", "--irradiance-order", "0", "--zstd"],
]


def reports(program, panoramas):
    for way in WAYS:
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([program, *panoramas, "-o", folder, *SMALL, *way], check=True,
                           stdout=subprocess.DEVNULL)
            for path in sorted(pathlib.Path(folder).glob("*/report.json")):
                yield f"{path.parent.name} {' '.join(way)}", json.loads(path.read_text())


def places(value, path=()):
    """The path of everything in a JSON value, but for keys of files and options, which may change."""
    yield path
    if path == ("settings",) or path[:1] == ("asked",) and len(path) == 2:
        return
    items = value.items() if isinstance(value, dict) else \
        enumerate(value) if isinstance(value, list) else ()
    for key, part in items:
        yield from places(part, (*path, key))


def spoilt(report):
    """(what was done, a report that is none)"""
    for path in places(report):
        if not path:
            continue
        for what in ("removed", "of another kind", "with a stranger"):
            copied = copy.deepcopy(report)
            *parents, last = path
            owner = copied
            for key in parents:
                owner = owner[key]
            if what == "removed" and isinstance(owner, dict):
                del owner[last]
            elif what == "of another kind":
                owner[last] = {"no": "such thing"} if not isinstance(owner[last], dict) else 3
            elif what == "with a stranger" and isinstance(owner[last], dict):
                owner[last]["stranger"] = 1
            else:
                continue
            yield f"{path} {what}", copied


def main():
    program, schema_path, *panoramas = sys.argv[1:]
    schema = json.loads(pathlib.Path(schema_path).read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    problems = []
    checked = {name: report for name, report in reports(program, panoramas)}
    for name, report in checked.items():
        problems += [f"{name}: {list(error.absolute_path)}: {error.message}"
                     for error in validator.iter_errors(report)]
    if len(checked) != len(WAYS) * len(panoramas):
        problems.append(f"there were {len(checked)} reports only")
    spoilings = 0
    for what, report in spoilt(next(iter(checked.values()))):
        spoilings += 1
        if validator.is_valid(report):
            problems.append(f"the schema takes a report with {what}")
    print(f"{len(checked)} reports, {spoilings} spoilt ones")
    print("\n".join(problems))
    sys.exit(1 if problems or spoilings < 100 else 0)


if __name__ == "__main__":
    main()
