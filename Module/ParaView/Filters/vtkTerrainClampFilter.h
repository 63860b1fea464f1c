// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainClampFilter
 * @brief   lays points, lines and polygons on the raster of a vtkTerrainReader
 *
 * Input 0 is a vtkPolyData. Input 1 is the output of a vtkTerrainReader, whose raster gives the
 * heights at full resolution. The output is that of a vtkTerrainClamp, in the coordinates of the
 * reader. Each rank processes its piece.
 *
 * Errors (ErrorEvent, empty output): input 1 is not the output of a vtkTerrainReader; the errors of
 * vtkTerrainClamp.
 *
 * @sa vtkTerrainClamp vtkTerrainReader
 */
#ifndef vtkTerrainClampFilter_h
#define vtkTerrainClampFilter_h

#include "RelevoParaViewFiltersModule.h" // for export macro
#include "vtkNew.h"                      // for members
#include "vtkPolyDataAlgorithm.h"

class vtkTerrainClamp;
class vtkTerrainPyramid;

class RELEVOPARAVIEWFILTERS_EXPORT vtkTerrainClampFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkTerrainClampFilter* New();
  vtkTypeMacro(vtkTerrainClampFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the coordinates of input 0: see vtkTerrainClamp::SetCoordinateType(). WORLD (0, the
   * default) are those of the vtkTerrainReader.
   */
  void SetCoordinateType(int type);
  int GetCoordinateType();
  //@}

  //@{
  /**
   * Set the distance by which the output is lifted, in world units; default 0. See
   * vtkTerrainClamp::SetOffset().
   */
  void SetOffset(double distance);
  double GetOffset();
  //@}

  //@{
  /**
   * Set the factor on the heights; default 1. See vtkTerrainClamp::SetExaggeration().
   */
  void SetExaggeration(double factor);
  double GetExaggeration();
  //@}

  /// Includes the settings.
  vtkMTimeType GetMTime() override;

protected:
  vtkTerrainClampFilter();
  ~vtkTerrainClampFilter() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkTerrainClampFilter(const vtkTerrainClampFilter&) = delete;
  void operator=(const vtkTerrainClampFilter&) = delete;

  void Report(vtkObject* caller, unsigned long event, void* text);

  vtkNew<vtkTerrainClamp> Clamp;
  vtkNew<vtkTerrainPyramid> Pyramid;
};

#endif
