"""Lines through measured points."""

import math


def power_law(points):
    """The exponent of y over x by least squares of the logarithms, and how much of the variance it explains."""
    xs, ys = [math.log(x) for x, _ in points], [math.log(y) for _, y in points]
    mean_x, mean_y = sum(xs) / len(xs), sum(ys) / len(ys)
    xx = sum((x - mean_x) ** 2 for x in xs)
    xy = sum((x - mean_x) * (y - mean_y) for x, y in zip(xs, ys))
    yy = sum((y - mean_y) ** 2 for y in ys)
    return xy / xx, xy * xy / (xx * yy) if yy > 0 else 1


def base_and_slope(points):
    """y = base + slope x by least squares of relative errors, so that small sizes count as much as large ones."""
    s = [1 / (y * y) for _, y in points]
    sx, sxx = sum(w * x for w, (x, _) in zip(s, points)), sum(w * x * x for w, (x, _) in zip(s, points))
    sy, sxy = sum(w * y for w, (_, y) in zip(s, points)), sum(w * x * y for w, (x, y) in zip(s, points))
    whole = sum(s)
    slope = (whole * sxy - sx * sy) / (whole * sxx - sx * sx)
    return (sy - slope * sx) / whole, slope


def crossing(points, level):
    """Where y comes down to `level` for good, between the measured points on logarithmic axes; (x, True) where even the
    last point is not below, and None where no point reaches it."""
    points = sorted(points)
    above = [k for k, (_, y) in enumerate(points) if y >= level]
    if not above:
        return None
    k = above[-1]
    if k == len(points) - 1:
        return points[k][0], True
    (x0, y0), (x1, y1) = points[k], points[k + 1]
    part = (math.log(y0) - math.log(level)) / (math.log(y0) - math.log(y1))
    return math.exp(math.log(x0) + part * (math.log(x1) - math.log(x0))), False
