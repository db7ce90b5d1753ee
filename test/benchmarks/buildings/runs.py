# SPDX-License-Identifier: BSD-3-Clause
"""Scans, models and grades scenes, seed by seed: what random_buildings.py and random_shapes.py share."""
import argparse
import csv
import json
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]


def parser(description, things):
    options = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("first", type=int)
    options.add_argument("last", type=int)
    options.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin", help="folder of the programs")
    options.add_argument("--sedr", type=pathlib.Path, help="another pcl_sedr than that of --bin")
    options.add_argument("--options", default="", help="options of pcl_sedr beside --no-mesh, in one argument")
    options.add_argument("--csv", type=pathlib.Path, help="the table; else it goes to the standard output")
    options.add_argument("--keep-failures", type=pathlib.Path, metavar="DIR",
                         help=f"where scene, scan, result and picture of {things} go that are not all right")
    options.add_argument("--folder", type=pathlib.Path, help="where scans go while they are needed")
    options.add_argument("--timeout", type=float, default=600, help="seconds a run of pcl_sedr may take")
    return options


def run(command, timeout):
    """Exit code, seconds and the last line of the messages; 124 if the time was up."""
    start = time.monotonic()
    try:
        done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, timeout=timeout, check=False)
        code, text = done.returncode, done.stderr.decode(errors="replace").strip()
    except subprocess.TimeoutExpired:
        code, text = 124, f"no end after {timeout:g} s"
    return code, time.monotonic() - start, text.splitlines()[-1] if text else ""


def scan(scene, seed, folder, options, *more):
    """Scan and truth of a scene; the row of the table so far."""
    start = time.monotonic()
    (folder / "scene.json").write_text(json.dumps(scene), encoding="utf-8")
    code, _, text = run([options.bin / "pcl_simulate_indoor_scan", folder / "scene.json", folder, "--seed", str(seed), *more], 600)
    if code != 0:
        raise RuntimeError(f"seed {seed}: {text}")
    return {"seed": seed, "kind": scene["name"].rsplit("_", 1)[0], "points": (folder / "scan.pcd").stat().st_size // 20,
            "seconds_scan": round(time.monotonic() - start, 1)}


def model(folder, options):
    """What pcl_sedr made of the scan, as columns of the table; its results are in folder/out."""
    command = [options.sedr or options.bin / "pcl_sedr", folder / "scan.pcd", folder / "out", "--no-mesh"]
    code, seconds, text = run(command + shlex.split(options.options), options.timeout)
    return {"exit": code, "seconds": round(seconds, 1)}, text if code != 0 else ""


def keep(folder, row, options):
    """Where a scene that is not all right stays, with its scan and result; None if it need not."""
    if not options.keep_failures or row["all_right"]:
        return None
    kept = options.keep_failures / f"{row['kind']}_{row['seed']}"
    shutil.rmtree(kept, ignore_errors=True)
    shutil.copytree(folder, kept)
    return kept


def all_seeds(options, programs, one, summary):
    """Grades the scenes of all seeds by one(seed, folder, options), writes the table and prints its summary."""
    name = pathlib.Path(sys.argv[0]).name
    if options.last < options.first:
        sys.exit(f"{name}: LAST is less than FIRST")
    for program in [options.bin / p for p in programs] + [options.sedr or options.bin / "pcl_sedr"]:
        if not program.exists():
            sys.exit(f"{name}: there is no program {program}; build it, or see --bin and --sedr")
    rows, failed = [], 0
    table = open(options.csv, "w", newline="", encoding="utf-8") if options.csv else sys.stdout
    for seed in range(options.first, options.last + 1):
        with tempfile.TemporaryDirectory(dir=options.folder) as folder:
            try:
                row = one(seed, pathlib.Path(folder), options)
            except RuntimeError as error:
                print(f"{name}: {error}", file=sys.stderr)
                failed += 1
                continue
        writer = csv.DictWriter(table, row.keys())
        if not rows:
            writer.writeheader()
        writer.writerow(row)
        table.flush()
        rows.append(row)
    if rows:
        print(summary(rows))
    sys.exit(1 if failed else 0)
