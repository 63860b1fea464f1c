// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveRefinementFilter promises an error that names the value if numbers exceed the float
// range. It never outputs a point or normal that is not finite.
#include "RelevoCheck.h"
#include "RelevoDisplacements.h"
#include "RelevoTestMeshes.h"

#include "vtkAdaptiveRefinementFilter.h"
#include "vtkExecutive.h"
#include "vtkG1Surface.h"
#include "vtkLinearSurface.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPhongSurface.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkProceduralSurface.h"
#include "vtkScalarTaggedSurface.h"

#include <cmath>

namespace
{
using namespace RelevoMeshes;

bool IsFinite(vtkDataArray* array)
{
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      if (!std::isfinite(array->GetComponent(i, c)))
      {
        return false;
      }
    }
  }
  return true;
}

struct Outcome
{
  bool Finite = true;
  vtkIdType Cells = 0;
  bool Refused = false;
};

// Refines. If `words` is not empty, an error with these words is expected.
Outcome Run(RelevoCheck& check, vtkPolyData* mesh, vtkAdaptiveRefinement* recipe,
  const std::string& words, const std::string& what)
{
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  RelevoErrors errors(filter);
  RelevoErrors executive(filter->GetExecutive());
  filter->SetInputData(mesh);
  filter->SetRefinement(recipe);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  Outcome outcome;
  outcome.Cells = output->GetNumberOfCells();
  outcome.Refused = outcome.Cells == 0;
  outcome.Finite = (!output->GetPoints() || IsFinite(output->GetPoints()->GetData())) &&
    IsFinite(output->GetPointData()->GetNormals());
  if (!outcome.Finite || outcome.Refused != !words.empty())
  {
    errors.Said("what it says");
    check.Fail(__FILE__, __LINE__,
      what + (outcome.Finite ? "" : ": not finite") + (outcome.Refused ? ": refused" : ": drawn"));
  }
  if (!words.empty() && !errors.Said(words))
  {
    check.Fail(__FILE__, __LINE__, what + ": no error with \"" + words + "\"");
  }
  return outcome;
}

void TestDisplacements(RelevoCheck& check)
{
  struct Case
  {
    const char* Name;
    double Scale;
    double Offset;
    double Height;
    bool Fits;
  };
  for (const Case& each : std::initializer_list<Case>{ { "scale", 1e38, 0, 1, false },
         { "scale beyond floats", 1e300, 0, 1e-300, false }, { "offset", 0, -1e38, 1, false },
         { "offset beyond floats", 1, 1e200, 1, false }, { "heights", 1, 0, 3e38, false },
         { "scale and heights", 1e20, 0, 1e20, false },
         { "one against the other", 1e38, -1e38, 1, false },
         { "as much as there is room for", 1e20, 0, 1e9, true },
         { "large heights made small", 1e-37, 0, 3e37, true } })
  {
    CHECK_CASE(each.Name);
    vtkNew<RelevoHeights> heights;
    heights->Fill(16, 16, [&](double u, double v) { return each.Height * std::sin(9 * u) * v; });
    auto displacement = MakeDisplacement(heights, each.Scale, each.Offset);
    for (bool alongNormal : { true, false })
    {
      CHECK_CASE(alongNormal);
      if (!alongNormal)
      {
        displacement->SetDirection(1.0, 2.0, 3.0);
      }
      Run(check, Torus(), MakeRecipe(2, nullptr, displacement),
        each.Fits ? "" : "lower Scale or Offset", each.Name);
    }
  }
}

void TestProcedural(RelevoCheck& check)
{
  vtkNew<vtkProceduralSurface> surface;
  RelevoErrors errors(surface);
  surface->SetAmplitude(1e39); // exceeds the float range
  CHECK(errors.Said("Amplitude must be in [-3.40282e+38, 3.40282e+38], got") &&
    surface->GetAmplitude() < 1e39);
  surface->SetFrequency(1e31);
  CHECK(errors.Said("Frequency must be in [-1e+30, 1e+30], got") && surface->GetFrequency() < 1e31);
  surface->SetUniform("some", 1e39);
  CHECK(errors.Said("must be finite"));
  surface->SetFrequency(1e30);
  Run(check, Torus(), MakeRecipe(3, surface), "", "frequency");
  surface->SetAmplitude(3e38);
  Run(check, Torus(), MakeRecipe(3, surface), "lower its amplitude", "amplitude");
}

void TestCoordinates(RelevoCheck& check)
{
  vtkNew<vtkLinearSurface> linear;
  vtkNew<vtkPNTriangleSurface> quadratic;
  vtkNew<vtkPNTriangleSurface> linearNormals;
  linearNormals->QuadraticNormalsOff();
  vtkNew<vtkG1Surface> g1;
  vtkNew<vtkPhongSurface> phong;
  vtkNew<vtkScalarTaggedSurface> tagged;
  vtkNew<vtkProceduralSurface> procedural;
  procedural->SetBaseSurface(quadratic);
  const double none[3] = { 0.0, 0.0, 0.0 };
  for (vtkRefinementSurface* surface : std::initializer_list<vtkRefinementSurface*>{
         nullptr, linear, quadratic, linearNormals, g1, phong, tagged, procedural })
  {
    const bool isFlat = !surface || surface == linear;
    for (double scale :
      { 1e-60, 1e-44, 1e-38, 1e-30, 1e-20, 1e15, 1e20, 1e29, 1e32, 1e38, 1e60, 1e300 })
    {
      for (int type : { VTK_FLOAT, VTK_DOUBLE })
      {
        const bool fits = scale < (isFlat ? 2e38 : 5e29);
        if (type == VTK_FLOAT && (scale > 2e38 || scale < 1e-45))
        {
          continue; // infinite from the start, or all points coincide
        }
        for (Mesh mesh : { Torus(), Explode(Sphere(6, 5)), Cone() })
        {
          Mesh scaled = Moved(mesh, scale, none, type);
          const std::string what = std::string(surface ? surface->GetClassName() : "none") +
            " at " + std::to_string(std::log10(scale)) +
            (type == VTK_FLOAT ? ", floats" : ", doubles");
          Run(check, scaled, MakeRecipe(2, surface), fits ? "" : "scale the mesh down", what);
        }
      }
    }
  }
}
}

int TestAdaptiveRefinementFilterRange(int, char*[])
{
  RelevoCheck check;
  TestDisplacements(check);
  TestProcedural(check);
  TestCoordinates(check);
  return check.GetResult();
}
