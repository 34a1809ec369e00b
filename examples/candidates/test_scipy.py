"""The adapter of scipy.ndimage against equations that are solved here exactly; skipped where scipy is missing."""
import importlib.util
import unittest
from fractions import Fraction
from itertools import product

from test_candidate import ask

COMMAND = ["scipy_ndimage.py"]
NEAR = 1e-11  # relative to the largest coefficient


def solve(matrix, right):
    """The solution of a square system, by elimination."""
    rows = [list(map(Fraction, row)) + [Fraction(b)] for row, b in zip(matrix, right)]
    n = len(rows)
    for i in range(n):
        pivot = next(j for j in range(i, n) if rows[j][i])
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [x / rows[i][i] for x in rows[i]]
        for j in range(n):
            if j != i:
                rows[j] = [x - rows[j][i] * y for x, y in zip(rows[j], rows[i])]
    return [row[n] for row in rows]


def index(k, n, boundary):
    period = 2 * n - 2 if boundary == "mirror" else n
    k %= period
    return k if k < n else period - k


def b3(x):
    """The cubic B-spline."""
    x = abs(x)
    if x < 1:
        return Fraction(2, 3) - x**2 + x**3 / 2
    return (2 - x) ** 3 / 6 if x < 2 else Fraction(0)


def interpolation(values, shape, boundary):
    """The coefficients, from the system Σ c[k] B₃(i − k) = g[i] in all dimensions at once."""
    places = [tuple(reversed(place)) for place in product(*(range(n) for n in reversed(shape)))]
    number = {place: i for i, place in enumerate(places)}
    matrix = []
    for place in places:
        row = [Fraction(0)] * len(places)
        for offset in product((-1, 0, 1), repeat=len(shape)):
            at = tuple(index(i + o, n, boundary) for i, o, n in zip(place, offset, shape))
            weight = Fraction(1)
            for o in offset:
                weight *= b3(Fraction(o))
            row[number[at]] += weight
        matrix.append(row)
    return solve(matrix, values)


def value(c, shape, boundary, point):
    total = Fraction(0)
    for offset in product((-1, 0, 1, 2), repeat=len(shape)):
        weight, place, stride = Fraction(1), 0, 1
        for x, o, n in zip(point, offset, shape):
            k = x.__floor__() + o
            weight *= b3(x - k)
            place += stride * index(k, n, boundary)
            stride *= n
        total += weight * c[place]
    return total


@unittest.skipUnless(importlib.util.find_spec("scipy"), "scipy is not installed")
class Splines(unittest.TestCase):
    SHAPES = [[2], [5], [6], [2, 3], [3, 4], [2, 3, 2]]

    def signals(self):
        for shape, boundary in product(self.SHAPES, ("mirror", "periodic")):
            count = 1
            for n in shape:
                count *= n
            values = [(7 * i * i + 3 * i) % 11 - 5 for i in range(count)]
            yield shape, boundary, values, interpolation(values, shape, boundary)

    def test_coefficients_solve_the_interpolation_problem(self):
        signals = list(self.signals())
        answers = ask(COMMAND, *({"id": 1, "op": "spline.coefficients", "in": {"shape": shape, "values": values, "boundary": boundary}}
                                 for shape, boundary, values, _ in signals))
        for (shape, boundary, _, c), answer in zip(signals, answers, strict=True):
            with self.subTest(shape=shape, boundary=boundary):
                for found, true in zip(answer["out"]["coefficients"], c, strict=True):
                    self.assertLess(abs(found - true), NEAR * max(map(abs, c)))

    def test_values_and_derivatives_are_those_of_the_spline(self):
        step = Fraction(1, 10**4)
        signals = list(self.signals())

        def points_in(shape):
            return [[Fraction(3 * i + 1, 8) - 1 + axis for axis in range(len(shape))] for i in range(6)]

        def question(shape, boundary, values):
            points = [[str(x) for x in point] for point in points_in(shape)]
            return {"shape": shape, "values": values, "boundary": boundary, "derivatives": ["", "x", "xx"], "points": points}

        answers = ask(COMMAND, *({"id": 1, "op": "spline.evaluate", "in": question(*signal)} for *signal, _ in signals))
        for (shape, boundary, _, c), answer in zip(signals, answers, strict=True):
            points = points_in(shape)
            for point, (f, fx, fxx) in zip(points, answer["out"]["values"], strict=True):
                with self.subTest(shape=shape, boundary=boundary, point=point):
                    scale = max(map(abs, c))
                    left, here, right = (value(c, shape, boundary, [point[0] + h, *point[1:]]) for h in (-step, 0, step))
                    self.assertLess(abs(f - here), NEAR * scale)
                    # Differences of a piecewise cubic: off by the order of h², and of h across a knot.
                    self.assertLess(abs(fx - (right - left) / (2 * step)), 1e-7 * scale)
                    self.assertLess(abs(fxx - (right - 2 * here + left) / step**2), 1e-3 * scale)

    def test_what_it_has_nothing_for_is_unsupported_and_broken_questions_are_named(self):
        good = {"shape": [4], "values": [1, 2, 3, 4], "boundary": "mirror", "points": [["1/2"]]}
        broken = [{"shape": [5]}, {"shape": [1, 4]}, {"boundary": "clamped"}, {"values": [1, 2, "NaN", 4]}, {"points": [["1/2", "0"]]},
                  {"derivatives": ["xxx"]}, {"derivatives": ["y"]}, {"points": 7}]
        questions = [{"id": n, "op": "spline.evaluate", "in": {**good, **part}} for n, part in enumerate(broken)]
        impulse = {"id": "z", "op": "spline.impulse", "in": {"samples": {"0": "1"}, "k_from": 0, "k_to": 1, "points": []}}
        *answers, last = ask(COMMAND, *questions, impulse)
        for part, answer in zip(broken, answers):
            with self.subTest(part):
                self.assertEqual(answer["error"]["kind"], "invalid-input")
                # Whether the shape is wrong or the number of values is a matter of taste.
                self.assertTrue(answer["error"]["message"].startswith((next(iter(part)), "values")))
        self.assertIn("unsupported", last)


if __name__ == "__main__":
    unittest.main()
