# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of doc/evaluation.md, after Figures 8 to 11 of the paper; evaluation.py calls it."""
import json
from pathlib import Path

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from make_images import (COLOURS, COLUMN, CEILING, DETAIL, DPI, FLOOR, HALL_CUT, STUDY_VIEW, WALL, Cloud, actor_of,
                         add_legend, between, cut_mesh, distances, inner_actor, inside, label_colours, labelled_mesh, millions,
                         open_mesh, outer_actor, paint, place, point_actor, points_polydata, read_mesh, read_solid,
                         render, rgb, rim_actor, save, show_render)

RED, BLUE, ORANGE = "#e0207a", "#1f6fff", "#ff8c00"  # the rings, as in the paper's figures
FLAT_VIEW, FLAT_CUT = (-35, 52), 2.1
CURVE_VIEW = (-128, 42)  # across the hall to its curved wall
SOFFIT_VIEW = (-28, -52)  # from below, across the room to where the soffit is


# ---- parts

def four_panels(height):
    fig = plt.figure(figsize=(12, height), dpi=DPI, facecolor="white")
    space = dict(left=0.01, right=0.99, top=1 - 0.35 / height, bottom=0.45 / height, wspace=0.03, hspace=0.1)
    return fig, fig.subplots(2, 2, gridspec_kw=space).ravel()


def raw_actor(scan, bounds, height, beyond=1.5):
    """The scan below a height, with what lies outside of the rooms, up to so many metres."""
    margin = np.array([-beyond, beyond])
    near = inside(scan.xyz, bounds[0:2] + margin, bounds[2:4] + margin)
    near &= between(scan.xyz[:, 2], bounds[4] - 0.3, height)
    size = 2 if near.sum() > 1_000_000 else 4
    return point_actor(scan.xyz[near], np.zeros(near.sum(), int), size, lighten=0.5)


def ring(x, y, radius, colour, height):
    """A level circle that marks something, at a height."""
    source = vtk.vtkRegularPolygonSource()
    source.SetNumberOfSides(72)
    source.GeneratePolygonOff()
    source.SetRadius(radius)
    source.SetCenter(x, y, height)
    source.Update()
    actor = actor_of(source.GetOutput())
    actor.GetProperty().SetColor(*rgb(colour))
    actor.GetProperty().SetLineWidth(7)
    actor.GetProperty().LightingOff()
    return actor


def show_scan(axes, scene, bounds, view, cut, marks=()):
    scan, count = Cloud(scan_of(scene)), json.loads((scene / "default/report.json").read_text())["input"]["points"]
    whole, opened = (render([raw_actor(scan, bounds, height), *rings], bounds, *view, depth=True)
                     for height, rings in ((bounds[5] + 0.3, []), (cut, marks)))
    show_render(axes[0], whole, f"(a) scan: {millions(count)}")
    show_render(axes[1], opened, "(b) scan without its ceiling")


def read_reference(path):
    if path.suffix == ".ply":
        return read_mesh(path)
    reader = vtk.vtkOBJReader()
    reader.SetFileName(str(path))
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputConnection(reader.GetOutputPort())
    triangles.PassLinesOff()
    triangles.PassVertsOff()
    triangles.Update()
    return triangles.GetOutput()


def open_reference(path, height):
    """A true model below a height, in the colours of floor and wall."""
    mesh = read_reference(path)
    faces = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    corners = vtk_to_numpy(mesh.GetPoints().GetData())[faces].astype(float)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    volume = np.einsum("ij,ij", corners[:, 0] - corners.mean(axis=(0, 1)), normal)
    if volume > 0:  # its faces look out of the rooms
        mesh.BuildLinks()
        for face in range(len(faces)):
            mesh.ReverseCell(face)
    level = np.abs(normal[:, 2]) > 0.7 * np.linalg.norm(normal, axis=1)
    colours = numpy_to_vtk(label_colours(np.where(level, FLOOR, WALL)), deep=True)
    mesh.GetPointData().Initialize()
    mesh.GetCellData().SetScalars(colours)
    part = cut_mesh(mesh, height)
    actors = [inner_actor(part), outer_actor(part)]
    for actor in actors:
        actor.GetProperty().SetInterpolationToFlat()
    return [*actors, rim_actor(mesh, height)]


# ---- pictures

def study(data):
    """Figure 8: details of the ceiling."""
    scene = data / "bls_room"
    mesh = labelled_mesh(scene, "default")
    bounds = np.array(mesh.GetBounds())
    fig, axes = four_panels(8.6)
    show_scan(axes, scene, bounds, STUDY_VIEW, 2.62)
    plain = render(read_solid(scene / "plain.ply", FLOOR), bounds, *SOFFIT_VIEW)
    show_render(axes[2], plain, "(c) a model without details, from below")
    show_render(axes[3], render(open_mesh(mesh, 0.6, False), bounds, *SOFFIT_VIEW), "(d) our model, from below")
    add_legend(fig, [CEILING, WALL, DETAIL])
    return fig


