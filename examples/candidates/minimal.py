"""The smallest candidate: exact marching tetrahedra in stdlib Python, a template to start from.

As `isosurface.tetrahedra` its answers are meant to be right. As `isosurface.mesh` they are wrong wherever the
six tetrahedra of a cell see another topology than the trilinear interpolant: it is offered under that name
too so that there is something for a judge to refute.
"""
from itertools import permutations, product

from candidate import Unsupported, serve


def tetrahedra(volume):
    """The surface of the six Kuhn tetrahedra of each cell: corner 0 to corner 7, one axis after another."""
    nx, ny, nz = volume.shape
    f = {(i, j, k): volume.values[i + nx * (j + ny * k)] for i, j, k in product(range(nx), range(ny), range(nz))}
    c = volume.isovalue
    if c in volume.values:
        raise Unsupported("tie: no values on the isovalue")
    vertices, faces, seen = [], [], {}

    def crossing(p, q):
        if (p, q) not in seen:
            t = (c - f[p]) / (f[q] - f[p])
            seen[p, q] = len(vertices)
            vertices.append([a + t * (b - a) for a, b in zip(p, q)])
        return seen[p, q]

    for corner in product(range(nx - 1), range(ny - 1), range(nz - 1)):
        for axes in permutations(range(3)):
            tetrahedron = [tuple(corner[a] + (a in axes[:n]) for a in range(3)) for n in range(4)]
            inside = [p for p in tetrahedron if f[p] < c]
            outside = [p for p in tetrahedron if f[p] > c]
            ring = [crossing(p, q) for p in inside for q in outside]
            if len(ring) == 4:  # two and two: the pairs in cyclic order
                ring[2], ring[3] = ring[3], ring[2]
            for a, b in zip(ring[1:], ring[2:]):
                towards = [q - p for p, q in zip(inside[0], outside[0])]
                right = determinant(*([x - y for x, y in zip(vertices[v], vertices[ring[0]])] for v in (a, b)), towards) > 0
                faces.append([ring[0], a, b] if right else [ring[0], b, a])
    return {"vertices": vertices, "faces": faces}


def determinant(u, v, w):
    return sum(u[i] * (v[j] * w[k] - v[k] * w[j]) for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)))


if __name__ == "__main__":
    serve("minimal", "1", {"isosurface.mesh": tetrahedra, "isosurface.tetrahedra": tetrahedra})
