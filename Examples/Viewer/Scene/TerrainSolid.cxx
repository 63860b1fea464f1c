// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/TerrainSolid.h"

#include "Files/FileEnd.h"
#include "Files/ViewerExport.h"
#include "Options/ViewerOptions.h"
#include "Scene/TerrainExport.h"
#include "Text/ReadingGuard.h"
#include "Text/ViewerMessages.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTerrainMeshSource.h"
#include "vtkTerrainPyramid.h"

#include <sstream>

namespace
{
// The range of heights is known before the mesh, which can take long.
void CheckBase(const ViewerOptions& options, vtkTerrainPyramid* pyramid)
{
  double range[2];
  if (!pyramid->Update() || !pyramid->WaitForIndex())
  {
    return;
  }
  pyramid->GetRange(range);
  if (range[0] < range[1] && *options.Base >= range[0])
  {
    std::ostringstream text;
    text << options.Input << ": --base is " << *options.Base
         << ", but it must be below the terrain, whose lowest height is " << range[0];
    throw ViewerError(text.str());
  }
}
}

//------------------------------------------------------------------------------
void ExportTerrainSolid(const ViewerOptions& options, ViewerMessages& messages)
{
  vtkNew<vtkTerrainPyramid> pyramid;
  vtkNew<vtkTerrainMeshSource> source;
  {
    const ReadingGuard guard(std::vector<std::string>{ options.Input });
    CheckRasterEnd(options.Input, messages);
    messages.Observe(pyramid, "indexing");
    messages.Observe(source);
    pyramid->SetFileName(options.Input.c_str());
    messages.Name("BaseHeight", "--base");
    CheckBase(options, pyramid);
    messages.Check();
    source->SetPyramid(pyramid);
    source->SetMaximumError(*options.Tolerance);
    source->SetExaggeration(options.Exaggeration.value_or(1.0));
    source->UseBaseOn();
    source->SetBaseHeight(*options.Base);
    source->Update();
    messages.Check();
  }
  if (source->GetOutput()->GetNumberOfCells() == 0)
  {
    throw ViewerError(options.Input + " has no heights");
  }
  ExportedMesh mesh;
  mesh.Mesh = source->GetOutput();
  mesh.UpAxis = 2;
  WriteTerrainMesh(options, source, mesh, options.Export, messages);
}
