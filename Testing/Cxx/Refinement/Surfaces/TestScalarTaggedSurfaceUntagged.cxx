// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkScalarTaggedSurface promises: without tags it equals vtkPNTriangleSurface, bit for bit.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDisplacement.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkScalarTaggedSurface.h"

#include <cstring>

using namespace RelevoMeshes;

namespace
{
// Compares points, normals and triangles bit by bit.
bool areSame(vtkPolyData* a, vtkPolyData* b)
{
  const auto sameBytes = [](vtkDataArray* l, vtkDataArray* r)
  {
    return l->GetNumberOfValues() == r->GetNumberOfValues() && l->GetNumberOfValues() > 0 &&
      l->GetDataType() == r->GetDataType() &&
      std::memcmp(l->GetVoidPointer(0), r->GetVoidPointer(0),
        static_cast<size_t>(l->GetNumberOfValues() * l->GetDataTypeSize())) == 0;
  };
  return sameBytes(a->GetPoints()->GetData(), b->GetPoints()->GetData()) &&
    sameBytes(a->GetPointData()->GetNormals(), b->GetPointData()->GetNormals()) &&
    sameBytes(a->GetPolys()->GetConnectivityArray(), b->GetPolys()->GetConnectivityArray());
}

// PN triangles result without tags, with zero tags, and with directions but no sharpness.
void testUntagged(RelevoCheck& check)
{
  Mesh split = Explode(Sphere(8, 6));
  PerturbNormals(split, 3, 0.8);
  const double utm[3] = { 412345.678, 5654321.987, 312.5 };
  const Mesh meshes[] = { Sphere(8, 6), Explode(Sphere(8, 6)), Cube(), Cone(), split, NonManifold(),
    Moebius(), Slivers(), NegativeZeros(), Moved(split, 2000.0, utm, VTK_DOUBLE) };
  vtkNew<vtkPNTriangleSurface> pn;
  vtkNew<vtkScalarTaggedSurface> tagged;
  vtkNew<vtkDisplacement> displacement;
  displacement->SetOffset(0.1);
  for (const Mesh& mesh : meshes)
  {
    for (bool displaced : { false, true })
    {
      const auto expected = MakeRecipe(4, pn);
      const auto recipe = MakeRecipe(4, tagged);
      if (displaced)
      {
        expected->SetDisplacement(displacement);
        recipe->SetDisplacement(displacement);
      }
      Mesh zeros = Make();
      zeros->DeepCopy(mesh);
      AddTags(zeros, 5, 4);
      Mesh refined = Refine(zeros, expected);
      CHECK(areSame(Refine(zeros, recipe), refined));
      AddScalarTags(zeros, "Sharpness");
      AddScalarTags(zeros, "Tension");
      AddScalarTags(zeros, "Bias");
      AddScalarTags(zeros, "Direction", 3);
      CHECK(areSame(Refine(zeros, recipe), refined));
      zeros->GetPointData()->GetArray("Direction")->Fill(1.0);
      CHECK(areSame(Refine(zeros, recipe), refined));
      // Negative control: with tension, the results differ.
      zeros->GetPointData()->GetArray("Tension")->Fill(0.5);
      CHECK(!areSame(Refine(zeros, recipe), refined));
    }
  }
}
}

int TestScalarTaggedSurfaceUntagged(int, char*[])
{
  RelevoCheck check;
  testUntagged(check);
  return check.GetResult();
}
