// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainReliefSource
 * @brief   makes a relief of a height raster and its imagery, which are read from files
 *
 * The raster and the imagery are read by vtkTerrainSource and converted by vtkHeightMapToRelief,
 * which describe the coordinates and the output. The source reports their errors (ErrorEvent) and
 * then produces an empty output.
 *
 * @sa vtkHeightMapToRelief vtkTerrainSource
 */
#ifndef vtkTerrainReliefSource_h
#define vtkTerrainReliefSource_h

#include "RelevoParaViewFiltersModule.h" // for export macro
#include "vtkImageAlgorithm.h"
#include "vtkNew.h" // for members

#include <string> // for errors

class vtkHeightMapToRelief;
class vtkTerrainSource;

class RELEVOPARAVIEWFILTERS_EXPORT vtkTerrainReliefSource : public vtkImageAlgorithm
{
public:
  static vtkTerrainReliefSource* New();
  vtkTypeMacro(vtkTerrainReliefSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the file of the heights. Required.
   */
  void SetFileName(VTK_FILEPATH const char* name);
  VTK_FILEPATH const char* GetFileName();
  //@}

  //@{
  /**
   * Set the file of the imagery. Without one (the default), the relief is grey.
   */
  void SetImageryFileName(VTK_FILEPATH const char* name);
  VTK_FILEPATH const char* GetImageryFileName();
  //@}

  //@{
  /**
   * Set the bands of the imagery, see vtkTerrainSource::SetImageryBands().
   */
  void SetImageryBands(int red, int green, int blue);
  int* GetImageryBands() VTK_SIZEHINT(3);
  //@}

  //@{
  /**
   * Set the factor for heights, see vtkHeightMapToRelief::SetExaggeration().
   */
  void SetExaggeration(double exaggeration);
  double GetExaggeration();
  //@}

  //@{
  /**
   * Set the number of texels per sample, see vtkHeightMapToRelief::SetTexelsPerSample().
   */
  void SetTexelsPerSample(int texels);
  int GetTexelsPerSample();
  //@}

  //@{
  /**
   * Set the maximum number of heights per side, default 2048, 0 for no limit. Larger rasters are
   * reduced with a warning. A negative number is an error and changes nothing.
   */
  void SetMaximumDimension(int dimension);
  int GetMaximumDimension();
  //@}

  /// Include the modification times of the settings.
  vtkMTimeType GetMTime() override;

protected:
  vtkTerrainReliefSource();
  ~vtkTerrainReliefSource() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkTerrainReliefSource(const vtkTerrainReliefSource&) = delete;
  void operator=(const vtkTerrainReliefSource&) = delete;

  /// Update the relief. Return whether there was no error, which is reported.
  bool Convert();
  void ForwardWarning(vtkObject* object, unsigned long event, void* text);

  vtkNew<vtkTerrainSource> Terrain;
  vtkNew<vtkHeightMapToRelief> Converter;
  std::string Error; // the last one that was reported
};

#endif
