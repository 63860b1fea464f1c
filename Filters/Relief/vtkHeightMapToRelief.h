// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightMapToRelief
 * @brief   convert a height map to a relief, seen from above
 *
 * The heights are those of SetHeightMap(): a vtkHeightMap, such as that of a vtkTerrainSource, or
 * another vtkHeightField. Input 0, optional, is the imagery: a vtkImageData of n x m x 1 points
 * with colours as point scalars, such as vtkTerrainSource::GetImagery(). It is stretched over the
 * whole height map with row 0 in the south. For types of colours, see vtkDepthImageToRelief. The
 * colour of a texel is the mean over its area. Without imagery the relief is grey: white is
 * highest, dark is lowest.
 *
 * The output is the relief, a vtkImageData with TexelsPerSample texels per sample in each
 * direction. It has a parallel projection, the point arrays "Color", "Depth" (NaN where data is
 * missing) and "Normals", and the field arrays "ReliefProjection" and "ReliefMatrix". Depths are
 * relative to the highest point and increase downwards, in metres, or in the unit of the heights
 * without georeference.
 *
 * Samples have the positions of vtkTerrainSource: in metres, x east, y north, relative to the
 * centre of the raster, or one unit per sample without georeference; z = height * Exaggeration.
 * With TexelsPerSample 1, each sample is a texel, except for longitude and latitude, where samples
 * are not on a regular grid of the ground. There, heights are interpolated on a regular grid in x
 * and y that covers the whole raster. A texel without data in its sample, or outside of the raster,
 * has no surface.
 *
 * ProgressEvent reports the progress. An observer can call AbortExecuteOn() to stop, with an empty
 * output and no error.
 *
 * The filter reports an error (ErrorEvent) and produces an empty output if there is no height map;
 * the height map cannot be read, which it also reports itself; the georeference is not supported,
 * see vtkTerrainSource; or the imagery is not n x m x 1 or has no colours.
 *
 * @sa vtkDepthImageToRelief vtkTerrainSource vtkHeightMap
 */
#ifndef vtkHeightMapToRelief_h
#define vtkHeightMapToRelief_h

#include "RelevoFiltersReliefModule.h" // for export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // for the height map

#include <string> // for errors

class vtkHeightField;

class RELEVOFILTERSRELIEF_EXPORT vtkHeightMapToRelief : public vtkImageAlgorithm
{
public:
  static vtkHeightMapToRelief* New();
  vtkTypeMacro(vtkHeightMapToRelief, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the heights. Required.
   */
  void SetHeightMap(vtkHeightField* heightMap);
  vtkHeightField* GetHeightMap();
  //@}

  //@{
  /**
   * Set the factor for heights, default 1. NaN, or more than 1e38 in absolute value, is an error
   * and changes nothing.
   */
  void SetExaggeration(double exaggeration);
  vtkGetMacro(Exaggeration, double);
  //@}

  //@{
  /**
   * Set the number of texels per sample in each direction, 1 to 64, default 1. A larger number
   * preserves more detail of imagery that is finer than the heights, which are interpolated.
   */
  void SetTexelsPerSample(int texels);
  vtkGetMacro(TexelsPerSample, int);
  //@}

  //@{
  /**
   * Set whether normals are computed from the heights; on by default.
   */
  vtkSetMacro(ComputeNormals, bool);
  vtkGetMacro(ComputeNormals, bool);
  vtkBooleanMacro(ComputeNormals, bool);
  //@}

  /// Include the modification time of the height map.
  vtkMTimeType GetMTime() override;

protected:
  vtkHeightMapToRelief();
  ~vtkHeightMapToRelief() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHeightMapToRelief(const vtkHeightMapToRelief&) = delete;
  void operator=(const vtkHeightMapToRelief&) = delete;

  std::string ReadHeights();
  std::string Build(vtkImageData* imagery, vtkImageData* output);

  vtkSmartPointer<vtkHeightField> HeightMap;
  double Exaggeration = 1.0;
  int TexelsPerSample = 1;
  bool ComputeNormals = true;
};

#endif
