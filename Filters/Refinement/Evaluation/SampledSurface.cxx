// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/SampledSurface.h"

#include "Changes/Dependencies.h"
#include "Evaluation/MeshPreparation.h"
#include "Evaluation/RefinementEvaluator.h"
#include "Evaluation/SampledFaces.h"
#include "Mathematics/RefinementMathematics.h"
#include "Mesh/RefinementMesh.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDisplacement.h"
#include "vtkHeightField.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRefinementSurface.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace relevo
{
namespace
{
constexpr int LowestLevel = 2; // the lowest level of a lattice with inner points
constexpr int HighestLevel = 4;

// Samples of a face: points (i, j) of a triangular lattice with i, j >= 0 and i + j <= n.
class FaceLattice
{
public:
  explicit FaceLattice(int n)
    : N(n)
    , Points(static_cast<std::size_t>((n + 1) * (n + 2) / 2))
  {
  }

  void Sample(const RefinementEvaluator& evaluator, int face)
  {
    for (int j = 0; j <= this->N; ++j)
    {
      for (int i = 0; i + j <= this->N; ++i)
      {
        const auto n = static_cast<float>(this->N);
        const float v = static_cast<float>(i) / n;
        const float w = static_cast<float>(j) / n;
        const float weights[3] = { static_cast<float>(this->N - i - j) / n, v, w };
        float position[3];
        float normal[3];
        evaluator.Evaluate(face, weights, position, normal);
        this->Points[this->GetIndex(i, j)] = dvec3(position[0], position[1], position[2]);
      }
    }
  }

  // Computes the means of the absolute curvatures at the inner points.
  void Measure(double& gaussian, double& mean) const
  {
    // In this order, adjacent entries are neighbours.
    constexpr int ring[6][2] = { { 1, 0 }, { 0, 1 }, { -1, 1 }, { -1, 0 }, { 0, -1 }, { 1, -1 } };
    gaussian = 0.0;
    mean = 0.0;
    int count = 0;
    for (int j = 1; j < this->N; ++j)
    {
      for (int i = 1; i + j < this->N; ++i)
      {
        RingCurvature curvature(this->Points[this->GetIndex(i, j)]);
        for (int k = 0; k < 6; ++k)
        {
          const int* p = ring[k];
          const int* q = ring[(k + 1) % 6];
          curvature.Add(this->Points[this->GetIndex(i + p[0], j + p[1])],
            this->Points[this->GetIndex(i + q[0], j + q[1])]);
        }
        gaussian += std::abs(curvature.GetGaussian());
        mean += std::abs(curvature.GetMean());
        ++count;
      }
    }
    gaussian /= count;
    mean /= count;
  }

private:
  std::size_t GetIndex(int i, int j) const
  {
    return static_cast<std::size_t>(j * (2 * this->N + 3 - j) / 2 + i);
  }

  int N;
  std::vector<dvec3> Points;
};

struct FaceCurvature
{
  double Gaussian = 0.0;
  double Mean = 0.0;
  double Area = 0.0; // of the coarse face
};

double GetArea(const RefinementMesh& mesh, const RefinementFace& face)
{
  dvec3 x[3];
  for (int i = 0; i < 3; ++i)
  {
    const float* point = &mesh.Points[3 * static_cast<std::size_t>(face.Corners[i])];
    x[i] = dvec3(point[0], point[1], point[2]);
  }
  return 0.5 * length(cross(x[1] - x[0], x[2] - x[0]));
}

std::vector<FaceCurvature> MeasureFaces(const RefinementMesh& mesh, vtkAdaptiveRefinement* recipe)
{
  std::vector<FaceCurvature> faces(mesh.Faces.size());
  const RefinementEvaluator evaluator(mesh, recipe);
  const int n = 1 << std::max(LowestLevel, std::min(recipe->GetMaximumLevel(), HighestLevel));
  vtkSMPTools::For(0, static_cast<vtkIdType>(faces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      FaceLattice lattice(n);
      for (vtkIdType f = begin; f < end; ++f)
      {
        FaceCurvature& face = faces[f];
        lattice.Sample(evaluator, static_cast<int>(f));
        lattice.Measure(face.Gaussian, face.Mean);
        face.Area = GetArea(mesh, mesh.Faces[f]);
      }
    });
  return faces;
}
}

std::shared_ptr<const SampledSurface> SampledSurface::Make(vtkAdaptiveRefinement* recipe)
{
  vtkDisplacement* displacement = recipe ? recipe->GetDisplacement() : nullptr;
  const bool hasHeights = displacement && displacement->GetHeightMap();
  return hasHeights ? std::make_shared<SampledSurface>(recipe) : nullptr;
}

SampledSurface::SampledSurface(vtkAdaptiveRefinement* recipe)
  : Recipe(recipe)
{
}

void SampledSurface::AddTo(Dependencies& dependencies) const
{
  dependencies.AddObject(this->Recipe->GetDisplacement());
  dependencies.Add(this->Recipe->GetDisplacement()->GetHeightMap()->GetSamplesMTime());
  dependencies.AddObject(this->Recipe->GetSurface());
  dependencies.Add(this->Recipe->GetMaximumLevel());
}

DiscreteCurvature SampledSurface::ComputeCurvature(
  vtkPolyData* input, const GlobalSurfaceInfo* whole) const
{
  const auto n = static_cast<std::size_t>(input->GetNumberOfPoints());
  DiscreteCurvature result;
  result.Gaussian.assign(n, 0.0);
  result.Mean.assign(n, 0.0);
  vtkNew<vtkPolyData> all; // including ghost cells
  all->ShallowCopy(input);
  all->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  RefinementMesh mesh;
  std::string error; // the filter or mapper reports it
  std::string warning;
  if (!BuildMesh(all, this->Recipe, false, whole, mesh, error, warning))
  {
    return result;
  }
  const std::vector<FaceCurvature> faces = MeasureFaces(mesh, this->Recipe);
  std::vector<double> areas(n, 0.0);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    for (int corner : mesh.Faces[f].Corners)
    {
      const auto mergedPoint = static_cast<std::size_t>(mesh.GetMergedPoint(corner));
      areas[mergedPoint] += faces[f].Area;
      result.Gaussian[mergedPoint] += faces[f].Area * faces[f].Gaussian;
      result.Mean[mergedPoint] += faces[f].Area * faces[f].Mean;
    }
  }
  for (std::size_t mergedPoint = 0; mergedPoint < n; ++mergedPoint)
  {
    if (areas[mergedPoint] > 0.0)
    {
      result.MergedPoints.push_back(static_cast<vtkIdType>(mergedPoint));
      result.Gaussian[mergedPoint] /= areas[mergedPoint];
      result.Mean[mergedPoint] /= areas[mergedPoint];
    }
  }
  for (std::size_t point = 0; !mesh.MergedPoints.empty() && point < n; ++point)
  {
    const auto mergedPoint = static_cast<std::size_t>(mesh.MergedPoints[point]);
    result.Gaussian[point] = result.Gaussian[mergedPoint];
    result.Mean[point] = result.Mean[mergedPoint];
  }
  return result;
}

std::unique_ptr<DisplacedFaces> SampledSurface::MakeFaces(vtkPolyData* input,
  const GlobalSurfaceInfo* whole, std::shared_ptr<const PatternFamily> patterns) const
{
  auto faces = std::make_unique<SampledFaces>();
  std::string error; // the filter or mapper reports it
  std::string warning;
  if (!BuildMesh(input, this->Recipe, false, whole, faces->Mesh, error, warning))
  {
    return nullptr;
  }
  faces->Take(this->Recipe, std::move(patterns));
  return faces;
}

int SampledSurface::GetMaximumLevel() const
{
  return this->Recipe->GetMaximumLevel();
}
}
