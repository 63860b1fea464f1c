// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainReader
 * @brief   opens a height raster of any size for the representation Terrain
 *
 * The output is a small regular mesh of the raster, from its overviews if it has any: at most
 * Resolution points along the longer side. Points are in the map frame of vtkTerrainMapper, in
 * metres from the centre of the raster, with x east and y north. Cells with a point without data
 * are left out. Triangles are counter-clockwise seen from above. The point data are
 *
 * - "Height" (double, the unit of the raster),
 * - "Slope" (float): the angle between the mesh and the horizontal plane, in degrees,
 * - "Aspect" (float): the direction in which the mesh falls, in degrees clockwise from north; NaN
 *   where it is flat.
 *
 * Slopes have Horn's formula, see vtkTerrainMapper, with the distances of the mesh. The
 * representation computes all three for each pixel, from the raster.
 *
 * The field data have "FileName", "CoordinateSystem" (WKT, empty if unknown), "HeightUnit" (such as
 * m, empty if unknown), "Origin" (the centre of the raster in its own coordinates) and "Offset"
 * (the difference of the points from those that are centred, see SetCoordinates()).
 *
 * With several processes, the first one has the mesh, and all have the field data. All processes
 * must update the reader. The default controller is the global one.
 *
 * Errors (ErrorEvent of the first process, empty output): no file name; a file that GDAL cannot
 * read, on one process at least, whose number the message has; a raster with one row or column.
 *
 * @sa vtkTerrainRepresentation vtkTerrainPyramid
 */
#ifndef vtkTerrainReader_h
#define vtkTerrainReader_h

#include "RelevoParaViewFiltersModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for errors

class vtkTerrainPyramid;

class RELEVOPARAVIEWFILTERS_EXPORT vtkTerrainReader : public vtkPolyDataAlgorithm
{
public:
  static vtkTerrainReader* New();
  vtkTypeMacro(vtkTerrainReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the name of the raster: a file, or any other name that GDAL knows. Required.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

  //@{
  /**
   * Set the largest number of points along the longer side of the mesh, from 2 to 4096; default
   * 256. A value out of range is an error and changes nothing.
   */
  void SetResolution(int points);
  vtkGetMacro(Resolution, int);
  //@}

  enum CoordinateTypes
  {
    CENTERED = 0,
    RASTER
  };

  //@{
  /**
   * Set the coordinates of the points. CENTERED (0, the default): metres from the centre of the
   * raster. RASTER (1): the coordinates of the raster's own system, and heights in metres. This
   * needs coordinates in metres. If they are in degrees or feet, there is a warning, and the points
   * are centred. A value out of range is an error and changes nothing.
   */
  void SetCoordinates(int type);
  vtkGetMacro(Coordinates, int);
  //@}

protected:
  vtkTerrainReader();
  ~vtkTerrainReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  char* FileName = nullptr;
  int Resolution = 256;
  int Coordinates = CENTERED;

private:
  vtkTerrainReader(const vtkTerrainReader&) = delete;
  void operator=(const vtkTerrainReader&) = delete;

  std::string Open(vtkTerrainPyramid* pyramid);
  void FindOffset(vtkTerrainPyramid* pyramid, const double center[3], double offset[3]);
};

#endif
