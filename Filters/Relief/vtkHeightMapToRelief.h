// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightMapToRelief
 * @brief   a relief that looks down on a height map
 *
 * The heights are those of SetHeightMap(): a vtkHeightMap, as that of vtkTerrainSource, or another
 * vtkHeightField. Input 0, optional: the imagery, a vtkImageData of n x m x 1 points whose point
 * scalars are colours, stretched over the whole height map, row 0 in the south, as that of
 * vtkTerrainSource::GetImagery(). Colours are as in vtkDepthImageToRelief; a texel's is the mean of
 * what lies in it. Without imagery the relief is grey: white is highest, dark lowest.
 *
 * Output: the relief, a vtkImageData with TexelsPerSample texels along each sample, of parallel
 * projection, with the point arrays "Color", "Depth" (NaN where there are no data) and "Normals",
 * and the field arrays "ReliefProjection" and "ReliefMatrix". Depths count downwards from the
 * highest place, in metres, or in the heights' unit where there is no georeference.
 *
 * Samples lie where vtkTerrainSource puts the heights: in metres, x east, y north, from the
 * raster's centre; without georeference one sample is one unit; z = height x Exaggeration. Texels
 * are the samples themselves, but for longitude and latitude, which are no regular grid on the
 * ground: there texels are a grid along x and y, over all of the raster, with heights in between.
 * None are where the sample that they lie in has no data, and outside of the raster.
 *
 * ProgressEvent reports the share done. AbortExecuteOn(), from an observer, stops it, with an empty
 * output and no error.
 *
 * Errors (ErrorEvent of this object, empty output): no height map, or one that cannot be read,
 * which says why itself, too; a georeference that no terrain can have; imagery that is not n x m x
 * 1, or that has no colours.
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
   * The heights; needed.
   */
  void SetHeightMap(vtkHeightField* heightMap);
  vtkHeightField* GetHeightMap();
  //@}

  //@{
  /**
   * Factor on the heights, default 1. NaN, or more than 1e38 in absolute value, is an error and
   * changes nothing.
   */
  void SetExaggeration(double exaggeration);
  vtkGetMacro(Exaggeration, double);
  //@}

  //@{
  /**
   * Texels along each sample, 1 to 64, default 1. More keep more of imagery that is finer than the
   * heights, which are interpolated.
   */
  void SetTexelsPerSample(int texels);
  vtkGetMacro(TexelsPerSample, int);
  //@}

  //@{
  /**
   * Whether the relief gets normals, computed from its heights; on by default.
   */
  vtkSetMacro(ComputeNormals, bool);
  vtkGetMacro(ComputeNormals, bool);
  vtkBooleanMacro(ComputeNormals, bool);
  //@}

  /// Includes the modification time of the height map.
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
