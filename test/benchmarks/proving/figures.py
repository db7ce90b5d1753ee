# SPDX-License-Identifier: BSD-3-Clause
"""Figures of one run, measured by the programs on the files that pcl_sedr and the simulator left. Metres, shares from 0 to 1."""
import json

import numpy as np
from scipy.spatial import cKDTree

from buildings.runs import output_of
from label_grades import Grades
from proving import meshes, pcd, plans

DETAIL_ZONE = 0.10   # metres around the true details
POINT_REACH = 0.08   # metres within which a point of the structure covers a point of the truth
VOXEL_DIAGONAL = 3 ** 0.5 * 0.05
LABELS = ("ceiling", "floor", "wall", "detail")


def evaluate(run, model, *options):
    """The figures of pcl_mesh_evaluation."""
    file = run.folder / "evaluation.json"
    output_of([run.program("pcl_mesh_evaluation"), model, "--json", file, *options])
    return json.loads(file.read_text(encoding="utf-8"))


def of_solid(run, rooms):
    """The solids against the truth; vertices count for the maxima only, fine facets have more of them."""
    path, true_path = run.out / "solid.ply", run.folder / "truth.ply"
    if not path.exists():
        return {}
    solid, truth = meshes.read_mesh(path), meshes.read_mesh(true_path)
    if not len(solid.corners):
        return {}
    figures = evaluate(run, path, "--truth", true_path, "--cloud", true_path, "--self-intersections")
    back = evaluate(run, true_path, "--cloud", path)
    row = {"solid_components": figures["mesh"]["component_count"], "solid_closed_manifold": figures["mesh"]["closed_manifold"],
           "solid_self_intersections": figures["mesh"]["self_intersections"], "solid_triangles": len(solid.corners),
           "truth_to_solid_mean": figures["truth_to_mesh"]["mean"],
           "truth_to_solid_max": max(figures["truth_to_mesh"]["max"], figures["cloud_to_mesh"]["max"]),
           "solid_to_truth_mean": figures["mesh_to_truth"]["mean"],
           "solid_to_truth_max": max(figures["mesh_to_truth"]["max"], back["cloud_to_mesh"]["max"])}
    for found, true in rooms:
        part, real = solid.part(solid.rooms == found), truth.part(truth.rooms == true)
        plans.keep_error(row, "solid_volume_error", part.volume(), real.volume())
        plans.keep_error(row, "solid_wall_area_error", part.wall_area(), real.wall_area())
    return row


def of_structure(run, samples):
    reached = evaluate(run, run.folder / "truth.ply", "--cloud", run.out / "structure.pcd")["cloud_to_mesh"]
    near, _ = cKDTree(pcd.places(pcd.read(run.out / "structure.pcd"))).query(samples.astype("f4"), distance_upper_bound=2 * POINT_REACH)
    return {"points_to_truth_mean": reached["mean"], "points_to_truth_max": reached["max"],
            "points_beyond_5cm": 1 - reached["within_5cm"], "truth_covered": float(np.mean(near <= POINT_REACH))}


def of_labels(run):
    """Recall and precision of each label; columns count as walls."""
    grades = Grades(run.out / "structure.pcd", run.folder / "scan.pcd", VOXEL_DIAGONAL)
    row = {}
    for name in LABELS:
        recall, precision = grades.recall_and_precision(name)
        row.update({f"{name}_{kind}": value for kind, value in (("recall", recall), ("precision", precision)) if value is not None})
    return row


def of_mesh(run, truth, samples):
    figures = evaluate(run, run.out / "mesh.ply", "--truth", run.folder / "truth.ply")
    to_mesh, to_truth = figures["truth_to_mesh"], figures["mesh_to_truth"]
    row = {"components": figures["mesh"]["component_count"], "mesh_beyond_5cm": 1 - to_truth["within_5cm"]}
    row.update({name: figures["mesh"][name] for name in ("closed", "closed_manifold")})
    row.update({f"truth_to_mesh_{name}": to_mesh[name] for name in ("mean", "rms", "p95", "max")})
    row.update({f"truth_within_{name}": to_mesh[f"within_{name}"] for name in ("1cm", "5cm")})
    row.update({f"mesh_to_truth_{name}": to_truth[name] for name in ("mean", "p95", "max")})
    details = truth.part(np.isin(truth.labels, (meshes.DETAIL, meshes.COLUMN)))
    if len(details.corners):
        meshes.write_mesh(run.folder / "details.ply", details)
        meshes.write_xyz(run.folder / "samples.pcd", samples)
        zone = evaluate(run, run.out / "mesh.ply", "--cloud", run.folder / "samples.pcd",
                        "--near", run.folder / "details.ply", "--near-distance", DETAIL_ZONE)["cloud_to_mesh"]
        row.update({f"detail_within_{name}": zone[f"within_{name}"] for name in ("1cm", "5cm")})
    return row


def measure(run, row):
    """Adds the figures of a run: `run` has its folders, `row` its columns."""
    truth, plan, report = (json.loads(path.read_text(encoding="utf-8")) for path in
                           (run.folder / "truth.json", run.out / "floorplan.json", run.out / "report.json"))
    stages = [s for s in report["stages"] if s["stage"] not in ("reading", "MeshEvaluation", "writing")]
    row["stage_seconds"] = ";".join(f"{s['stage']}={s['seconds']:.7g}" for s in stages)
    row["seconds"] = sum(s["seconds"] for s in stages)
    row["warnings"] = " | ".join(warning["text"] for warning in report["warnings"])
    row.update(of_solid(run, plans.compare_rooms(plan, report, truth, row)))
    mesh = meshes.read_mesh(run.folder / "truth.ply")
    samples = meshes.samples(mesh)
    row.update(of_structure(run, samples))
    row.update(of_labels(run))
    if row["with_mesh"]:
        row.update(of_mesh(run, mesh, samples))
