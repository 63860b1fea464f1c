// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveRefinementRepresentation
 * @brief   draws the surface of any data set with a vtkAdaptiveRefinementMapper
 *
 * A representation of ParaView like its Surface: colours, textures, opacity, edges, transforms,
 * blocks and selection are those of vtkGeometryRepresentationWithFaces. The mapper is given by
 * SetMapper(), with the recipe that it draws by; it may be a vtkAdaptiveLICMapper. The view gets
 * the bounds of the refined, displaced surface. Nothing is decimated while the view moves: the
 * mapper draws fewer triangles instead, by the time that the view allows.
 *
 * @sa vtkAdaptiveRefinementMapper vtkAdaptiveLICMapper vtkAdaptiveRefinement
 */
#ifndef vtkAdaptiveRefinementRepresentation_h
#define vtkAdaptiveRefinementRepresentation_h

#include "RelevoParaViewRepresentationsModule.h" // for export macro
#include "vtkGeometryRepresentationWithFaces.h"
#include "vtkNew.h" // for Measure

#include <memory> // for Internals

class vtkAdaptiveRefinementMapper;

class RELEVOPARAVIEWREPRESENTATIONS_EXPORT vtkAdaptiveRefinementRepresentation
  : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkAdaptiveRefinementRepresentation* New();
  vtkTypeMacro(vtkAdaptiveRefinementRepresentation, vtkGeometryRepresentationWithFaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * What draws, a mapper of this representation's own. None (nullptr) is an error and changes
   * nothing. The default is a vtkAdaptiveRefinementMapper without a recipe, which draws the mesh as
   * it is.
   */
  void SetMapper(vtkAdaptiveRefinementMapper* mapper);
  vtkAdaptiveRefinementMapper* GetMapper();
  //@}

  //@{
  /**
   * What colours show: the scalars (0, the default), levels (1), patterns (2) or the metric (3);
   * see vtkAdaptiveRefinementMapper::RefinementColorModes. Another value is an error and changes
   * nothing.
   */
  void SetRefinementColorMode(int mode);
  vtkGetMacro(RefinementColorMode, int);
  //@}

  /**
   * Does nothing: there is no decimated surface.
   */
  void SetSuppressLOD(bool suppress) override;

  /**
   * Names of the arrays of ids that selections are told in; nullptr for ParaView's own.
   */
  void SetArrayIdNames(const char* pointArray, const char* cellArray) override;

  /**
   * Collective over the processes that have the data: each gets the faces around its own, which are
   * not drawn, because levels and curved surfaces at the border depend on them.
   */
  void Update() override;
  using Superclass::Update;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkAdaptiveRefinementRepresentation();
  ~vtkAdaptiveRefinementRepresentation() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkAdaptiveRefinementRepresentation(const vtkAdaptiveRefinementRepresentation&) = delete;
  void operator=(const vtkAdaptiveRefinementRepresentation&) = delete;

  void ApplyColorMode();
  void GiveBounds(vtkInformation* inInfo);
  int RequestRender(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo);
  void AgreeWithProcesses();

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  // Measures what will be drawn, before it is where the mapper draws.
  vtkNew<vtkAdaptiveRefinementMapper> Measure;
  vtkNew<vtkAdaptiveRefinementMapper> Unused; // stands for the mapper where the base sets it
  vtkMTimeType AttributesTime = 0;            // of the data whose blocks' attributes the mapper has
  int RefinementColorMode = 0;
};

#endif
