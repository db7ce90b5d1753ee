# SPDX-License-Identifier: BSD-3-Clause
"""The table of the proving ground as Markdown. A row is a scene and a noise."""
SOLID_BARS = ("solid closed", "solid mean", "solid max", "solid volume", "solid crossing", "wall surface", "triangles", "area",
              "radius", "corners")
MODEL_BARS = ("rooms", "closed", "components", "mean", "1 cm", "5 cm", "model > 5 cm", "details", "points > 5 cm", "covered")
LABELS = ("ceiling", "floor", "wall", "detail")
LEGEND = """
A row is a scene and a noise: of each figure the worst over all seeds and, where it reads differently, the
median in brackets. Figures in bold miss their bar in at least one run. Shares and errors are in per cent.
What the columns mean and where the bars lie: [the proving ground](proving_ground.md).

"""


def parsed(runs):
    """Rows of a table with their bars and stages."""
    for run in runs:
        run["bars"] = [bar for bar in run["missed_bars"].split(";") if bar]
        run["stages"] = dict(stage.split("=") for stage in run["stage_seconds"].split(";") if stage)
        run["extrusion"] = run["stages"].get("FloorplanExtrusion", "")
    return runs


def grouped(runs, *keys):
    groups = {}
    for run in runs:
        groups.setdefault(tuple(run[k] for k in keys), []).append(run)
    return groups


def figures(group, column):
    return sorted(float(run[column]) for run in group if run[column])


