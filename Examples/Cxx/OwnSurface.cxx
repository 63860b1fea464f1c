// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Example of a custom surface: pillows that are highest in the middle of each coarse triangle.
 * Prints the height of one in the filter and in the mapper.
 */
#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkCamera.h"
#include "vtkEGLOffscreenRenderWindow.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkRefinementSurface.h"
#include "vtkRenderer.h"
#include "vtkWorldPointPicker.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace
{
class PillowSurface : public vtkRefinementSurface
{
public:
  static PillowSurface* New();
  vtkTypeMacro(PillowSurface, vtkRefinementSurface);

  bool NeedsNormals() override { return true; }
  double GetReach() override { return this->Height; }

  // For the filter. The barycentric weights belong to the corners of the face. On the border of the
  // face, one weight is 0, and the point lies on the coarse edge.
  void Evaluate(
    const Face& face, const float weights[3], float position[3], float normal[3]) override
  {
    const float height =
      static_cast<float>(this->Height) * 27.0f * weights[0] * weights[1] * weights[2];
    for (int i = 0; i < 3; ++i)
    {
      position[i] = 0.0f;
      normal[i] = 0.0f;
      for (int corner = 0; corner < 3; ++corner)
      {
        position[i] += weights[corner] * face.Points[corner][i];
        normal[i] += weights[corner] * face.Normals[corner][i];
      }
      position[i] += height * normal[i];
    }
  }

  // For the mapper: the same surface in GLSL.
  std::string GetShaderSource() override
  {
    return R"(
uniform float pillowHeight;

vec3 surfaceNormal(vec3 w)
{
  return weightedSum(cornerNormal(0), cornerNormal(1), cornerNormal(2), w);
}

vec3 surfacePosition(vec3 w)
{
  precise vec3 p = weightedSum(cornerPoint(0), cornerPoint(1), cornerPoint(2), w);
  p += surfaceNormal(w) * surfaceScale() * (pillowHeight * 27.0 * w.x * w.y * w.z);
  return p;
}
)";
  }
  std::vector<Uniform> GetUniforms() override
  {
    return { { "pillowHeight", { static_cast<float>(this->Height) } } };
  }

private:
  double Height = 0.1;
};
vtkStandardNewMacro(PillowSurface);
}

int main()
{
  vtkNew<vtkPlaneSource> plane; // one square at z = 0
  vtkNew<PillowSurface> surface;
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetSurface(surface);
  recipe->SetMaximumLevel(4);

  vtkNew<vtkAdaptiveRefinementFilter> refine;
  refine->SetInputConnection(plane->GetOutputPort());
  refine->SetRefinement(recipe);
  refine->Update();
  const double highest = refine->GetOutput()->GetBounds()[5];

  vtkNew<vtkAdaptiveRefinementMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  mapper->SetRefinement(recipe);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->GetActiveCamera()->ParallelProjectionOn();
  renderer->GetActiveCamera()->SetParallelScale(0.5); // the square fills the window
  vtkNew<vtkEGLOffscreenRenderWindow> window;
  window->SetSize(300, 300);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkWorldPointPicker> picker;
  picker->Pick(200.0, 100.0, 0.0, renderer); // the middle of the lower right triangle
  const double picked = picker->GetPickPosition()[2];

  std::cout << "filter " << highest << ", mapper " << picked << "\n";
  return std::abs(highest - 0.1) < 0.01 && std::abs(picked - 0.1) < 0.01 ? EXIT_SUCCESS
                                                                         : EXIT_FAILURE;
}
