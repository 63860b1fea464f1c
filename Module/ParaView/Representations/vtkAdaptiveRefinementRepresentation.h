// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveRefinementRepresentation
 * @brief   draws the surface of a data set with a vtkAdaptiveRefinementMapper
 *
 * This representation works like ParaView's Surface: colours, textures, opacity, edges, transforms,
 * blocks and selection are those of vtkGeometryRepresentationWithFaces. SetMapper() sets the
 * mapper, which has the recipe and may be a vtkAdaptiveLICMapper. The view gets the bounds of the
 * refined, displaced surface. There is no decimation while the view moves: the mapper draws fewer
 * triangles instead, within the time that the view allots.
 *
 * Messages of the mapper are reported by this class, in ParaView's words.
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
   * Set the mapper that draws. It must not be shared with other representations. nullptr is an
   * error and changes nothing. The default is a vtkAdaptiveRefinementMapper without a recipe, which
   * draws the mesh unrefined.
   */
  void SetMapper(vtkAdaptiveRefinementMapper* mapper);
  vtkAdaptiveRefinementMapper* GetMapper();
  //@}

  //@{
  /**
   * Set the method of the mapper (0 to 5, default 0). The methods of Adaptive Volume, 100 and 101,
   * stand for 0, because both representations share the property. Another value is an error and
   * changes nothing.
   */
  void SetMethod(int method);
  vtkGetMacro(Method, int);
  //@}

  //@{
  /**
   * Set the values that colours show: the scalars (0, the default), levels (1), patterns (2) or the
   * metric (3); see vtkAdaptiveRefinementMapper::RefinementColorModes. A value out of range is an
   * error and changes nothing.
   */
  void SetRefinementColorMode(int mode);
  vtkGetMacro(RefinementColorMode, int);
  //@}

  /**
   * Does nothing, because there is no decimated surface.
   */
  void SetSuppressLOD(bool suppress) override;

  /**
   * Set the names of the id arrays that selections refer to; nullptr for ParaView's own.
   */
  void SetArrayIdNames(const char* pointArray, const char* cellArray) override;

  /**
   * Update the data, collectively over the processes that have them. Each process gets the faces
   * around its own as ghost faces, which are not drawn, because levels and curved surfaces at the
   * border depend on them.
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

  /// Make the mapper's input from the pieces that this process draws. The default is the pieces
  /// themselves.
  virtual vtkDataObject* ConvertPieces(vtkDataObject* pieces);

  /// Use faces of unstructured grids as relevo::CurvedFaceGeometry makes them, and their bounds.
  void UseCurvedFaces();

private:
  vtkAdaptiveRefinementRepresentation(const vtkAdaptiveRefinementRepresentation&) = delete;
  void operator=(const vtkAdaptiveRefinementRepresentation&) = delete;

  void ApplyColorMode();
  void GiveBounds(vtkInformation* inInfo);
  int RequestRender(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo);
  void ReportProblems();

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  // This mapper computes the bounds before the data reach the process that draws.
  vtkNew<vtkAdaptiveRefinementMapper> Measure;
  vtkNew<vtkAdaptiveRefinementMapper> Unused; // replaces the mapper where the base class sets it
  vtkMTimeType AttributesTime = 0;            // of the data whose block attributes the mapper has
  int Method = 0;
  int RefinementColorMode = 0;
};

#endif
