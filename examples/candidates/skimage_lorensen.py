"""scikit-image's marching cubes after Lorensen and Cline: the classic table."""
import skimage

from candidate import serve
from skimage_lewiner import surface

if __name__ == "__main__":
    serve("skimage-lorensen", skimage.__version__, {"isosurface.mesh": lambda volume: surface(volume, "lorensen")})
