"""Position and orientation of every adapter's mesh; an adapter whose library is missing is skipped."""
import importlib.util
import unittest
from fractions import Fraction
from itertools import product

from test_candidate import mesh

ADAPTERS = [
    (["minimal.py"], None),
    (["skimage_lewiner.py"], "skimage"),
    (["skimage_lorensen.py"], "skimage"),
    (["pymcubes.py"], "mcubes"),
    (["libigl_mc.py"], "igl"),
    (["vtk_mc.py"], "vtkmodules"),
    (["vtk_mc.py", "flying-edges"], "vtkmodules"),
]
FLOAT32 = Fraction(1, 10**6)  # relative: several of the libraries work or answer in float32


def sampled(f, shape):
    nx, ny, nz = shape
    return {"shape": shape, "values": [f(i, j, k) for k, j, i in product(range(nz), range(ny), range(nx))]}


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def dot(u, v):
    return sum(a * b for a, b in zip(u, v))


def sphere(i, j, k):
    return (3 * i - 9) ** 2 + (3 * j - 10) ** 2 + (3 * k - 8) ** 2


class Adapters(unittest.TestCase):
    def each(self, volume, isovalue, check):
        """check(vertices, faces) for each adapter that can run here."""
        for command, library in ADAPTERS:
            with self.subTest(" ".join(command)):
                if library and importlib.util.find_spec(library) is None:
                    self.skipTest(f"{library} is not installed")
                check(*mesh(command, volume, isovalue))

    def test_a_plane_is_met_and_faces_up_the_slope(self):
        slope, level = [1, 2, 4], Fraction(31, 3)

        def check(vertices, faces):
            self.assertTrue(faces)
            for vertex in vertices:
                self.assertLess(abs(dot(vertex, slope) - level), level * FLOAT32)
            for a, b, c in ([vertices[v] for v in face] for face in faces):
                normal = cross([x - y for x, y in zip(b, a)], [x - y for x, y in zip(c, a)])
                self.assertGreater(dot(normal, slope), 0)

        self.each(sampled(lambda *p: dot(p, slope), [3, 4, 5]), "31/3", check)

    def test_a_sphere_is_closed_and_faces_f_above_the_isovalue(self):
        for sign in (1, -1):

            def check(vertices, faces):
                edges = {(face[n], face[(n + 1) % 3]) for face in faces for n in range(3)}
                self.assertEqual(edges, {(b, a) for a, b in edges})
                six_volumes = sum(dot(vertices[a], cross(vertices[b], vertices[c])) for a, b, c in faces)
                self.assertGreater(sign * six_volumes, 0)

            self.each(sampled(lambda *p: sign * sphere(*p), [7, 7, 7]), f"{sign * 241}/4", check)

    def test_no_surface_is_an_empty_mesh(self):
        for level in (-1, 100):
            self.each(sampled(lambda i, j, k: i + j + k, [3, 3, 3]), level, lambda *mesh: self.assertEqual(mesh, ([], [])))


if __name__ == "__main__":
    unittest.main()
