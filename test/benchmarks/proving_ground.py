#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the proving ground (doc/proving_ground.md): proving_ground.py --csv RUNS.csv [options] > TABLE.md

Scans scenes in the simulator, reconstructs them with pcl_sedr, compares the results with the truth and prints a table. Every run
adds a line to RUNS.csv when it ends; runs that it has are not made again. A run that fails is a row like any other. Needs numpy,
scipy and shapely. Exit code 0: all runs were made, however good; 1: bad options, or not all were.
"""
import csv
import json
import math
import pathlib
import shutil
import sys
import types

from buildings import runs

runs.require("numpy", "scipy", "shapely")
from proving import bars, figures, meshes, table  # noqa: E402

COLUMNS = """scene noise seed with_mesh points failure rooms_true rooms_found rooms_matched area_error height_error volume_error
mesh_volume_error corners_true corners_found rooms_with_other_corners corner_distance_max arcs_true arcs_found radius_error
perimeter_error solid_components solid_closed_manifold solid_self_intersections solid_triangles truth_to_solid_mean
truth_to_solid_max solid_to_truth_mean solid_to_truth_max solid_volume_error solid_wall_area_error components closed
closed_manifold truth_to_mesh_mean truth_to_mesh_rms truth_to_mesh_p95 truth_to_mesh_max truth_within_1cm
truth_within_5cm mesh_to_truth_mean mesh_to_truth_p95 mesh_to_truth_max mesh_beyond_5cm detail_within_1cm detail_within_5cm
points_to_truth_mean points_to_truth_max points_beyond_5cm truth_covered ceiling_recall ceiling_precision floor_recall
floor_precision wall_recall wall_precision detail_recall detail_precision seconds stage_seconds warnings missed_bars
missed""".split()


def text(value):
    """A cell: seven significant digits; what is not known is empty."""
    if value is None or isinstance(value, float) and not math.isfinite(value):
        return ""
    if isinstance(value, float):
        return f"{value:.7g}"
    return str(int(value)) if not isinstance(value, str) else " ".join(value.splitlines())


def key(scene, noise, seed, options):
    """The first four cells of a run."""
    name = json.loads(pathlib.Path(scene).read_text(encoding="utf-8"))["name"] if scene.endswith(".json") else scene
    return [name, text(noise), text(seed), text(not options.no_mesh)]


def measure(run, folder, options, row):
    """Adds the figures of a run, whose files go to `folder`."""
    scene, noise, seed = run
    rays = ["--rays", options.rays] if options.rays else []
    runs.output_of([options.bin / "pcl_simulate_indoor_scan", scene, folder, "--seed", seed, "--noise", noise, *rays])
    row["points"] = meshes.point_count(folder / "scan.pcd")
    row["rooms_true"] = len(json.loads((folder / "truth.json").read_text(encoding="utf-8"))["rooms"])
    row["rooms_found"] = row["rooms_matched"] = 0
    more = ["--partial", *(["--positions", folder / "positions.txt"] if options.positions else [])]
    figures_of_run, message = runs.model(folder, options, *more, with_mesh=not options.no_mesh)
    if figures_of_run["exit"] != 0:
        raise RuntimeError(message or f"pcl_sedr ended with {figures_of_run['exit']}")
    figures.measure(types.SimpleNamespace(folder=folder, out=folder / "out", program=lambda name: options.bin / name), row)


def rows_of(run, folder, options):
    """Makes a run and yields its row."""
    first = key(*run, options)
    row = {"scene": first[0], "noise": run[1], "seed": run[2], "with_mesh": not options.no_mesh}
    try:
        measure(run, folder, options, row)
    except Exception as error:  # whatever it is, the other runs go on
        row["failure"] = str(error) if isinstance(error, RuntimeError) else f"{type(error).__name__}: {error}"
    misses = bars.missed(row)
    row["missed_bars"] = ";".join(bar for bar, _ in misses)
    row["missed"] = "; ".join(words for _, words in misses)
    if options.keep:
        shutil.copytree(folder, options.keep / "_".join(first), dirs_exist_ok=True)
    yield {column: text(row.get(column)) for column in COLUMNS}


def rows_before(path):
    """The runs that a table has."""
    if not path or not path.exists() or not path.stat().st_size:
        return []
    with open(path, newline="", encoding="utf-8") as file:
        reader = csv.DictReader(file)
        if reader.fieldnames != COLUMNS:
            sys.exit(f"proving_ground.py: '{path}' has other columns than the rows that would be added to it")
        return list(reader)


def main():
    parser = runs.parser(__doc__)
    parser.add_argument("--scenes", default="all", help="built-in scenes and JSON files, with commas; all: the built-in ones")
    parser.add_argument("--noise", default="0.001,0.005,0.01,0.02", help="standard deviations in metres, with commas (%(default)s)")
    parser.add_argument("--seeds", default="1,2,3", help="of the simulator (%(default)s)")
    parser.add_argument("--no-mesh", action="store_true", help="stop at the structure's points and the solids")
    parser.add_argument("--positions", action="store_true", help="tell the positions of the scanner")
    parser.add_argument("--rays", type=int, default=0, help="rays a scanner position; 0: the scene's own")
    parser.add_argument("--keep", type=pathlib.Path, metavar="DIR", help="where the files of every run stay")
    options = parser.parse_args()
    try:
        listed = runs.output_of([options.bin / "pcl_simulate_indoor_scan", "--list"])
    except (OSError, RuntimeError) as error:
        sys.exit(f"proving_ground.py: {error}; see --bin")
    known = [line.split()[0] for line in listed.splitlines() if line[:1].strip()]
    asked = [(scene, float(noise), int(seed)) for scene in (known if options.scenes == "all" else options.scenes.split(","))
             for noise in options.noise.split(",") for seed in options.seeds.split(",")]
    if unknown := [scene for scene, *_ in asked if scene not in known and not scene.endswith(".json")]:
        sys.exit(f"proving_ground.py: there is no scene '{unknown[0]}'; known are {', '.join(known)}, and files that end in .json")
    before = rows_before(options.csv)
    present = [[row[column] for column in COLUMNS[:4]] for row in before]
    new = [run for run in asked if key(*run, options) not in present]
    runs.all_rows(options, ["pcl_simulate_indoor_scan", "pcl_mesh_evaluation"], new, rows_of, table.text, before)


if __name__ == "__main__":
    main()
