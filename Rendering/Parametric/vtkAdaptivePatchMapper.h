// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptivePatchMapper
 * @brief   draws curved cells with a refined surface and fields evaluated at every pixel
 *
 * This vtkAdaptiveRefinementMapper draws a vtkUnstructuredGrid, or the triangles that
 * vtkPatchSurfaceFilter generates from one. Each triangle is a part of a Bézier patch. Point
 * scalars are evaluated at every pixel with the cell's own basis, independently of the refinement,
 * and then coloured like in VTK: by the lookup table with a vector component or the magnitude, or
 * as direct colours; with InterpolateScalarsBeforeMapping or without. This applies to all methods
 * and representations.
 *
 * The default recipe has a vtkPatchSurface, vtkPatchErrorDepthTagMetric (half a pixel), LevelRule
 * PER_EDGE, SegmentPolicy WHOLE_NUMBERS and MaximumLevel 7. Colours are those of
 * vtkAdaptiveRefinementMapper, without isolines, in these cases: another surface; scalars without
 * coefficients in the input ("PatchNodes:NAME" in the field data); cell and field scalars;
 * categories (vtkScalarsToColors::IndexedLookup), strings and bits. If one node of a patch has no
 * data (NaN, or for vectors NoDataMagnitude of the recipe), the whole patch has none. Blocks of a
 * composite data set are drawn the same, each with its coefficients; colours of blocks replace
 * those of scalars.
 *
 * In addition to the errors of vtkAdaptiveRefinementMapper, these are errors: coefficients whose
 * number differs from that of the control points, and coefficients that do not fit on the GPU. The
 * surface is then drawn as if there were no coefficients.
 *
 * @sa vtkPatchSurfaceFilter vtkPatchSurface vtkAdaptiveRefinementMapper
 */
#ifndef vtkAdaptivePatchMapper_h
#define vtkAdaptivePatchMapper_h

#include "RelevoRenderingParametricModule.h" // for export macro
#include "vtkAdaptiveRefinementMapper.h"

#include <memory> // for vtkInternals

class vtkCellPicker;
class vtkDataArray;
class vtkUnstructuredGrid;

class RELEVORENDERINGPARAMETRIC_EXPORT vtkAdaptivePatchMapper : public vtkAdaptiveRefinementMapper
{
public:
  static vtkAdaptivePatchMapper* New();
  vtkTypeMacro(vtkAdaptivePatchMapper, vtkAdaptiveRefinementMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set whether scalars are evaluated at every pixel. On by default. Off, they are interpolated
   * between the corners of the coarse triangles, as by vtkAdaptiveRefinementMapper.
   */
  void SetExactScalars(bool exact);
  vtkGetMacro(ExactScalars, bool);
  vtkBooleanMacro(ExactScalars, bool);
  //@}

  //@{
  /**
   * Set the spacing of isolines, in units of the data, and their width, in pixels. Isolines are
   * drawn at all multiples of the spacing, of the value that the lookup table maps. The default
   * spacing, 0, draws none. The default width is 1 and is constant on the screen. Isolines are
   * those of the exact field: there are none without ExactScalars, for direct colours, in
   * wireframes or in points. Isolines are not lit. Both values are at least 0 and finite as a
   * float; a value out of range is an error and changes nothing.
   */
  void SetIsolineSpacing(double spacing);
  vtkGetMacro(IsolineSpacing, double);
  void SetIsolineWidth(double pixels);
  vtkGetMacro(IsolineWidth, double);
  //@}

  //@{
  /**
   * Set the colour of isolines: red, green and blue, each in [0, 1]. The default is black. A value
   * out of range is an error and changes nothing.
   */
  void SetIsolineColor(double red, double green, double blue);
  void SetIsolineColor(const double color[3])
  {
    this->SetIsolineColor(color[0], color[1], color[2]);
  }
  vtkGetVector3Macro(IsolineColor, double);
  //@}

  //@{
  /**
   * Set whether the edges of cells are drawn. Off by default. They have the property's LineWidth,
   * in pixels, and EdgeColor, independently of the refinement. Each of two neighbours draws its
   * half. Degenerate edges and the edges that split polygons into triangles are not drawn.
   * Wireframes and points show no edges of cells.
   */
  void SetPatchEdges(bool edges);
  vtkGetMacro(PatchEdges, bool);
  vtkBooleanMacro(PatchEdges, bool);
  //@}

  //@{
  /**
   * Set the grid, or the triangles that vtkPatchSurfaceFilter has generated from one. The mapper
   * itself generates the triangles of a grid when the grid has changed, and reports the filter's
   * errors. A composite data set of grids is not supported: use the filter.
   */
  void SetInputData(vtkUnstructuredGrid* grid);
  void SetInputData(vtkPolyData* patches);
  //@}

  //@{
  /**
   * Return the grid's cell at a pick ("vtkOriginalCellIds"), and the parametric coordinates in it.
   * For a 3D cell, the coordinates are u and v of its face's patch. The third coordinate is 0. If
   * no patch was picked, -1 is returned and pcoords is unchanged.
   *
   * The first method works with vtkCellPicker after Pick() and is exact for the refined surface.
   * The second method works with other selections of a cell of the input, such as
   * vtkHardwareSelector, and a position near it in the input's coordinates. It finds the nearest
   * point of the cell's patch. `patches` is the block of a composite input, or nullptr for an input
   * without blocks.
   */
  vtkIdType GetPickedCell(vtkCellPicker* picker, double pcoords[3]);
  vtkIdType GetPickedCell(
    vtkIdType cellId, const double position[3], double pcoords[3], vtkPolyData* patches = nullptr);
  //@}

  /// Return the number of bytes on the GPU, including the coefficients of the scalars.
  vtkTypeInt64 GetGraphicsMemorySize() override;

  void RenderPieceStart(vtkRenderer* ren, vtkActor* act) override;
  void RenderPieceFinish(vtkRenderer* ren, vtkActor* act) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void ShallowCopy(vtkAbstractMapper* mapper) override;

protected:
  vtkAdaptivePatchMapper();
  ~vtkAdaptivePatchMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkDataObject* ConvertInput(vtkDataObject* input) override;
  void UpdateBlocks() override;
  void ExtendShaders(const vtkOpenGLHelper* cellBO, relevo::ShaderExtension& extension) override;
  void ReplaceShaderValues(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act) override;
  void SetMapperShaderParameters(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act) override;

private:
  vtkAdaptivePatchMapper(const vtkAdaptivePatchMapper&) = delete;
  void operator=(const vtkAdaptivePatchMapper&) = delete;

  void CopyPatchSettings(vtkAdaptivePatchMapper* other);
  void UpdateField(vtkRenderer* ren);
  void UploadField(vtkRenderer* ren);
  /// Return the point scalars that VTK maps to colours; nullptr for none.
  vtkDataArray* FindMappedScalars();
  void ReportMissingIsolines();

  struct vtkInternals;
  bool ExactScalars = true;
  double IsolineSpacing = 0.0;
  double IsolineWidth = 1.0;
  double IsolineColor[3] = { 0.0, 0.0, 0.0 };
  bool PatchEdges = false;
  std::unique_ptr<vtkInternals> Patches;
};

#endif
