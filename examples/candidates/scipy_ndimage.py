"""scipy.ndimage's cubic splines: spline_filter for coefficients, map_coordinates for values.

Mirror is `mode="mirror"` (whole-sample symmetric), periodic is `mode="grid-wrap"`. scipy.ndimage evaluates no derivatives: these
are sums of its coefficients with B₃′ and B₃″, in numpy. Its arrays have the last axis fastest, ours the first: so shapes
and points are turned round. A signal on all of ℤ is unsupported.
"""
import numpy
import scipy
from scipy.ndimage import map_coordinates, spline_filter, spline_filter1d

from candidate import Fault, Unsupported, nearest_double, number, serve

MODES = {"mirror": "mirror", "periodic": "grid-wrap"}
LETTERS = "xyz"


def doubles(values, field):
    """A list of numbers as their nearest doubles."""
    if not isinstance(values, list):
        raise Fault("invalid-input", f"{field}: a list is wanted")
    return [nearest_double(number(x, f"{field}[{n}]"), f"{field}[{n}]") for n, x in enumerate(values)]


def signal(question):
    """The samples, the last axis fastest, and scipy's mode."""
    shape = question.get("shape")
    if not isinstance(shape, list) or not 1 <= len(shape) <= 3 or not all(type(n) is int and n >= 2 for n in shape):
        raise Fault("invalid-input", "shape: 1 to 3 integers of at least 2 are wanted")
    values = doubles(question.get("values"), "values")
    if len(values) != numpy.prod(shape):
        raise Fault("invalid-input", "values: as many as the shape says are wanted")
    if question.get("boundary") not in MODES:
        raise Fault("invalid-input", "boundary: mirror or periodic is wanted")
    return numpy.array(values).reshape(shape[::-1]), MODES[question["boundary"]]


def filtered(samples, mode):
    """The coefficients, in binary64."""
    if samples.ndim == 1:
        return spline_filter1d(samples, order=3, output=numpy.float64, mode=mode)
    return spline_filter(samples, order=3, output=numpy.float64, mode=mode)


def coefficients(question):
    return {"coefficients": filtered(*signal(question)).ravel()}


def evaluate(question):
    samples, mode = signal(question)
    axes = samples.ndim
    points = question.get("points")
    if not isinstance(points, list):
        raise Fault("invalid-input", "points: a list is wanted")
    points = [doubles(point, f"points[{n}]") for n, point in enumerate(points)]
    if any(len(point) != axes for point in points):
        raise Fault("invalid-input", f"points: {axes} coordinates each are wanted")
    words = question.get("derivatives", [""])
    if not isinstance(words, list):
        raise Fault("invalid-input", "derivatives: a list is wanted")
    orders = [order(word, axes) for word in words]
    if not points:
        return {"values": []}
    c = filtered(samples, mode)
    columns = numpy.array(points).T[::-1]
    value = map_coordinates(c, columns, order=3, mode=mode, prefilter=False)
    return {"values": [[derivative(c, mode, p, n) if any(n) else value[i] for n in orders] for i, p in enumerate(points)]}


def order(word, axes):
    """How often a derivative is taken along each axis."""
    if not isinstance(word, str) or any(letter not in LETTERS[:axes] for letter in word):
        raise Fault("invalid-input", f"derivatives: words of the letters {LETTERS[:axes]} are wanted")
    counts = [word.count(letter) for letter in LETTERS[:axes]]
    if max(counts) > 2:
        raise Fault("invalid-input", "derivatives: a cubic spline is C²")
    return counts


def derivative(c, mode, point, orders):
    """The sum of the coefficients around a point with the derivatives of B₃."""
    for x, n in zip(point, orders):  # x first: it is the last axis of what is left
        floor = int(numpy.floor(x))
        indices = [folded(floor + k, c.shape[-1], mode) for k in (-1, 0, 1, 2)]
        c = c[..., indices] @ numpy.array(weights(x - floor, n))
    return float(c)


def folded(k, n, mode):
    """The index of the sample that stands at k."""
    period = 2 * n - 2 if mode == "mirror" else n
    k %= period
    return min(k, period - k) if mode == "mirror" else k


def weights(t, n):
    """The derivatives of order n of the four B-splines that are not 0 at t in [0, 1)."""
    s = 1 - t
    if n == 0:
        return [s**3 / 6, (3 * t**3 - 6 * t**2 + 4) / 6, (3 * s**3 - 6 * s**2 + 4) / 6, t**3 / 6]
    if n == 1:
        return [-(s**2) / 2, t * (3 * t - 4) / 2, -s * (3 * s - 4) / 2, t**2 / 2]
    return [s, 3 * t - 2, 3 * s - 2, t]


def impulse(question):
    raise Unsupported("scipy.ndimage has finite signals only")


if __name__ == "__main__":
    operations = {"spline.coefficients": coefficients, "spline.evaluate": evaluate, "spline.impulse": impulse}
    serve("scipy.ndimage", scipy.__version__, operations)