def median(values):
    return values[(len(values) - 1) // 2]


def misses(group, *bars):
    return sum(any(bar in run["bars"] for bar in bars) for run in group)


def marked(text, is_missed):
    return f"**{text}**" if is_missed else text


def missed(group, bars):
    counts = [(bar, misses(group, bar)) for bar in ("failed", *bars)]
    return ", ".join(f"{bar} {count}/{len(group)}" for bar, count in counts if count)


def figure(column, decimals, scale=100, bar=None, worse=max):
    """The cell of a figure: its worst value and, in brackets, its median."""
    def cell(group):
        values = figures(group, column)
        if not values:
            return "-"
        worst, middle = (f"{scale * value:.{decimals}f}" for value in (worse(values), median(values)))
        return marked(worst if worst == middle else f"{worst} ({middle})", bar and misses(group, bar))
    return cell


def found_of(found, true, *bars):
    """The cell of a number of found and of true things: "4/4", or "3-5/4" if the seeds differ."""
    def cell(group):
        values = [int(value) for value in figures(group, found)]
        if not values:
            return "-"
        text = f"{values[0]}" if values[0] == values[-1] else f"{values[0]}-{values[-1]}"
        return marked(f"{text}/{int(figures(group, true)[-1])}", misses(group, *bars))
    return cell


def sound(closed, other_bar, other):
    """The cell of closed meshes: "yes", or how many are not, or have another fault."""
    def cell(group):
        is_open, others = misses(group, closed), misses(group, other_bar)
        if misses(group, "failed") == len(group):
            return "-"
        text = f"no {is_open}" if is_open else "yes"
        return marked(text + (f", {other} {others}" if others else ""), is_open + others)
    return cell


def label(name):
    def cell(group):
        recall, precision = figures(group, f"{name}_recall"), figures(group, f"{name}_precision")
        if not recall:
            return "-"
        return f"{100 * recall[0]:.1f} / " + (f"{100 * precision[0]:.1f}" if precision else "-")
    return cell


FIRST = [("scene", lambda group: group[0]["scene"]), ("noise, cm", lambda group: f"{100 * float(group[0]['noise']):.4g}")]
MODEL = [("closed", sound("closed", "components", "parts")),
         ("mean, cm", figure("truth_to_mesh_mean", 3, bar="mean")),
         ("max, cm", figure("truth_to_mesh_max", 1)),
         ("≤ 1 cm", figure("truth_within_1cm", 2, bar="1 cm", worse=min)),
         ("≤ 5 cm", figure("truth_within_5cm", 2, bar="5 cm", worse=min)),
         ("model mean, cm", figure("mesh_to_truth_mean", 3)),
         ("model max, cm", figure("mesh_to_truth_max", 1)),
         ("model > 5 cm", figure("mesh_beyond_5cm", 2, bar="model > 5 cm")),
         ("details ≤ 5 cm", figure("detail_within_5cm", 2, bar="details", worse=min))]
STRUCTURE = [("mean, cm", figure("points_to_truth_mean", 3)),
             ("max, cm", figure("points_to_truth_max", 1)),
             ("points > 5 cm", figure("points_beyond_5cm", 2, bar="points > 5 cm")),
             ("covered", figure("truth_covered", 2, bar="covered", worse=min))]
SOLID = FIRST + [("closed", sound("solid closed", "solid crossing", "crossing")),
                 ("mean, cm", figure("truth_to_solid_mean", 4, bar="solid mean")),
                 ("max, cm", figure("truth_to_solid_max", 3, bar="solid max")),
                 ("solid to truth max, cm", figure("solid_to_truth_max", 3)),
                 ("area", figure("area_error", 2, bar="area")),
                 ("perimeter", figure("perimeter_error", 2)),
                 ("volume", figure("solid_volume_error", 2, bar="solid volume")),
                 ("wall surface", figure("solid_wall_area_error", 2, bar="wall surface")),
                 ("radius", figure("radius_error", 2, bar="radius")),
                 ("corners", found_of("corners_found", "corners_true", "corners")),
                 ("corner off, cm", figure("corner_distance_max", 3)),
                 ("triangles", figure("solid_triangles", 0, 1, "triangles")),
                 ("ms", figure("extrusion", 0, 1000)),
                 ("missed", lambda group: missed(group, SOLID_BARS))]


def columns(with_mesh):
    return (FIRST + [("rooms", found_of("rooms_found", "rooms_true", "rooms", "failed"))] + (MODEL if with_mesh else STRUCTURE) +
            [("area", figure("area_error", 2)), ("height", figure("height_error", 2)),
             ("volume", figure("mesh_volume_error" if with_mesh else "volume_error", 2))] +
            [(name, label(name)) for name in LABELS] +
            [("s", figure("seconds", 1, 1)), ("missed", lambda group: missed(group, MODEL_BARS))])


def row(cells):
    return "| " + " | ".join(cells) + " |\n"


def run_table(runs, cells):
    text = row(title for title, _ in cells) + row("---" for _ in cells)
    for of_scene in grouped(runs, "scene").values():
        for noise in sorted({float(run["noise"]) for run in of_scene}):
            group = [run for run in of_scene if float(run["noise"]) == noise]
            text += row(cell(group) for _, cell in cells)
    return text


def stage_table(runs):
    stages = list(dict.fromkeys(stage for run in runs for stage in run["stages"]))
    titles = ["scene", "points, M", *stages, "all"]
    text = "\n## Seconds of each stage, median of all runs of a scene\n\n" + row(titles) + row("---" for _ in titles)
    for (scene,), group in grouped(runs, "scene").items():
        def cell(values, scale=1):
            values = sorted(float(value) for value in values if value)
            return f"{scale * median(values):.2f}" if values else "-"
        text += row([scene, cell((run["points"] for run in group), 1e-6)] +
                    [cell(run["stages"].get(stage) for run in group) for stage in stages] +
                    [cell(run["seconds"] for run in group)])
    return text


def failures(runs):
    lines = [f"- {run['scene']}, noise {100 * float(run['noise']):.4g} cm, seed {run['seed']}: {run['failure']}\n"
             for run in runs if run["failure"]]
    return "\n## What failed\n\n" + "".join(lines) if lines else ""


def summary(runs, bars):
    seeds = ", ".join(str(seed) for seed in sorted({int(run["seed"]) for run in runs}))
    text = missed(runs, bars)
    return (f"Scenes: {len(grouped(runs, 'scene'))}. Seeds: {seeds}. Runs: {len(runs)}. "
            f"Runs that reach every bar: {len(runs) - misses(runs, 'failed', *bars)}." + (f" Missed: {text}." if text else "") + "\n")


def text(runs):
    """All tables of the rows of RUNS.csv."""
    runs = parsed(runs)
    told = "<!-- SPDX-License-Identifier: BSD-3-Clause -->\n# The proving ground: figures\n"
    for with_mesh, title in ("1", "Models"), ("0", "Structure alone, no mesh made"):
        kind = [run for run in runs if run["with_mesh"] == with_mesh]
        if kind:
            told += (f"\n## {title}\n\n" + summary(kind, MODEL_BARS) + LEGEND + run_table(kind, columns(with_mesh == "1")) +
                     failures(kind) + stage_table(kind))
    return told + "\n## Plans and solids\n\n" + summary(runs, SOLID_BARS) + "\n" + run_table(runs, SOLID)
