# SPDX-License-Identifier: BSD-3-Clause
"""The requirements for every run of the proving ground (doc/proving_ground.md). A figure that is not known misses its bar."""

MAX_STRAIGHT_TRIANGLES = 5000
NAMES = ("rooms", "closed", "components", "mean", "1 cm", "5 cm", "model > 5 cm", "details", "points > 5 cm", "covered", "solid closed",
         "solid crossing", "solid mean", "solid max", "solid volume", "wall surface", "triangles", "area", "radius", "corners", "failed")


def mean_limit(noise):
    """Metres, truth to mesh: 0.2 cm up to a noise of 0.1 cm, 0.4 cm from 2 cm on, linear in between."""
    return 0.002 + min(max((noise - 0.001) / 0.019, 0), 1) * 0.002


def solid_limits(noise):
    """Metres, truth to solid: mean and maximum."""
    return (0.0001, 0.001) if noise <= 0.001 else (0.0003, 0.005) if noise <= 0.01 else (0.001, 0.01)


def missed(row):
    """The bars that a run missed, each with its figure in words: [("rooms", "3 rooms of 4")]. The bars of a mesh apply if one
    was requested, otherwise those of points; without details or arcs, their bars do not apply. NaN is not known."""
    row = {column: value if value == value else None for column, value in row.items()}
    if row.get("failure"):
        return [("failed", "failed")]
    misses = []

    def at_least(bar, column, least, what):
        value = row.get(column)
        if value is None or value < least:
            misses.append((bar, f"{what} {100 * value:.2f} % < {100 * least:.0f} %" if value is not None else f"{what} not known"))

    def at_most(bar, column, most, what, scale=100, unit="%", decimals=(2, 1)):
        value = row.get(column)
        if value is None or value > most:
            found = f"{scale * value:.{decimals[0]}f} {unit}" if value is not None else "not known"
            misses.append((bar, f"{what} {found} > {scale * most:.{decimals[1]}f} {unit}"))

    found, true = row.get("rooms_found"), row.get("rooms_true")
    if found != true:
        misses.append(("rooms", f"{found} rooms of {true}"))
    elif row.get("rooms_matched") != true:
        misses.append(("rooms", f"{row.get('rooms_matched')} of {true} rooms where they should be"))
    if row["with_mesh"]:
        if not row.get("closed_manifold"):
            misses.append(("closed", "not manifold" if row.get("closed") else "not closed"))
        if row.get("components") != found:
            misses.append(("components", f"{row.get('components', 0)} components for {found} rooms"))
        at_most("mean", "truth_to_mesh_mean", mean_limit(row["noise"]), "mean", 100, "cm", (3, 3))
        at_least("1 cm", "truth_within_1cm", 0.95, "within 1 cm")
        at_least("5 cm", "truth_within_5cm", 0.99, "within 5 cm")
        at_most("model > 5 cm", "mesh_beyond_5cm", 0.005, "model beyond 5 cm")
        if "detail_within_5cm" in row:
            at_least("details", "detail_within_5cm", 0.97, "details within 5 cm")
    else:
        at_most("points > 5 cm", "points_beyond_5cm", 0.005, "points beyond 5 cm")
        at_least("covered", "truth_covered", 0.99, "truth covered")
    if row.get("solid_components") is None:
        misses.append(("solid closed", "no solid"))
    else:
        if not row["solid_closed_manifold"] or row["solid_components"] < found:
            misses.append(("solid closed", "solid not closed"))
        if row["solid_self_intersections"]:
            misses.append(("solid crossing", f"{row['solid_self_intersections']} pairs of the solid's triangles meet"))
        mean, largest = solid_limits(row["noise"])
        at_most("solid mean", "truth_to_solid_mean", mean, "solid: mean", 100, "cm", (4, 2))
        at_most("solid max", "truth_to_solid_max", largest, "solid: max", 100, "cm", (3, 1))
        at_most("solid volume", "solid_volume_error", 0.005, "solid's volume")
        at_most("wall surface", "solid_wall_area_error", 0.02, "wall surface")
        if row.get("arcs_true") == 0 and row["solid_triangles"] > MAX_STRAIGHT_TRIANGLES:
            misses.append(("triangles", f"{row['solid_triangles']} triangles of straight walls"))
    at_most("area", "area_error", 0.01, "area")
    if "radius_error" in row:
        at_most("radius", "radius_error", 0.01, "radius")
    if row.get("rooms_with_other_corners") != 0:
        misses.append(("corners", f"{row.get('corners_found', 0)} corners of {row.get('corners_true', 0)}"))
    return misses
