// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveRefinementMapper promises GetNumberOfDrawnTriangles(), compared with OpenGL's count
// for every method.
#include "RelevoMethods.h"
#include "RelevoPrimitiveCount.h"
#include "RelevoTestMeshes.h"

#include "vtkIdList.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
using namespace RelevoMeshes;
using namespace RelevoMethods;
using namespace RelevoPrimitiveCount;

// Number of triangles that SUAPT draws: 4 to the power of the highest level of each face.
vtkIdType CountSemiUniform(vtkPolyData* mesh)
{
  vtkDataArray* tags = mesh->GetPointData()->GetArray("DepthTag");
  vtkNew<vtkIdList> ids;
  vtkIdType count = 0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    double highest = 0.0;
    for (vtkIdType k = 0; k < 3; ++k)
    {
      const double mean =
        0.5 * (tags->GetTuple1(ids->GetId(k)) + tags->GetTuple1(ids->GetId((k + 1) % 3)));
      highest = std::max(highest, std::floor(mean + 0.5));
    }
    count += static_cast<vtkIdType>(std::pow(4.0, highest));
  }
  return count;
}

}

int TestAdaptiveRefinementMapperMethodsCount(int, char*[])
{
  RelevoCheck check;
  vtkNew<vtkPNTriangleSurface> surface;
  for (bool tagged : { false, true })
  {
    for (bool near : { false, true })
    {
      Mesh mesh = Sphere(12, 8);
      // With at least 32 segments, each instance of a pattern has one face.
      const int level = tagged ? 4 : 5;
      if (tagged)
      {
        AddTags(mesh, 3, level);
      }
      vtkNew<vtkAdaptiveRefinement> recipe;
      recipe->SetMaximumLevel(level);
      recipe->SetSurface(surface);
      recipe->SetGeomorphing(0);
      RelevoScene scene(RelevoScene::Refining);
      scene.Add(mesh, recipe);
      scene.ResetCameras();
      if (near)
      {
        scene.Renderer->GetActiveCamera()->Zoom(4.0);
      }
      Mapper* mapper = scene.GetMapper(0);
      const vtkIdType expected = Refine(mesh, recipe)->GetNumberOfPolys();
      for (int method : GetMethods())
      {
        mapper->SetMethod(method);
        CHECK_EQUAL(mapper->GetMethod(), method);
        mapper->FrustumCullingOff();
        const vtkIdType counted = CountTriangles(scene);
        const vtkIdType drawn = mapper->GetNumberOfDrawnTriangles();
        mapper->FrustumCullingOn();
        const vtkIdType seen = CountTriangles(scene);
        const vtkIdType culled = mapper->GetNumberOfCulledFaces();
        const vtkIdType inView = mapper->GetNumberOfDrawnTriangles();
        CHECK_EQUAL(inView + mapper->GetNumberOfCulledTriangles(), drawn);
        CHECK(culled > 0 ? seen < counted : seen == counted);
        std::cout << GetName(method) << ": " << drawn << " triangles, OpenGL counts " << counted
                  << ", " << culled << " faces culled" << std::endl;
        const bool isARK = method == Mapper::METHOD_ARK;
        CHECK((near ? culled > 0 : culled == 0));
        if (isARK || method == Mapper::METHOD_ARKFPI)
        {
          CHECK_EQUAL(drawn, expected);
        }
        if (isARK)
        {
          CHECK_EQUAL(drawn, counted);
          CHECK_EQUAL(inView, seen);
          CHECK_EQUAL(mapper->GetNumberOfDrawCalls(), mapper->GetNumberOfCoarseFaces() - culled);
        }
        else if (method == Mapper::METHOD_DMR || (!tagged && method != Mapper::METHOD_ARKFPI))
        {
          CHECK_EQUAL(drawn, counted);
          CHECK_EQUAL(inView, seen);
        }
        else if (method != Mapper::METHOD_ARKFPI)
        {
          // The last instances may have unused slots for faces.
          CHECK(drawn <= counted && inView <= seen);
        }
        if (tagged && method == Mapper::METHOD_SUAPT)
        {
          CHECK_EQUAL(drawn, CountSemiUniform(mesh));
        }
        if (!tagged)
        {
          CHECK_EQUAL(drawn, mesh->GetNumberOfCells() * 1024);
        }
      }
    }
  }
  return check.GetResult();
}
