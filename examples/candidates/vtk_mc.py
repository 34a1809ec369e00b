"""VTK's vtkMarchingCubes, or with the argument `flying-edges` its vtkFlyingEdges3D."""
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkMarchingCubes

from candidate import serve


def surface(volume, algorithm):
    image = vtkImageData()
    image.SetDimensions(volume.shape)
    image.GetPointData().SetScalars(numpy_to_vtk(numpy.array(volume.floats()), deep=True))
    contour = algorithm()
    contour.SetInputData(image)
    contour.SetValue(0, volume.level())
    contour.Update()
    mesh = contour.GetOutput()
    if mesh.GetNumberOfPoints() == 0:
        return {"vertices": [], "faces": []}
    vertices = vtk_to_numpy(mesh.GetPoints().GetData())
    faces = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return {"vertices": vertices, "faces": faces[:, ::-1]}  # its normals point to f < c


if __name__ == "__main__":
    algorithm = vtkFlyingEdges3D if sys.argv[1:] == ["flying-edges"] else vtkMarchingCubes
    serve(algorithm.__name__, vtkVersion.GetVTKVersion(), {"isosurface.mesh": lambda volume: surface(volume, algorithm)})