def hall(data):
    """Figure 9: a curved wall, pillars, and an object that is none."""
    scene = data / "hls_hall"
    mesh = labelled_mesh(scene, "default")
    bounds = np.array(mesh.GetBounds())
    marks = [ring(4.2, 3.4, 0.8, BLUE, HALL_CUT), ring(11.2, 2.6, 0.9, ORANGE, HALL_CUT), ring(15.1, 5.5, 2.6, RED, HALL_CUT)]
    fig, axes = four_panels(8.2)
    show_scan(axes, scene, bounds, CURVE_VIEW, HALL_CUT, marks)
    solid = read_solid(scene / "default/solid.ply", CEILING)
    show_render(axes[2], render([*solid, *marks], bounds, *CURVE_VIEW), "(c) our sharp solid")
    show_render(axes[3], render([*open_mesh(mesh, HALL_CUT), *marks], bounds, *CURVE_VIEW), "(d) our model")
    add_legend(fig, [FLOOR, WALL, COLUMN, ("curved wall", RED), ("a pillar", BLUE), ("a cabinet, no pillar", ORANGE)])
    return fig


def rooms(data, name, truth):
    """Figure 10: several rooms, and the true model."""
    scene = data / name
    mesh = labelled_mesh(scene, "default")
    bounds = np.array(mesh.GetBounds())
    fig, axes = four_panels(10)
    show_scan(axes, scene, bounds, FLAT_VIEW, FLAT_CUT)
    models = [open_mesh(mesh, FLAT_CUT), open_reference(scene / truth, FLAT_CUT)]
    for ax, actors, title in zip(axes[2:], models, ("(c) our model", "(d) the reference")):
        show_render(ax, render(actors, bounds, *FLAT_VIEW), title)
    add_legend(fig, [FLOOR, WALL])
    return fig


def accuracy(data, name, truth):
    """Figure 11: distances from the points of the structure to two models, coloured, and how many are how far."""
    scene, scan = data / name, Cloud(scan_of(data / name))
    structure = near_reference(scan, scene / truth) if name == "synth1" else scan.label > 0
    points = scan.xyz[structure]
    points = points[::max(1, len(points) // 500_000)]
    points = points[points[:, 2] < FLAT_CUT]
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0, 1), "turbo")
    fig = plt.figure(figsize=(12, 8.6), dpi=DPI, facecolor="white")
    histogram = place(fig, 1.1, 0.6, 10.6, 2.1)
    for left, (model, (title, colour)) in zip((0.1, 6.1), MODELS.items()):
        cloud = points_polydata(points)
        far = 100 * distances(cloud, read_mesh(scene / model / "mesh.ply"))
        actor = actor_of(paint(cloud, scale.to_rgba(far, bytes=True)[:, :3]))
        actor.GetProperty().SetPointSize(4)
        actor.GetProperty().LightingOff()
        image = render([actor], np.array(cloud.GetBounds()), *FLAT_VIEW)
        show_render(place(fig, left, 3.9, 5.8, 4.3), image, title)
        draw_histogram(histogram, json.loads((scene / f"{model}.json").read_text())["cloud_to_mesh"], title[:3], colour)
    fig.colorbar(scale, cax=place(fig, 3.5, 3.65, 5, 0.15), orientation="horizontal", extend="max",
                 label="distance from the point to the model, cm")
    histogram.legend(loc="upper right")
    return fig


MODELS = {"default": ("(a) our model", COLOURS[FLOOR]), "paper_pcl": ("(b) pcl::Poisson, as in the paper", COLOURS[DETAIL])}


def scan_of(scene):
    """The scan, or a copy of it that is not compressed."""
    copy = scene / "scan_copy.pcd"
    return copy if copy.exists() else scene / "scan.pcd"


def near_reference(scan, path, distance=0.05):
    return distances(points_polydata(scan.xyz), read_reference(path)) <= distance


def draw_histogram(ax, figures, name, colour):
    share = 100 * np.array(figures["histogram"]) / figures["count"]
    edges = np.linspace(0, 100 * figures["histogram_range"], len(share) + 1)
    text = f"{name} mean {100 * figures['mean']:.3f} cm, max {100 * figures['max']:.1f} cm"
    ax.stairs(share, edges, color=colour, linewidth=2, label=text)
    ax.set(ylabel="% of the points", xlabel="distance, cm", xlim=(0, 5), ylim=(1e-4, 100), yscale="log")
    ax.set_yticks([0.0001, 0.001, 0.01, 0.1, 1, 10, 100])
    ax.yaxis.set_major_formatter("{x:g}")


PICTURES = {"study": study, "hall": hall,
            "rooms": lambda data: rooms(data, "syn_flat", "truth.ply"),
            "rooms_synth1": lambda data: rooms(data, "synth1", "truth.obj"),
            "accuracy": lambda data: accuracy(data, "syn_flat", "truth.ply"),
            "accuracy_synth1": lambda data: accuracy(data, "synth1", "truth.obj")}


def main(data, output, *wanted):
    for name in wanted or PICTURES:
        if "synth1" not in name or (Path(data) / "synth1").exists():
            save(PICTURES[name](Path(data)), Path(output) / f"evaluation_{name}.png")
