// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptivePatchMapper
 * @brief   draws curved cells as they are: their surface refined, their fields exact at every pixel
 *
 * A vtkAdaptiveRefinementMapper of a vtkUnstructuredGrid, or of the triangles that
 * vtkPatchSurfaceFilter makes of one, each a part of a Bézier patch. Scalars of points are
 * evaluated at every pixel by the cell's own basis, whatever the refinement, and then coloured as
 * VTK does: by the lookup table, its vector component or magnitude, or as the colours that they
 * are; with InterpolateScalarsBeforeMapping or without. This holds for all methods and
 * representations.
 *
 * The recipe is by default one of a vtkPatchSurface, vtkPatchErrorDepthTagMetric (half a pixel),
 * LevelRule PER_EDGE, SegmentPolicy WHOLE_NUMBERS and MaximumLevel 7. With another surface, for
 * scalars that the input has no coefficients of ("PatchNodes:NAME" in its field data), for those
 * of cells and of fields, categories (vtkScalarsToColors::IndexedLookup), names and bits, colours
 * are as of vtkAdaptiveRefinementMapper, and there are no isolines. Where a patch has no data
 * (NaN; of vectors also NoDataMagnitude of the recipe) at one of its nodes, it has none anywhere.
 * Blocks of a composite data set are drawn likewise, each with its own coefficients; colours of
 * blocks replace those of scalars.
 *
 * Errors, beside those of vtkAdaptiveRefinementMapper: coefficients of another size than the
 * control points have, or that do not fit on the graphics card. The surface is then drawn as
 * without them.
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
   * Whether scalars are evaluated at every pixel, on by default; off, they are interpolated between
   * the corners of the coarse triangles, as vtkAdaptiveRefinementMapper does.
   */
  void SetExactScalars(bool exact);
  vtkGetMacro(ExactScalars, bool);
  vtkBooleanMacro(ExactScalars, bool);
  //@}

  //@{
  /**
   * Isolines of the number that colours are looked up by: at all multiples of the spacing, in the
   * data's own units; 0, the default, for none. They are those of the exact field: without
   * ExactScalars there are none, nor of direct colours, nor in wireframes or points. They are as
   * wide on the screen everywhere: IsolineWidth in pixels, default 1. Both are at least 0 and no
   * more than a float holds. Lines are not lit.
   */
  void SetIsolineSpacing(double spacing);
  vtkGetMacro(IsolineSpacing, double);
  void SetIsolineWidth(double pixels);
  vtkGetMacro(IsolineWidth, double);
  //@}

  //@{
  /**
   * The isolines' colour: red, green, blue, each in [0, 1]; black by default.
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
   * Whether the edges of cells are drawn, and no others; off by default. They have the property's
   * LineWidth, in pixels, and EdgeColor, whatever the refinement; each of two neighbours draws its
   * half. Edges that are one point are not drawn, nor any in wireframes or points, nor what cuts a
   * polygon into triangles.
   */
  void SetPatchEdges(bool edges);
  vtkGetMacro(PatchEdges, bool);
  vtkBooleanMacro(PatchEdges, bool);
  //@}

  //@{
  /**
   * The grid to draw, or the triangles that vtkPatchSurfaceFilter has made of one. Of a grid the
   * mapper makes them itself, when the grid has changed; its errors are the mapper's. A grid's
   * blocks are not taken: give those to the filter.
   */
  void SetInputData(vtkUnstructuredGrid* grid);
  void SetInputData(vtkPolyData* patches);
  //@}

  //@{
  /**
   * Where on the grid a pick is: returns the grid's cell ("vtkOriginalCellIds"), and the place's
   * parametric coordinates in it; of a solid cell u and v of its face's patch. The third one is 0.
   * -1, and nothing is set, where nothing of a patch has been picked.
   *
   * The first is for vtkCellPicker after Pick(), and exact for the refined surface. The second is
   * for what else finds a cell of the input, as vtkHardwareSelector, and a position near it, in the
   * input's own coordinates: it finds the nearest point of the cell's patch. `patches` is the block
   * of a composite input, nullptr where there are no blocks.
   */
  vtkIdType GetPickedCell(vtkCellPicker* picker, double pcoords[3]);
  vtkIdType GetPickedCell(
    vtkIdType cellId, const double position[3], double pcoords[3], vtkPolyData* patches = nullptr);
  //@}

  /// With the coefficients of the scalars.
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
  /// The scalars of points that VTK colours by; nullptr for none.
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
