# SPDX-License-Identifier: BSD-3-Clause
"""Plane geometry of plans: points are (x, y), outlines lists of points, counter-clockwise, all in metres."""
import math

from shapely.geometry import box
from shapely.geometry.polygon import orient
from shapely.ops import unary_union

SAME = 1e-6


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1])


def along(a, u, s):
    """The point s metres from a in the direction u."""
    return (a[0] + s * u[0], a[1] + s * u[1])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def length(a):
    return math.hypot(a[0], a[1])


def area(outline):
    return 0.5 * sum(cross(a, b) for a, b in edges(outline))


def edges(outline):
    return list(zip(outline, outline[1:] + outline[:1]))


def frame(edge):
    """Start, direction, outward normal and length of an edge."""
    a, b = edge
    d = sub(b, a)
    n = length(d)
    u = (d[0] / n, d[1] / n)
    return a, u, (u[1], -u[0]), n


def inside(outline, p):
    odd = False
    for a, b in edges(outline):
        if (a[1] > p[1]) != (b[1] > p[1]) and p[0] < a[0] + (p[1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1]):
            odd = not odd
    return odd


def edge_distance(edge, p):
    a, u, _, n = frame(edge)
    s = min(max(dot(sub(p, a), u), 0.0), n)
    return length(sub(p, along(a, u, s)))


def wall_distance(outline, p):
    return min(edge_distance(e, p) for e in edges(outline))


def crosses(p, q, edge):
    """True if the line of sight from p to q meets an edge."""
    a, b = edge
    d, e = sub(q, p), sub(b, a)
    k = cross(d, e)
    if abs(k) < 1e-12:
        return False
    t, s = cross(sub(a, p), e) / k, cross(sub(a, p), d) / k
    return 1e-9 < t < 1 - 1e-9 and -1e-9 <= s <= 1 + 1e-9


def sees(p, q, loops):
    return not any(crosses(p, q, e) for loop in loops for e in edges(loop))


def bounds(outline):
    x, y = [p[0] for p in outline], [p[1] for p in outline]
    return min(x), min(y), max(x), max(y)


def rectangle(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def is_rectangle(outline):
    x0, y0, x1, y1 = bounds(outline)
    return len(outline) == 4 and abs(area(outline) - (x1 - x0) * (y1 - y0)) < SAME


def turned_rectangle(centre, width, depth, yaw):
    """Corners of a rectangle whose width runs in the direction yaw, in radians."""
    c, s = math.cos(yaw), math.sin(yaw)
    half = [(-width / 2, -depth / 2), (width / 2, -depth / 2), (width / 2, depth / 2), (-width / 2, depth / 2)]
    return [(centre[0] + c * x - s * y, centre[1] + s * x + c * y) for x, y in half]


def meet(a, b):
    """True if two convex outlines have an area in common."""
    for loop in (a, b):
        for e in edges(loop):
            o, _, n, _ = frame(e)
            other = b if loop is a else a
            if min(dot(sub(p, o), n) for p in other) > -SAME:
                return False
    return True


def union_outline(rects):
    """Outline of rectangles (x0, y0, x1, y1) that lie side by side; None if it is not one loop."""
    shape = unary_union([box(*r) for r in rects])
    if shape.geom_type != "Polygon" or shape.interiors:
        return None
    corners = list(orient(shape).exterior.coords)[:-1]
    first = corners.index(min(corners))
    return without_steps_of_nothing(corners[first:] + corners[:first])


def inset(outline, thickness):
    """A rectilinear outline moved inwards by half the thickness of the wall that each edge is the middle of.

    thickness(axis, value) is that of the line x = value (axis 0) or y = value (axis 1).
    """
    moved = []
    for e in edges(outline):
        a, _, n, _ = frame(e)
        axis = 0 if abs(n[0]) > 0.5 else 1
        moved.append((axis, a[axis] - n[axis] * thickness(axis, a[axis]) / 2))
    points = []
    for k, (axis, value) in enumerate(moved):
        before = moved[k - 1][1]
        points.append((round(value, 4), round(before, 4)) if axis == 0 else (round(before, 4), round(value, 4)))
    return without_steps_of_nothing(points)


def without_steps_of_nothing(outline):
    """The outline without repeated corners and corners within a straight wall: thicknesses can even a step out."""
    corners = [p for k, p in enumerate(outline) if p != outline[k - 1]]
    return [p for k, p in enumerate(corners)
            if abs(cross(sub(p, corners[k - 1]), sub(corners[(k + 1) % len(corners)], p))) > 1e-9]
