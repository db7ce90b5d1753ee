# SPDX-License-Identifier: BSD-3-Clause
"""The tables and pictures of doc/evaluation.md; doc/evaluation.sh prepares the data.

   /usr/bin/python3 doc/evaluation.py tables DATA
   xvfb-run /usr/bin/python3 doc/evaluation.py pictures DATA OUTPUT [PICTURE...]
   /usr/bin/python3 doc/evaluation.py without_details PLAN.json OUTPUT.json
"""
import json
import sys
from pathlib import Path

SCENES = ["bls_room", "hls_hall", "syn_flat", "synth1"]
MODELS = {"default": "defaults", "paper": "Table 1", "paper_pcl": "Table 1, `pcl::Poisson`"}


def load(path):
    return json.loads(Path(path).read_text())


def scenes_of(data):
    return [scene for scene in SCENES if (data / scene / "default.json").exists()]


def without_details(plan, output):
    """The plan of a method that knows walls, one ceiling and one floor a room."""
    content = load(plan)
    for room in content["rooms"]:
        room["details"], room["floor_details"], room["niches"] = [], [], []
    Path(output).write_text(json.dumps(content))


# ---- tables

def row(*cells):
    print("| " + " | ".join(str(cell) for cell in cells) + " |")


def header(*cells):
    row(*cells)
    row(*["---"] * len(cells))


def cm(metres, digits=3):
    return f"{100 * metres:.{digits}f}"


def models_table(data):
    header("scene", "settings", "closed rooms", "cloud to model: mean", "p99", "max", "truth to model: mean", "p99", "max",
           "CPU s")
    for scene in scenes_of(data):
        for model, name in MODELS.items():
            figures, report = load(data / scene / f"{model}.json"), load(data / scene / model / "report.json")
            cloud, truth, mesh = (figures[key] for key in ("cloud_to_mesh", "truth_to_mesh", "mesh"))
            row(f"`{scene}`", name, f"{len(report['rooms'])}" if mesh["closed_manifold"] else "not closed",
                cm(cloud["mean"]), cm(cloud["p99"]), cm(cloud["max"], 2), cm(truth["mean"]), cm(truth["p99"]),
                cm(truth["max"], 2), f"{sum(map(float, (data / scene / f'{model}.seconds').read_text().split())):.1f}")
        cloud = load(data / scene / "truth_itself.json")["cloud_to_mesh"]
        row(f"`{scene}`", "the truth itself", "", cm(cloud["mean"]), cm(cloud["p99"]), cm(cloud["max"], 2), "", "", "", "")


def points_table(data):
    header("scene", "points of the scan", "thinned", "share", "structure, refined", "holes repaired, even",
           "triangles of the mesh", "of the solid")
    for scene in scenes_of(data):
        report = load(data / scene / "default/report.json")
        stages = {stage["stage"]: stage for stage in report["stages"]}
        scan, thinned = (stages["ParallelVoxelGrid"][key] for key in ("points_in", "points_out"))
        row(f"`{scene}`", f"{scan:,}", f"{thinned:,}", f"{100 * thinned / scan:.1f} %",
            f"{stages['StructureRefinement']['points_out']:,}", f"{stages['VerticalHoleRepair']['points_out']:,}",
            f"{report['evaluation']['mesh']['triangles']:,}",
            f"{sum(room['solid']['triangles'] for room in report['rooms']):,}")


def share_within(distances, metres):
    """Share of the distances up to a multiple of the histogram's bins, in percent."""
    bins = distances["histogram"]
    count = round(metres / distances["histogram_range"] * len(bins))
    return 100 * sum(bins[:count]) / distances["count"]


def shares_table(data):
    limits = [0.005, 0.01, 0.02, 0.03, 0.05]
    header("scene", "model", *(f"{100 * limit:g} cm" for limit in limits))
    for scene in [scene for scene in scenes_of(data) if scene in ("syn_flat", "synth1")]:
        for model in ("default", "paper_pcl"):
            distances = load(data / scene / f"{model}.json")["cloud_to_mesh"]
            row(f"`{scene}`", MODELS[model], *(f"{share_within(distances, limit):.2f}" for limit in limits))


def columns_table(data):
    header("scene", "columns, true", "found")
    true = {name: sum(len(room["columns"]) for room in load(data / name / "truth.json")["rooms"])
            for name in ("hls_hall", "columns")}
    for path in [data / "hls_hall", data / "columns", *sorted(data.glob("cabinet_?.??"))]:
        plan = load(path / "default/floorplan.json")
        name = f"`{path.name}`" if path.name in true else f"`hls_hall`, the cabinet's top at {path.name[8:]} m of 3.60 m"
        row(name, true.get(path.name, true["hls_hall"]), sum(len(room["columns"]) for room in plan["rooms"]))


def tables(data):
    for table in (models_table, points_table, shares_table, columns_table):
        print()
        table(Path(data))


if __name__ == "__main__":
    command, *arguments = sys.argv[1:] or [""]
    if command == "pictures" and len(arguments) >= 2:
        import evaluation_images
        evaluation_images.main(*arguments)
    elif command == "tables" and len(arguments) == 1:
        tables(*arguments)
    elif command == "without_details" and len(arguments) == 2:
        without_details(*arguments)
    else:
        sys.exit(__doc__)
