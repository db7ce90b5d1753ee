# SPDX-License-Identifier: BSD-3-Clause
"""Parts of floor plans as JSON holds them, for tests in Python."""

import math


def segment(start, end, **more):
    return dict({"type": "segment", "start": start, "end": end, "inliers": 900, "residual": 0.004}, **more)


def arc(centre, radius, start, end, counter_clockwise=True):
    return dict(segment(start, end), type="arc", centre=centre, radius=radius,
                counter_clockwise=counter_clockwise)


def polygon(corners):
    return [segment(a, b) for a, b in zip(corners, corners[1:] + corners[:1])]


def rectangle(x0, y0, x1, y1, clockwise=False):
    corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]
    return polygon(corners[::-1] if clockwise else corners)


def slab(height, slope_x=0, slope_y=0):
    size = math.sqrt(1 + slope_x ** 2 + slope_y ** 2)
    return {"plane": [-slope_x / size, -slope_y / size, 1 / size, -height / size], "inliers": 9000,
            "residual": 0.003}


def room(number, boundary, floor, ceiling, **more):
    return dict({"id": number, "floor": floor, "ceiling": ceiling, "boundary": boundary, "columns": [],
                 "details": [], "floor_details": [], "niches": []}, **more)
