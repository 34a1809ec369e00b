"""PyMCubes' marching cubes: a classic table, in doubles but for the isovalue, which it takes as a float32."""
from importlib.metadata import version

import mcubes
import numpy

from candidate import serve


def surface(volume):
    f = numpy.array(volume.floats()).reshape(volume.shape, order="F")
    vertices, faces = mcubes.marching_cubes(f, volume.level())
    return {"vertices": vertices, "faces": faces[:, ::-1]}  # its normals point to f < c


if __name__ == "__main__":
    serve("pymcubes", version("PyMCubes"), {"isosurface.mesh": surface})
