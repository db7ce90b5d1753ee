# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of README.md and of the class pages; doc/make_images.sh prepares the data.

   xvfb-run /usr/bin/python3 doc/make_images.py DATA OUTPUT [PICTURE...]

DATA holds a folder a scene: scan.pcd, truth.ply, model/ (what pcl_sedr left), and the files of the
single stages, named after what the stage added. Without a PICTURE all are drawn.
"""
import json
import sys
from pathlib import Path

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import vtk
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from PIL import Image
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

OTHER, CEILING, FLOOR, WALL, DETAIL, COLUMN = range(6)
NAMES = ["other", "ceiling", "floor", "wall", "detail", "column"]
COLOURS = ["#9b9b9b", "#f0901e", "#2d72c4", "#36a04a", "#d8302c", "#8d44b0"]
FILLED = "#e7298a"      # points that a stage has added
INK = "#222222"
DPI = 100
VOXEL = 0.05

# The study stands at an angle in the coordinates of its scan.
STUDY_ORIGIN, STUDY_ANGLE = np.array([12.3, -7.8]), np.radians(17)

plt.rcParams.update({
    "font.family": "DejaVu Sans", "font.size": 13, "axes.titlesize": 14, "axes.edgecolor": "#888888",
    "text.color": INK, "axes.labelcolor": INK, "xtick.color": INK, "ytick.color": INK,
    "xtick.labelsize": 12, "ytick.labelsize": 12, "legend.frameon": False, "legend.fontsize": 13,
    "legend.handletextpad": 0.2, "legend.columnspacing": 1.2})


# ---- data

class Cloud:
    """The points of a PCD file: xyz and normal (n x 3), label, room; zeros for what it has not."""

    def __init__(self, path):
        header, rows = read_pcd(path)
        self.xyz = np.stack([rows[axis] for axis in "xyz"], axis=1).astype(float)
        field = lambda name: rows[name] if name in header else np.zeros(len(rows))
        self.normal = np.stack([field(f"normal_{axis}") for axis in "xyz"], axis=1)
        self.label, self.room = field("label").astype(int), field("room").astype(int)

    def only(self, *labels):
        return self.xyz[np.isin(self.label, labels)]


def read_pcd(path):
    """Field names and rows of a binary PCD file."""
    header = {}
    with open(path, "rb") as file:
        while "DATA" not in header:
            key, *values = file.readline().decode().split()
            header[key] = values
        kinds = {"F": "f", "U": "u", "I": "i"}
        fields = [(name, kinds[kind] + size, int(count)) if count != "1" else (name, kinds[kind] + size)
                  for name, kind, size, count in
                  zip(header["FIELDS"], header["TYPE"], header["SIZE"], header["COUNT"])]
        return header["FIELDS"], np.fromfile(file, fields, int(header["POINTS"][0]))


def read_mesh(path):
    reader = vtk.vtkPLYReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def read_rooms(path):
    return json.loads(path.read_text())["rooms"]


def to_study(points):
    """Coordinates along the walls of the study, from its south-west corner."""
    c, s = np.cos(STUDY_ANGLE), np.sin(STUDY_ANGLE)
    plan = (points[:, :2] - STUDY_ORIGIN) @ np.array([[c, -s], [s, c]])
    return np.column_stack([plan, points[:, 2:]])


def to_study_plan(points):
    return to_study(np.column_stack([points, np.zeros(len(points))]))[:, :2]


def between(values, low, high):
    return (values >= low) & (values < high)


def inside(points, x, y):
    return between(points[:, 0], *x) & between(points[:, 1], *y)


def added_rows(after, before):
    """Which rows of `after` are not among those of `before`."""
    keys = [np.ascontiguousarray(np.round(points * 1e4).astype(np.int64)).view("V24").ravel()
            for points in (after, before)]
    known = set(key.tobytes() for key in keys[1])
    return np.array([key.tobytes() not in known for key in keys[0]])


def millions(n):
    return f"{n / 1e6:.2f} million points" if n >= 1e6 else f"{n / 1e3:.0f} thousand points"


# ---- plans

def curve_of(element):
    """Points along a segment or an arc."""
    start, end = np.array(element["start"]), np.array(element["end"])
    if element["type"] == "segment":
        return np.array([start, end])
    centre = np.array(element["centre"])
    first, last = (np.arctan2(*(p - centre)[::-1]) for p in (start, end))
    turn = (last - first) % (2 * np.pi)
    if not element["counter_clockwise"]:
        turn -= 2 * np.pi
    if np.allclose(start, end):
        turn = 2 * np.pi
    angles = first + np.linspace(0, turn, 100)
    return centre + element["radius"] * np.column_stack([np.cos(angles), np.sin(angles)])


def draw_loop(ax, loop, colour, to_axes=lambda p: p, **style):
    curves = [to_axes(curve_of(element)) for element in loop]
    ax.add_collection(LineCollection(curves, colors=colour, capstyle="round", **style))
    return np.array([curve[0] for curve in curves])


def draw_room(ax, room, to_axes=lambda p: p):
    for detail in room["details"]:
        draw_loop(ax, detail["boundary"], COLOURS[DETAIL], to_axes, linewidths=1.5)
    for column in room["columns"]:
        draw_loop(ax, column, COLOURS[COLUMN], to_axes, linewidths=2)
    corners = draw_loop(ax, room["boundary"], INK, to_axes, linewidths=1.3)
    ax.plot(*corners.T, "o", color=INK, markersize=3.5)


# ---- figures

def new_figure(height, widths, legend=True, **grid):
    """A row of panels, 1200 pixels wide in all; without `legend` no room is left below."""
    fig = plt.figure(figsize=(12, height), dpi=DPI, facecolor="white")
    space = dict(left=0.01, right=0.99, top=1 - 0.4 / height, bottom=(0.45 if legend else 0.05) / height, wspace=0.03)
    axes = fig.subplots(1, len(widths), squeeze=False, gridspec_kw={**space, "width_ratios": widths, **grid})[0]
    return fig, axes


def place(fig, left, bottom, width, height):
    """A panel at that place of the figure, in inches."""
    across, up = fig.get_size_inches()
    return fig.add_axes([left / across, bottom / up, width / across, height / up])


def add_legend(fig, entries):
    """Legend below the panels; an entry is a label, or a pair of text and colour."""
    pairs = [(NAMES[e], COLOURS[e]) if isinstance(e, int) else e for e in entries]
    handles = [Line2D([], [], marker="s", linestyle="", markersize=11, color=colour, label=text)
               for text, colour in pairs]
    fig.legend(handles=handles, loc="lower center", ncol=len(handles), borderaxespad=0.15)


def dots(ax, points, colour, size=1.0, order=(0, 1)):
    ax.scatter(points[:, order[0]], points[:, order[1]], s=size, c=colour, marker="s", linewidths=0, rasterized=True)


def as_plan(ax, title, x=None, y=None):
    ax.set_title(title)
    ax.set_aspect("equal")
    ax.set_axis_off()
    if x:
        ax.set_xlim(*x)
        ax.set_ylim(*y)


def note(ax, text, at, text_at):
    line = {"arrowstyle": "-", "color": "#888888"}
    ax.annotate(text, at, text_at, ha="center", va="center", fontsize=12, arrowprops=line)


def add_ruler(ax, length, text):
    """A bar of that many metres in the upper right corner."""
    (left, right), (low, high) = ax.get_xlim(), ax.get_ylim()
    x, y = right - 0.03 * (right - left), high - 0.1 * (high - low)
    ax.plot([x - length, x], [y, y], color=INK, linewidth=3, solid_capstyle="butt")
    ax.text(x, y + 0.015 * (high - low), text, ha="right", va="bottom", fontsize=12)


def show_render(ax, image, title):
    ax.imshow(image, interpolation="lanczos")
    ax.set_anchor("N")
    ax.set_title(title)
    ax.set_axis_off()


def save(fig, path, colours=192):
    """Writes a PNG with a palette."""
    fig.canvas.draw()
    image = Image.fromarray(np.asarray(fig.canvas.buffer_rgba())[..., :3])
    plt.close(fig)
    image = image.quantize(colours, method=Image.Quantize.MEDIANCUT, kmeans=2, dither=Image.Dither.NONE)
    image.putpalette([255 if value > 249 else value for value in image.getpalette()])
    image.save(path, optimize=True)
    print(f"{path.name}: {image.width} x {image.height}, {path.stat().st_size / 1000:.0f} kB")


# ---- rendering

def rgb(colour):
    return matplotlib.colors.to_rgb(colour)


def label_colours(labels):
    return (255 * np.array([rgb(c) for c in COLOURS])[labels]).astype(np.uint8)


def points_polydata(points):
    data = vtk.vtkPolyData()
    data.SetPoints(vtk.vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(points, np.float32), deep=True))
    cells = np.column_stack([np.ones(len(points), np.int64), np.arange(len(points))]).ravel()
    vertices = vtk.vtkCellArray()
    vertices.ImportLegacyFormat(numpy_to_vtkIdTypeArray(cells, deep=True))
    data.SetVerts(vertices)
    return data


def paint(data, colours):
    array = numpy_to_vtk(np.ascontiguousarray(colours, np.uint8), deep=True)
    array.SetName("colours")
    data.GetPointData().SetScalars(array)
    return data


def actor_of(data):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor


def point_actor(points, labels, size, lighten=0.0):
    """Squares of `size` pixels; what is rough is darkened by `shade_depth`, so lighten it."""
    colours = label_colours(labels) * (1 - lighten) + 255 * lighten
    actor = actor_of(paint(points_polydata(points), colours))
    actor.GetProperty().SetPointSize(size)
    actor.GetProperty().LightingOff()
    return actor


def with_labels(mesh, cloud):
    """The mesh, every vertex coloured by the label of the nearest point."""
    source = points_polydata(cloud.xyz)
    labels = numpy_to_vtk(cloud.label.astype(np.float32), deep=True)
    labels.SetName("label")
    source.GetPointData().AddArray(labels)
    nearest = vtk.vtkPointInterpolator()
    nearest.SetInputData(mesh)
    nearest.SetSourceData(source)
    nearest.SetKernel(vtk.vtkVoronoiKernel())
    nearest.Update()
    data = nearest.GetOutput()
    return paint(data, label_colours(vtk_to_numpy(data.GetPointData().GetArray("label")).astype(int)))


def horizontal(height):
    plane = vtk.vtkPlane()
    plane.SetOrigin(0, 0, height)
    plane.SetNormal(0, 0, 1)
    return plane


def cut_mesh(mesh, height, keep_lower=True):
    """What lies below that height, or above it."""
    clip = vtk.vtkClipPolyData()
    clip.SetInputData(mesh)
    clip.SetClipFunction(horizontal(height))
    clip.SetInsideOut(keep_lower)
    clip.Update()
    return clip.GetOutput()


def rim_actor(mesh, height):
    """The line along which the mesh is cut at that height."""
    cutter = vtk.vtkCutter()
    cutter.SetInputData(mesh)
    cutter.SetCutFunction(horizontal(height))
    cutter.Update()
    data = cutter.GetOutput()
    data.GetPointData().Initialize()
    actor = actor_of(data)
    actor.GetProperty().SetColor(rgb(INK))
    actor.GetProperty().SetLineWidth(4)
    actor.GetProperty().LightingOff()
    return actor


def with_normals(mesh):
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(mesh)
    normals.ConsistencyOff()
    normals.SplittingOff()
    normals.Update()
    return normals.GetOutput()


def inner_actor(mesh):
    """The side of the surface that faces the room, in the colours of the vertices."""
    actor = actor_of(mesh)
    surface = actor.GetProperty()
    surface.BackfaceCullingOn()
    surface.SetAmbient(0.65)
    surface.SetDiffuse(0.4)
    return actor


def outer_actor(mesh):
    """The other side, a grey veil."""
    actor = actor_of(mesh)
    actor.GetMapper().ScalarVisibilityOff()
    surface = actor.GetProperty()
    surface.FrontfaceCullingOn()
    surface.SetColor(0.6, 0.6, 0.6)
    surface.SetOpacity(0.3)
    return actor


def open_mesh(mesh, height, keep_lower=True):
    part = with_normals(cut_mesh(mesh, height, keep_lower))
    return [inner_actor(part), outer_actor(part), rim_actor(mesh, height)]


def show_edges(actor):
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0.3, 0.3, 0.3)
    actor.GetProperty().SetLineWidth(1.5)
    return actor


def bounds_of(points):
    return np.ravel(np.column_stack([points.min(axis=0), points.max(axis=0)]))


def direction(azimuth, elevation):
    a, e = np.radians([azimuth, elevation])
    return np.array([np.cos(a) * np.cos(e), np.sin(a) * np.cos(e), np.sin(e)])


def camera_towards(renderer, bounds, azimuth, elevation):
    centre = np.array([bounds[0:2], bounds[2:4], bounds[4:6]]).mean(axis=1)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(centre)
    camera.SetPosition(centre + 10 * direction(azimuth, elevation))
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(25)
    renderer.ResetCamera(bounds)
    renderer.ResetCameraClippingRange()


def shade_depth(renderer):
    """Darkens the edges of what stands before something else: points have no normals to be lit by."""
    shading = vtk.vtkEDLShading()
    shading.SetDelegatePass(vtk.vtkRenderStepsPass())
    renderer.SetPass(shading)


def render(actors, bounds, azimuth, elevation, shape=(1600, 1200), depth=False, crop=True):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    if depth:
        shade_depth(renderer)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0 if depth else 8)
    window.SetSize(*shape)
    window.AddRenderer(renderer)
    camera_towards(renderer, bounds, azimuth, elevation)
    window.Render()
    image = grab(window)
    return crop_white(image) if crop else image


def grab(window):
    reader = vtk.vtkWindowToImageFilter()
    reader.SetInput(window)
    reader.ReadFrontBufferOff()
    reader.Update()
    image = reader.GetOutput()
    columns, rows, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1)[::-1, :, :3]


def crop_white(image, margin=10):
    rows, columns = (np.flatnonzero((image < 250).any(axis=2).any(axis=axis)) for axis in (1, 0))
    return image[max(rows[0] - margin, 0):rows[-1] + margin, max(columns[0] - margin, 0):columns[-1] + margin]


# ---- pictures

HALL_VIEW, STUDY_VIEW, FLAT_VIEW = (-62, 42), (-40, 45), (-35, 48)
STUDY_BELOW = (-118, -55)
HALL_CUT, STUDY_CUT, FLAT_CUT = 3.3, 2.2, 2.2


def labelled_mesh(scene):
    return with_labels(read_mesh(scene / "model/mesh.ply"), Cloud(scene / "repaired.pcd"))


def overview(data):
    hall = data / "hls_hall"
    scan, structure = Cloud(hall / "scan.pcd"), Cloud(hall / "repaired.pcd")
    bounds = bounds_of(structure.xyz)
    fig, axes = new_figure(3.7, [1, 1, 1])
    images = [render([opened_scan(scan, bounds)], bounds, *HALL_VIEW, depth=True),
              render([opened_structure(structure, HALL_VIEW)], bounds, *HALL_VIEW, depth=True),
              render(open_mesh(labelled_mesh(hall), HALL_CUT), bounds, *HALL_VIEW)]
    titles = [f"scan: {millions(len(scan.xyz))}", f"structure: {millions(len(structure.xyz))}",
              "model: one closed mesh"]
    for ax, image, title in zip(axes, images, titles):
        show_render(ax, image, title)
    add_legend(fig, [CEILING, FLOOR, WALL, COLUMN])
    return fig


def opened_scan(scan, bounds):
    """Without the ceiling, the wall in front, and what lies outside."""
    near = inside(scan.xyz, bounds[0:2] + [-0.2, 0.2], bounds[2:4] + [0.55, 0.2])
    near &= between(scan.xyz[:, 2], -0.1, HALL_CUT)
    return point_actor(scan.xyz[near], np.zeros(near.sum(), int), 2, lighten=0.5)


def opened_structure(structure, view):
    """What faces the viewer, and a strip of the ceiling."""
    seen = (structure.normal @ direction(*view) > 0) & (structure.xyz[:, 2] < HALL_CUT)
    seen |= (structure.label == CEILING) & (structure.xyz[:, 0] < 2.5)
    return point_actor(structure.xyz[seen], structure.label[seen], 5, lighten=0.1)


def parallel_voxel_grid(data):
    clouds = [Cloud(data / "bls_room" / name) for name in ("scan.pcd", "thinned.pcd")]
    fig, axes = new_figure(3.9, [1, 1, 1], wspace=0.06)
    box = bounds_of(np.array([[3.9, 1.2, 0], [6.3, 4, 1.3]]))
    for ax, cloud, size, name in zip(axes, clouds, (3, 10), ("scan", "thinned")):
        points = to_study(cloud.xyz)
        near = inside(points, box[0:2], box[2:4]) & between(points[:, 2], -0.1, 1.5)
        image = render([point_actor(points[near], cloud.label[near], size, 0.3)], box, 205, 35, depth=True)
        show_render(ax, image, f"{name}: {millions(len(points))}")
    voxel_close_up(axes[2], *(cloud.xyz for cloud in clouds))
    add_legend(fig, [FLOOR, WALL, OTHER, ("scan", "#bbbbbb"), ("mean of a voxel", INK)])
    return fig


def voxel_close_up(ax, scan, thinned):
    """One layer of voxels at a corner, from above."""
    x, y = (12.05, 12.55), (-7.9, -7.4)
    scanned, means = (p[inside(p, x, y) & between(p[:, 2], 1.5, 1.55)] for p in (scan, thinned))
    dots(ax, scanned, "#bbbbbb", 4)
    dots(ax, means, INK, 40)
    as_plan(ax, "one layer of voxels, from above", x, y)
    for line in np.arange(0, 0.51, VOXEL):
        ax.plot(x, (y[0] + line,) * 2, color="#dddddd", linewidth=0.8, zorder=0)
        ax.plot((x[0] + line,) * 2, y, color="#dddddd", linewidth=0.8, zorder=0)


STUDY_SLAB = (-0.3, 6.5), (1.9, 2.5)


def study_section(ax, cloud, labels):
    """The points of a slab across the study, seen along it."""
    points = to_study(cloud.xyz)
    slab = inside(points, *STUDY_SLAB)
    for label in labels:
        dots(ax, points[slab & (cloud.label == label)], COLOURS[label], 7, (0, 2))
    ax.set(xlim=STUDY_SLAB[0], ylim=(-0.15, 3.15), ylabel="height, m", xlabel="m")


def horizontal_plane_detection(data):
    planes = Cloud(data / "bls_room/planes.pcd")
    points = to_study(planes.xyz)
    fig = plt.figure(figsize=(12, 4.9), dpi=DPI, facecolor="white")
    ax, bars = place(fig, 0.7, 1.1, 7.2, 3.4), place(fig, 8.2, 1.1, 3.6, 3.4)
    study_section(ax, planes, (OTHER, FLOOR, CEILING))
    ax.set_title("vertical section, 0.6 m thick")
    room = inside(points, (-0.1, 6.3), (-0.1, 4.9))
    order = (FLOOR, CEILING, OTHER)
    bars.hist([points[room & (planes.label == label), 2] for label in order], bins=np.arange(-0.15, 3.2, VOXEL),
              orientation="horizontal", stacked=True, color=[COLOURS[label] for label in order])
    bars.set(title="points by height", ylim=(-0.15, 3.15), yticklabels=[], xlabel="points in 5 cm of height")
    add_legend(fig, [CEILING, FLOOR, OTHER])
    return fig


def cell_centres(points):
    return np.unique(np.floor(points[:, :2] / VOXEL), axis=0) * VOXEL + VOXEL / 2


def grid_region_outlier_removal(data):
    shades = ["#f0901e", "#f8cf8d", "#b3600c", "#e0b050"]
    fig, axes = new_figure(5.2, [1.15, 1])
    views = [("bls_room", to_study_plan, (-1, 17), (-7, 10)), ("syn_flat", lambda p: p, (-3, 10.3), (-0.5, 14.5))]
    for ax, (scene, to_axes, x, y) in zip(axes, views):
        planes, rooms = (Cloud(data / scene / name) for name in ("planes.pcd", "rooms.pcd"))
        kept = rooms.label == CEILING
        for room in np.unique(rooms.room[kept]):
            dots(ax, to_axes(cell_centres(rooms.xyz[kept & (rooms.room == room)])), shades[(room - 1) % 4], 7)
        dots(ax, to_axes(cell_centres(planes.xyz[(planes.label == CEILING) & ~kept])), COLOURS[DETAIL], 5)
        as_plan(ax, scene, x, y)
    note(axes[0], "facade,\nseen through\nthe window", (15.4, 6.5), (11.4, 8.2))
    note(axes[0], "corridor,\nseen through\nthe door", (6.2, -1.6), (2.2, -4.8))
    add_legend(fig, [("regions kept: rooms", shades[0]), ("rejected", COLOURS[DETAIL])])
    return fig


def grid_slice_detail(data):
    cloud = Cloud(data / "bls_room/details.pcd")
    fig = plt.figure(figsize=(12, 4.5), dpi=DPI, facecolor="white")
    plan, ax = place(fig, 0.05, 0.7, 4.7, 3.4), place(fig, 5.4, 1.1, 6.4, 3.0)
    for label in (CEILING, DETAIL):
        dots(plan, to_study_plan(cell_centres(cloud.only(label))), COLOURS[label], 16)
    as_plan(plan, "ceiling from above", (-0.2, 6.4), (-0.2, 5))
    study_section(ax, cloud, (OTHER, FLOOR, CEILING, DETAIL))
    ax.set_title("vertical section, and two slices")
    for share, text in ((1 / 4, "slice at 1/4 of the height"), (1 / 2, "slice at 1/2")):
        ax.axhline(2.8 * (1 - share), color=INK, linestyle="--", linewidth=1)
        ax.text(0.65, 2.8 * (1 - share) + 0.04, text, fontsize=12)
    add_legend(fig, [CEILING, DETAIL, FLOOR, OTHER])
    return fig


def floor_projection_recovery(data):
    before, after = (Cloud(data / "bls_room" / name).only(FLOOR) for name in ("details.pcd", "floor.pcd"))
    filled, removed = added_rows(after, before), added_rows(before, after)
    fig, axes = new_figure(4.6, [1, 1])
    panels = [("floor as scanned", before, removed, COLOURS[DETAIL]),
              ("completed from the ceiling", after, filled, FILLED)]
    for ax, (title, points, marked, colour) in zip(axes, panels):
        dots(ax, to_study_plan(cell_centres(points[~marked])), COLOURS[FLOOR], 12)
        dots(ax, to_study_plan(cell_centres(points[marked])), colour, 12)
        as_plan(ax, title, (-0.9, 7.1), (-1.4, 5.1))
    add_legend(fig, [("seen", COLOURS[FLOOR]), ("outside: removed", COLOURS[DETAIL]), ("hidden: projected", FILLED)])
    return fig


def floorplan_fitting(data):
    fig = plt.figure(figsize=(12, 5.9), dpi=DPI, facecolor="white")
    quarter_turn = lambda points: points @ np.array([[0, -1], [1, 0]])
    panels = [("hls_hall", place(fig, 0.1, 0.6, 6.6, 4.8), lambda p: p, (-0.4, 16.6), (-0.6, 11.6)),
              ("syn_flat", place(fig, 6.6, 2.75, 5.3, 2.8), quarter_turn, (-0.3, 14.3), (-7.6, 0.3)),
              ("bls_room", place(fig, 6.6, 0.5, 5.3, 1.95), to_study_plan, (-0.3, 6.5), (-0.2, 5))]
    for scene, ax, to_axes, x, y in panels:
        dots(ax, to_axes(Cloud(data / scene / "walls.pcd").only(WALL, COLUMN)[:, :2]), "#8fd19b", 3)
        for room in read_rooms(data / scene / "model/floorplan.json"):
            draw_room(ax, room, to_axes)
        as_plan(ax, scene, x, y)
    add_legend(fig, [("wall points", "#8fd19b"), ("walls: segments and arcs", INK), COLUMN, DETAIL])
    return fig


def structure_refinement(data):
    hall = data / "hls_hall"
    before, after = (Cloud(hall / name).only(WALL) for name in ("walls.pcd", "refined.pcd"))
    places = [("corner", (-0.1, 1.1), (-0.2, 1)), ("curved wall", (14.85, 16.25), (6.9, 8.3))]
    fig, axes = new_figure(3.4, [1, 1, 1, 1], wspace=0.06)
    for k, (name, x, y) in enumerate(places):
        for ax, points, when in zip(axes[2 * k:], (before, after), ("found", "refined")):
            dots(ax, points[inside(points, x, y)], COLOURS[WALL], 3)
            as_plan(ax, f"{name}, {when}", x, y)
            add_ruler(ax, 0.1, "10 cm")
        for room in read_rooms(hall / "plan.json"):
            draw_loop(axes[2 * k], room["boundary"], INK, linewidths=1.2)
    add_legend(fig, [("wall points, from above", COLOURS[WALL]), ("floor plan", INK)])
    return fig


def vertical_hole_repair(data):
    before, after = (Cloud(data / "bls_room" / name).only(WALL) for name in ("refined.pcd", "repaired.pcd"))
    filled = added_rows(after, before)
    old, new = to_study(before), to_study(after)
    wall = lambda points: np.abs(points[:, 1]) < 0.03
    fig, axes = new_figure(3.5, [1, 1])
    dots(axes[0], old[wall(old)], COLOURS[WALL], 7, (0, 2))
    dots(axes[1], new[wall(new) & ~filled], COLOURS[WALL], 9, (0, 2))
    dots(axes[1], new[wall(new) & filled], FILLED, 9, (0, 2))
    for ax, title in zip(axes, ("a wall, seen frontally", "repaired")):
        as_plan(ax, title, (-0.1, 6.3), (-0.1, 2.9))
    for text, at in (("door", (5.3, 1)), ("sideboard", (3.72, 0.4))):
        axes[0].text(*at, text, ha="center", va="center", fontsize=12)
    add_legend(fig, [("scanned", COLOURS[WALL]), ("filled", FILLED)])
    return fig


def structural_poisson(data):
    mesh = labelled_mesh(data / "hls_hall")
    fig, axes = new_figure(4.6, [1.7, 1])
    whole = render(open_mesh(mesh, HALL_CUT), mesh.GetBounds(), *HALL_VIEW)
    show_render(axes[0], whole, "hls_hall, ceiling cut off")
    box = bounds_of(np.array([[3.95, 2.95, 0], [4.55, 3.55, 0.6]]))
    triangles = show_edges(inner_actor(with_normals(mesh)))
    close_up = render([triangles], box, *HALL_VIEW, shape=(900, 900), crop=False)
    show_render(axes[1], close_up, "its triangles: foot of a column")
    add_legend(fig, [FLOOR, WALL, COLUMN])
    return fig


def distances(mesh, truth):
    """Distance of every vertex to the truth, in metres."""
    function = vtk.vtkImplicitPolyDataDistance()
    function.SetInput(truth)
    values = vtk.vtkDoubleArray()
    function.FunctionValue(mesh.GetPoints().GetData(), values)
    return np.abs(vtk_to_numpy(values))


def mesh_evaluation(data):
    study = data / "bls_room"
    mesh = read_mesh(study / "model/mesh.ply")
    far = 100 * distances(mesh, read_mesh(study / "truth.ply"))
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0, 2), "YlOrRd")
    paint(mesh, scale.to_rgba(far, bytes=True)[:, :3])
    fig, axes = new_figure(4.2, [1.15, 1.15, 1], bottom=0.2, right=0.985, wspace=0.2)
    above = render(open_mesh(mesh, STUDY_CUT), mesh.GetBounds(), *STUDY_VIEW)
    below = render(open_mesh(mesh, 0.6, False), mesh.GetBounds(), *STUDY_BELOW)
    show_render(axes[0], above, "ceiling cut off")
    show_render(axes[1], below, "from below, floor cut off")
    bar = place(fig, 2, 0.65, 4, 0.15)
    fig.colorbar(scale, cax=bar, orientation="horizontal", extend="max", label="distance to truth, cm")
    draw_histogram(axes[2], far)
    return fig


def draw_histogram(ax, far):
    ax.hist(far, bins=np.arange(0, 6, 0.1), color=COLOURS[FLOOR], weights=np.full(len(far), 100 / len(far)), log=True)
    ax.set(title="vertices of the mesh", xlabel="distance to truth, cm", ylabel="% of them",
           xlim=(0, 6), ylim=(0.003, 130))
    ax.yaxis.set_major_formatter("{x:g}")
    text = f"mean {far.mean():.2f} cm\n95 % below {np.percentile(far, 95):.1f} cm\nfarthest {far.max():.1f} cm"
    ax.text(0.95, 0.94, text, transform=ax.transAxes, ha="right", va="top")


def indoor_structure_reconstruction(data):
    study, hall, flat = (labelled_mesh(data / name) for name in ("bls_room", "hls_hall", "syn_flat"))
    fig, axes = new_figure(4.1, [1, 1.2, 1.05])
    show_render(axes[0], render(open_mesh(study, 0.6, False), study.GetBounds(), *STUDY_BELOW), "bls_room, from below")
    show_render(axes[1], render(open_mesh(hall, HALL_CUT), hall.GetBounds(), *HALL_VIEW), "hls_hall")
    show_render(axes[2], render(open_mesh(flat, FLAT_CUT), flat.GetBounds(), *FLAT_VIEW), "syn_flat")
    add_legend(fig, [CEILING, DETAIL, FLOOR, WALL, COLUMN])
    return fig


PICTURES = [overview, parallel_voxel_grid, horizontal_plane_detection, grid_region_outlier_removal, grid_slice_detail,
            floor_projection_recovery, floorplan_fitting, structure_refinement, vertical_hole_repair,
            structural_poisson, mesh_evaluation, indoor_structure_reconstruction]


def main(data, output, *wanted):
    for picture in PICTURES:
        if not wanted or picture.__name__ in wanted:
            save(picture(Path(data)), Path(output) / f"{picture.__name__}.png")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
