"""trimesh's predicates as answers to mesh.check: is_watertight, is_volume, euler_number, volume; and its vertex defects.

What trimesh says nothing of is left out: it has no lists of defects. `is_volume` is meant to be "all the properties
required to represent a valid volume", so that it stands for `manifold`; where the volume is 0 or negative, which is_volume
denies for that reason alone, nothing is said. Polygons are given to it as fans of triangles where that adds new edges
only, so that it changes neither predicate nor number.
"""
from collections import Counter

import numpy
import trimesh

from candidate import Fault, Unsupported, nearest_double, number, serve


def load(question):
    vertices, faces = question.get("vertices"), question.get("faces")
    if not isinstance(vertices, list) or not isinstance(faces, list):
        raise Unsupported("vertices and faces are wanted")
    if question.get("holes"):
        raise Unsupported("holes: trimesh has triangles only")
    if any(len(face) < 3 or len(face) > 3 and len(set(face)) < len(face) for face in faces):
        raise Unsupported("faces: trimesh has triangles only")
    sides = {frozenset(side) for face in faces for side in zip(face, face[1:] + face[:1])}
    diagonals = Counter(frozenset((face[0], face[i])) for face in faces for i in range(2, len(face) - 1))
    if any(diagonal in sides or n > 1 for diagonal, n in diagonals.items()):
        raise Unsupported("faces: a diagonal is an edge already")
    points = [[nearest_double(number(x, f"vertices[{v}]"), f"vertices[{v}]") for x in at] for v, at in enumerate(vertices)]
    triangles = [[face[0], face[i], face[i + 1]] for face in faces for i in range(1, len(face) - 1)]
    if any(not 0 <= v < len(points) for triangle in triangles for v in triangle):
        raise Unsupported("faces: trimesh wants vertices that exist")
    if not triangles:
        raise Unsupported("faces: trimesh wants some")
    return trimesh.Trimesh(numpy.array(points), numpy.array(triangles), process=False, validate=False)


def check(question):
    mesh = load(question)
    counts = {"closed": bool(mesh.is_watertight), "chi": int(mesh.euler_number)}
    if mesh.is_volume or mesh.volume > 0:
        counts["manifold"] = bool(mesh.is_volume)
    if mesh.is_volume:
        counts["volume"] = float(mesh.volume)
    return {"counts": counts}


def deficits(question):
    mesh = load(question)
    if not mesh.is_watertight:
        raise Unsupported("faces: on a border it has the whole turn less the angles, not the half turn")
    defects = mesh.vertex_defects
    if not numpy.isfinite(defects).all():
        raise Fault("degenerate", "a triangle without area")
    return {"chi": int(mesh.euler_number), "deficits": defects}


if __name__ == "__main__":
    serve("trimesh", trimesh.__version__, {"mesh.check": check, "mesh.angle_deficits": deficits})
