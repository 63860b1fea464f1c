// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that refined and displaced scans and models stay closed, bit for bit, where the coarse
// mesh is.
#include "RelevoCheck.h"
#include "RelevoDisplacements.h"
#include "RelevoTestMeshes.h"
#include "RelevoWatertight.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkPLYReader.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPolyDataNormals.h"
#include "vtkXMLPolyDataReader.h"

#include <cstdlib>
#include <fstream>
#include <iostream>

using namespace RelevoMeshes;

namespace
{
template <typename ReaderT>
Mesh read(const std::string& file)
{
  vtkNew<ReaderT> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  Mesh mesh = Make();
  mesh->DeepCopy(reader->GetOutputDataObject(0));
  return mesh;
}
}

int TestWatertightRealMeshes(int, char*[])
{
  const char* data = std::getenv("RELEVO_TEST_DATA");
  const std::string folder = data ? data : "";
  if (!std::ifstream(folder + "/mesh/bunny.ply") || !std::ifstream(folder + "/mesh/cow.vtp"))
  {
    std::cerr << "RELEVO_TEST_DATA has no mesh/bunny.ply and mesh/cow.vtp: skipped\n";
    return 125;
  }
  RelevoCheck check;
  const std::pair<const char*, Mesh> meshes[] = {
    { "bunny", read<vtkPLYReader>(folder + "/mesh/bunny.ply") },
    { "cow", read<vtkXMLPolyDataReader>(folder + "/mesh/cow.vtp") }
  };
  vtkNew<vtkPNTriangleSurface> surface;
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(64, 64, 1);
  for (const auto& mesh : meshes)
  {
    CHECK_GREATER(mesh.second->GetNumberOfPolys(), 1000);
    const double size = mesh.second->GetLength();
    auto displacement = MakeDisplacement(heights, 0.003 * size);
    for (int split = 0; split < 2; ++split)
    {
      Mesh input = mesh.second;
      if (split)
      {
        vtkNew<vtkPolyDataNormals> normals;
        normals->SetInputData(mesh.second);
        normals->SetFeatureAngle(30.0);
        normals->ConsistencyOff();
        normals->Update();
        input = normals->GetOutput();
        CHECK_GREATER(input->GetNumberOfPoints(), mesh.second->GetNumberOfPoints());
      }
      AddRandomTextureCoordinates(input, 2);
      AddTags(input, 3, 2);
      vtkNew<vtkAdaptiveRefinement> recipe;
      recipe->SetMaximumLevel(2);
      recipe->SetSurface(surface);
      recipe->SetDisplacement(displacement);
      vtkNew<vtkAdaptiveRefinementFilter> filter;
      filter->SetInputData(input);
      filter->SetRefinement(recipe);
      filter->Update();
      const std::string error = RelevoWatertight::FindError(input, filter->GetOutput(), 2);
      if (!error.empty())
      {
        check.Fail(__FILE__, __LINE__, std::string(mesh.first) + ": " + error);
      }
      std::cout << mesh.first << ": " << input->GetNumberOfCells() << " -> "
                << filter->GetOutput()->GetNumberOfPolys() << "\n";
    }
  }
  return check.GetResult();
}
