// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/SceneActor.h"

#include "Mesh/MovedSurface.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkMapper.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
// Relative to coordinates; larger than the rounding error of a product with a matrix.
constexpr double Rounding = 1e-14;

vtkPolyData* FindSurface(vtkMapper* mapper)
{
  vtkAlgorithmOutput* connection =
    mapper->GetNumberOfInputConnections(0) > 0 ? mapper->GetInputConnection(0, 0) : nullptr;
  auto mesh = connection ? vtkPolyData::SafeDownCast(
                             connection->GetProducer()->GetOutputDataObject(connection->GetIndex()))
                         : nullptr;
  const bool hasFaces = mesh && mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() > 0;
  return hasFaces ? mesh : nullptr;
}
}

bool HaveCommonBox(const Bounds& a, const Bounds& b)
{
  return a[0] <= b[1] && b[0] <= a[1] && a[2] <= b[3] && b[2] <= a[3] && a[4] <= b[5] &&
    b[4] <= a[5];
}

Bounds GetCommonBox(const Bounds& a, const Bounds& b)
{
  Bounds common;
  for (int i = 0; i < 6; i += 2)
  {
    common[i] = std::max(a[i], b[i]);
    common[i + 1] = std::min(a[i + 1], b[i + 1]);
  }
  return common;
}

vtkAdaptiveRefinement* FindRecipe(vtkActor* actor)
{
  auto mapper = vtkAdaptiveRefinementMapper::SafeDownCast(actor->GetMapper());
  return mapper ? mapper->GetRefinement() : nullptr;
}

SceneActor::SceneActor(vtkActor* actor)
  : Actor(actor)
  , Triangles(std::make_shared<MovedSurface>())
{
}

void SceneActor::Update()
{
  this->Surface = nullptr;
  this->IsPlaced = false;
  vtkMapper* mapper = this->Actor->GetMapper();
  if (!mapper)
  {
    return;
  }
  this->Actor->ComputeMatrix();
  const double* now = this->Actor->GetMatrix()->GetData();
  if (!std::equal(now, now + 16, this->Matrix->GetData()))
  {
    this->Matrix->DeepCopy(now);
  }
  // This call updates the input.
  this->IsPlaced = this->TakeBox(mapper->GetBounds());
  this->Surface = FindSurface(mapper);
}

bool SceneActor::TakeBox(const double* bounds)
{
  if (!bounds || !vtkMath::AreBoundsInitialized(bounds))
  {
    return false;
  }
  bool isFinite = true;
  for (int row = 0; row < 3; ++row)
  {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    double largest = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      double x = this->Matrix->GetElement(row, 3);
      double sum = std::abs(x);
      for (int c = 0; c < 3; ++c)
      {
        const double product =
          this->Matrix->GetElement(row, c) * bounds[2 * c + ((corner >> c) & 1)];
        x += product;
        sum += std::abs(product);
      }
      isFinite = isFinite && std::isfinite(sum);
      low = std::min(low, x);
      high = std::max(high, x);
      largest = std::max(largest, sum);
    }
    this->Box[2 * row] = low - Rounding * largest;
    this->Box[2 * row + 1] = high + Rounding * largest;
  }
  return isFinite;
}
}
