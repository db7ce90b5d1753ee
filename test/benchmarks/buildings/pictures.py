# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a graded building: truth filled, found outlines in red, a panel a storey."""

COLOURS = {"right": "#9fd8a0", "missed": "#f5a3a3", "merged": "#f7c98b", "split": "#d9b8f0", "shape": "#f3e88a"}
NOT_COUNTED = "#dddddd"


def rings(plan):
    for part in getattr(plan, "geoms", [plan]):
        if part.geom_type == "Polygon" and not part.is_empty:
            yield [part.exterior.coords] + [r.coords for r in part.interiors]


def storey_of(place, truth):
    """The storey of the true room that a found one shares most height with."""
    def common(t):
        return min(t.high, place.high) - max(t.low, place.low)
    near = [t for t in truth if t.plan.intersects(place.plan)] or truth
    return max(near, key=lambda t: (round(common(t), 1), t.plan.intersection(place.plan).area)).storey


def draw(path, title, graded, points=None):
    """Writes a PNG."""
    import matplotlib
    truth = list(zip(graded["wanted"], graded["fates"], graded["best"])) + [(r, None, None) for r in graded["rest"]]
    places = [t for t, _, _ in truth]
    storeys = sorted({t.storey for t in places})
    found = [(f, storey_of(f, places)) for f in graded["found"]]
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    box = bounds(places)
    wide, high = box[2] - box[0] + 2, box[3] - box[1] + 3
    is_stacked = wide > 1.2 * high
    scale = 10 / max(wide, high)
    rows, columns = (len(storeys), 1) if is_stacked else (1, len(storeys))
    figure, panels = plt.subplots(rows, columns, figsize=(scale * wide * columns + 1, scale * high * rows + 1), squeeze=False)
    for panel, storey in zip(panels.flat, storeys):
        if points is not None:
            floor = min(t.low for t in places if t.storey == storey)
            slice_ = points[(points["z"] > floor + 1.3) & (points["z"] < floor + 1.5)][::3]
            panel.plot(slice_["x"], slice_["y"], ",", color="#999999", zorder=0)
        for t, fate, best in truth:
            if t.storey != storey:
                continue
            fill(panel, t.plan, COLOURS.get(fate, NOT_COUNTED), "k")
            fill(panel, t.ignored, "none", "#0060c0")
            at = t.plan.representative_point()
            note = f"{best:.2f}" if fate else "seen {:.2f} {:.2f}".format(*t.seen)
            panel.text(at.x, at.y, f"{t.name}\n{t.area:.1f}\n{note}", fontsize=6, ha="center", va="center", zorder=5)
        for f, of in found:
            if of == storey:
                for ring in (r for part in rings(f.plan) for r in part):
                    panel.plot(*zip(*ring), color="#d00000", lw=1.5, zorder=4)
        panel.set_xlim(box[0] - 1, box[2] + 1)
        panel.set_ylim(box[1] - 1, box[3] + 1)
        panel.set_aspect("equal")
        panel.set_title(f"storey {storey}", fontsize=8)
    figure.suptitle(title, fontsize=9)
    figure.tight_layout()
    figure.savefig(path, dpi=80)
    plt.close(figure)


def fill(panel, plan, face, edge):
    for part in rings(plan):
        panel.fill(*zip(*part[0]), facecolor=face, edgecolor=edge, lw=1, alpha=0.75, zorder=1)
        for hole in part[1:]:
            panel.fill(*zip(*hole), facecolor="white", edgecolor=edge, lw=1, zorder=2)


def bounds(places):
    boxes = [p.plan.bounds for p in places]
    return min(b[0] for b in boxes), min(b[1] for b in boxes), max(b[2] for b in boxes), max(b[3] for b in boxes)
