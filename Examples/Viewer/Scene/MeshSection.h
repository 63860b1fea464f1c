// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MeshSection
 * @brief   fills the cut of a plane through solid cells, and draws the edges of the cells there
 */
#ifndef MeshSection_h
#define MeshSection_h

#include "vtkNew.h"
#include "vtkType.h"

#include <memory>
#include <string>
#include <vector>

class SectionIsolines;
class ViewerMessages;
class vtkActor;
class vtkCurvedCellCutter;
class vtkDataSet;
class vtkMapper;
class vtkPlane;
class vtkPolyDataMapper;
class vtkProperty;
class vtkRenderer;
class vtkStaticCellLocator;

class MeshSection
{
public:
  /// Adds the section to a renderer. It follows the plane and the mesh.
  MeshSection(vtkPlane* plane, vtkRenderer* renderer, ViewerMessages& messages);
  ~MeshSection();

  /// The cells that the plane cuts.
  void SetMesh(vtkDataSet* mesh);

  /// Draws the section in the colours of the mesh's surface, nearly without shading.
  void SetColours(vtkMapper* mapper, vtkProperty* property);

  /// Draws isolines at the multiples of a spacing in a range of an array of points, or of the
  /// lengths of vectors.
  void SetIsolines(const std::string& array, bool isVector, double spacing, const double range[2]);

  /// Returns the cell of the mesh that is cut at a point, or -1 if the section is not there within
  /// the distance, and all components of an array of points or cells there.
  vtkIdType Find(const double place[3], double distance, const std::string& array, bool isOfPoints,
    std::vector<double>& value);

private:
  vtkPlane* Plane;
  vtkRenderer* Renderer;
  vtkNew<vtkCurvedCellCutter> Cutter;
  vtkNew<vtkPolyDataMapper> Faces;
  vtkNew<vtkPolyDataMapper> Lines;
  vtkNew<vtkActor> FaceActor;
  vtkNew<vtkActor> LineActor;
  std::unique_ptr<SectionIsolines> Isolines; // nullptr for none
  vtkNew<vtkStaticCellLocator> Locator;      // of the section, when it is first asked
};

#endif
