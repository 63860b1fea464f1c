// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MeshSection
 * @brief   fills the cut of a plane through solid cells, and draws the edges of the cells there
 */
#ifndef MeshSection_h
#define MeshSection_h

#include "vtkNew.h"

class ViewerMessages;
class vtkActor;
class vtkCurvedCellCutter;
class vtkDataSet;
class vtkMapper;
class vtkPlane;
class vtkPolyDataMapper;
class vtkProperty;
class vtkRenderer;

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

private:
  vtkPlane* Plane;
  vtkNew<vtkCurvedCellCutter> Cutter;
  vtkNew<vtkPolyDataMapper> Faces;
  vtkNew<vtkPolyDataMapper> Lines;
  vtkNew<vtkActor> FaceActor;
  vtkNew<vtkActor> LineActor;
};

#endif
