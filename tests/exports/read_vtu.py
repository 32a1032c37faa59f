# SPDX-License-Identifier: GPL-3.0-or-later
"""Read a series with VTK's own reader: for each time its value and cells, then where each point is displaced to."""
import pathlib
import sys
import xml.etree.ElementTree

from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

series = pathlib.Path(sys.argv[1])
reader = vtkXMLUnstructuredGridReader()
for entry in xml.etree.ElementTree.parse(series).iter("DataSet"):
    reader.SetFileName(str(series.parent / entry.get("file")))
    reader.Update()
    grid = reader.GetOutput()
    moved = grid.GetPointData().GetArray("displacement")
    stress = grid.GetCellData().GetArray("stress")
    print("time", entry.get("timestep"), grid.GetNumberOfCells(), stress.GetNumberOfTuples())
    for i in range(grid.GetNumberOfPoints()):
        print(*(repr(a + b) for a, b in zip(grid.GetPoint(i), moved.GetTuple3(i))))
