# SPDX-License-Identifier: BSD-3-Clause
"""Renders the models of README.md and of the pages on the chain and on evaluation, in perspective;
doc/make_images.sh prepares the data. The pictures of the stages are drawn by the programs themselves.

   xvfb-run /usr/bin/python3 doc/make_images.py DATA OUTPUT [PICTURE...]

DATA holds a folder a scene: scan.pcd, truth.ply and model/ (what pcl_sedr left). Without a PICTURE all
are drawn.
"""
import sys
from collections import Counter
from pathlib import Path

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import vtk
from matplotlib.lines import Line2D
from PIL import Image
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "test/benchmarks"))
from proving import pcd

OTHER, CEILING, FLOOR, WALL, DETAIL, COLUMN = range(6)
NAMES = ["other", "ceiling", "floor", "wall", "detail", "column"]
COLOURS = ["#9b9b9b", "#f0901e", "#2d72c4", "#36a04a", "#d8302c", "#8d44b0"]
INK = "#222222"
DPI = 100

plt.rcParams.update({
    "font.family": "DejaVu Sans", "font.size": 13, "axes.titlesize": 14, "axes.edgecolor": "#888888",
    "text.color": INK, "axes.labelcolor": INK, "xtick.color": INK, "ytick.color": INK,
    "xtick.labelsize": 12, "ytick.labelsize": 12, "legend.frameon": False, "legend.fontsize": 13,
    "legend.handletextpad": 0.2, "legend.columnspacing": 1.2})


# ---- data

class Cloud:
    """The points of a PCD file: xyz and normal (n x 3), label, room; zeros for what it has not."""

    def __init__(self, path):
        rows = pcd.read(path)
        self.xyz = pcd.places(rows)
        field = lambda name: rows[name] if name in rows.dtype.names else np.zeros(len(rows))
        self.normal = np.stack([field(f"normal_{axis}") for axis in "xyz"], axis=1)
        self.label, self.room = field("label").astype(int), field("room").astype(int)


def read_mesh(path):
    reader = vtk.vtkPLYReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def between(values, low, high):
    return (values >= low) & (values < high)


def inside(points, x, y):
    return between(points[:, 0], *x) & between(points[:, 1], *y)


def millions(n):
    return f"{n / 1e6:.2f} million points" if n >= 1e6 else f"{n / 1e3:.0f} thousand points"


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
    data.GetCellData().Initialize()
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


def labelled_mesh(scene, model="model"):
    return with_labels(read_mesh(scene / model / "mesh.ply"), Cloud(scene / model / "structure.pcd"))


def overview(data):
    hall = data / "hls_hall"
    scan, structure = Cloud(hall / "scan.pcd"), Cloud(hall / "model/structure.pcd")
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


def read_solid(path, *without):
    """The sides of a solid's faces that face the room, in the colours of their labels, and the outlines of
    all elements; faces of the labels in `without` are left out."""
    header, body = path.read_bytes().split(b"end_header\n", 1)
    count = lambda name: int(header.split(b"element " + name + b" ")[-1].split()[0])
    vertex = np.dtype([("xyz", "<f4", 3), ("colour", "u1", 3), ("label", "<u4"), ("room", "<u4")])
    vertices = np.frombuffer(body, vertex, count(b"vertex"))
    points = np.ascontiguousarray(vertices["xyz"])
    row = np.dtype([("corners", "u1"), ("vertices", "<i4", 3), ("label", "<i4"), ("room", "<i4"), ("element", "<i4")])
    faces = np.frombuffer(body, row, count(b"face"), vertices.nbytes)
    faces = faces[~np.isin(faces["label"], without)]
    sides = Counter()
    for (a, b, c), element in zip(faces["vertices"].tolist(), faces["element"].tolist()):
        sides.update((min(s), max(s), element) for s in ((a, b), (b, c), (c, a)))
    mesh, outline = vtk.vtkPolyData(), vtk.vtkPolyData()
    corners = np.ascontiguousarray(points[faces["vertices"][:, ::-1]].reshape(-1, 3))
    for data, xyz, size in ((mesh, corners, 3), (outline, points, 2)):
        vertices = vtk.vtkPoints()
        vertices.SetData(numpy_to_vtk(xyz, deep=True))
        data.SetPoints(vertices)
        cells = np.arange(len(corners)).reshape(-1, 3) if size == 3 else \
            np.array([s[:2] for s, n in sides.items() if n == 1])
        array = vtk.vtkCellArray()
        array.SetData(size, numpy_to_vtkIdTypeArray(np.ravel(cells).astype(np.int64), deep=True))
        (data.SetPolys if size == 3 else data.SetLines)(array)
    paint(mesh, label_colours(np.repeat(faces["label"], 3)))
    lines = actor_of(outline)
    lines.GetProperty().SetColor(*rgb(INK))
    lines.GetProperty().SetLineWidth(1.5)
    return [inner_actor(with_normals(mesh)), lines]


def floorplan_extrusion(data):
    study, hall = (data / scene / "model/solid.ply" for scene in ("bls_room", "hls_hall"))
    fig, axes = new_figure(4.6, [1, 1.35])
    below = render(read_solid(study, FLOOR), read_mesh(study).GetBounds(), *STUDY_BELOW)
    above = render(read_solid(hall, CEILING), read_mesh(hall).GetBounds(), *HALL_VIEW)
    show_render(axes[0], below, "bls_room from below, without its floor")
    show_render(axes[1], above, "hls_hall without its ceiling")
    add_legend(fig, [CEILING, FLOOR, WALL, DETAIL, COLUMN])
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
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0, 0.05), "YlOrRd")
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
    ax.hist(far, bins=np.arange(0, 0.4, 0.005), color=COLOURS[FLOOR], weights=np.full(len(far), 100 / len(far)), log=True)
    ax.set(title="vertices of the mesh", xlabel="distance to truth, cm", ylabel="% of them",
           xlim=(0, 0.4), ylim=(0.0005, 130))
    ax.yaxis.set_major_formatter("{x:g}")
    text = f"mean {far.mean():.3f} cm\n95 % below {np.percentile(far, 95):.3f} cm\nfarthest {far.max():.2f} cm"
    ax.text(0.95, 0.94, text, transform=ax.transAxes, ha="right", va="top")


def indoor_structure_reconstruction(data):
    study, hall, flat = (labelled_mesh(data / name) for name in ("bls_room", "hls_hall", "syn_flat"))
    fig, axes = new_figure(4.1, [1, 1.2, 1.05])
    show_render(axes[0], render(open_mesh(study, 0.6, False), study.GetBounds(), *STUDY_BELOW), "bls_room, from below")
    show_render(axes[1], render(open_mesh(hall, HALL_CUT), hall.GetBounds(), *HALL_VIEW), "hls_hall")
    show_render(axes[2], render(open_mesh(flat, FLAT_CUT), flat.GetBounds(), *FLAT_VIEW), "syn_flat")
    add_legend(fig, [CEILING, DETAIL, FLOOR, WALL, COLUMN])
    return fig


PICTURES = [overview, floorplan_extrusion, mesh_evaluation, indoor_structure_reconstruction]


def main(data, output, *wanted):
    for picture in PICTURES:
        if not wanted or picture.__name__ in wanted:
            save(picture(Path(data)), Path(output) / f"{picture.__name__}.png")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
