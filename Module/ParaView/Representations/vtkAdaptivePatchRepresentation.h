// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptivePatchRepresentation
 * @brief   draws the surface of curved cells with a vtkAdaptivePatchMapper
 *
 * The surface of unstructured grids is that of vtkPatchSurfaceFilter: quadratic, Lagrange and
 * Bézier cells are curved, and other cells are patches of degree 1. Faces of other data sets are
 * linear. Composite data sets have one surface per block. Faces whose corners coincide with those
 * of another face are inside the mesh and are not drawn, also if the cells are on different
 * processes.
 *
 * Colours, opacity, transforms, blocks and selection are those of
 * vtkAdaptiveRefinementRepresentation.
 *
 * @sa vtkAdaptivePatchMapper vtkPatchSurfaceFilter
 */
#ifndef vtkAdaptivePatchRepresentation_h
#define vtkAdaptivePatchRepresentation_h

#include "RelevoParaViewRepresentationsModule.h" // for export macro
#include "vtkAdaptiveRefinementRepresentation.h"

#include <memory> // for PatchData

class vtkAdaptivePatchMapper;

class RELEVOPARAVIEWREPRESENTATIONS_EXPORT vtkAdaptivePatchRepresentation
  : public vtkAdaptiveRefinementRepresentation
{
public:
  static vtkAdaptivePatchRepresentation* New();
  vtkTypeMacro(vtkAdaptivePatchRepresentation, vtkAdaptiveRefinementRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the largest distance on the screen between the drawn surface and the exact one, in pixels:
   * more than 0, default 0.5. A value out of range is an error and changes nothing.
   */
  void SetScreenSpaceError(double pixels);
  vtkGetMacro(ScreenSpaceError, double);
  //@}

  /// Set the mapper, which must be a vtkAdaptivePatchMapper. Another class is an error.
  void SetMapper(vtkAdaptivePatchMapper* mapper);

  void Update() override;
  using Superclass::Update;

protected:
  vtkAdaptivePatchRepresentation();
  ~vtkAdaptivePatchRepresentation() override;

  vtkDataObject* ConvertPieces(vtkDataObject* pieces) override;

private:
  vtkAdaptivePatchRepresentation(const vtkAdaptivePatchRepresentation&) = delete;
  void operator=(const vtkAdaptivePatchRepresentation&) = delete;

  struct vtkPatchData;
  std::unique_ptr<vtkPatchData> PatchData;
  double ScreenSpaceError = 0.5;
};

#endif
