// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   StreamlineActor
 * @brief   streamlines along vectors of a mesh, as tubes
 */
#ifndef StreamlineActor_h
#define StreamlineActor_h

#include "vtkNew.h"

#include <string>

class ViewerMessages;
class vtkActor;
class vtkCellDataToPointData;
class vtkDataSet;
class vtkPolyDataMapper;
class vtkRenderer;
class vtkScalarsToColors;
class vtkStreamTracer;
class vtkTubeFilter;
struct ViewerOptions;

class StreamlineActor
{
public:
  /// Adds the lines to a renderer.
  StreamlineActor(vtkRenderer* renderer, ViewerMessages& messages);
  ~StreamlineActor();

  /// Traces the lines of the options through a mesh. Throws ViewerError if it has no such vectors.
  /// Warns if no seed is in the mesh.
  void Trace(const ViewerOptions& options, vtkDataSet* mesh);

  /// Colours the lines by an array of the mesh, which is averaged at points if it is one of cells.
  void SetColours(const std::string& array, vtkScalarsToColors* table);

private:
  ViewerMessages& Messages;
  vtkNew<vtkCellDataToPointData> Average;
  vtkNew<vtkStreamTracer> Tracer;
  vtkNew<vtkTubeFilter> Tubes;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
};

#endif
