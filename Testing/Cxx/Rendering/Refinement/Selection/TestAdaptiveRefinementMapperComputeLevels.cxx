// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that compute shaders select the same patterns as PatternSelection and cull the same faces
// as FaceCulling.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"

#include "Buffers/RefinementPatternBuffer.h"
#include "Compute/RefinementComputeProgram.h"
#include "Compute/RefinementComputeState.h"
#include "Evaluation/EdgeTags.h"
#include "Evaluation/FaceCulling.h"
#include "Evaluation/PatternSelection.h"
#include "Mesh/RefinementMesh.h"
#include "Patterns/PatternFamily.h"
#include "Recipe/RecipeLevels.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCamera.h"
#include "vtkCompositeDepthTagMetric.h"
#include "vtkCurvatureDepthTagMetric.h"
#include "vtkDepthTagMetric.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPLYReader.h"
#include "vtkPoints.h"
#include "vtkRefinementPatternTable.h"
#include "vtkRenderWindow.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkSilhouetteDepthTagMetric.h"
#include "vtkTransform.h"
#include "vtkViewDependentDepthTagMetric.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <numeric>

namespace
{
using namespace RelevoMeshes;
using relevo::RefinementComputeBuffer;
using relevo::RefinementComputeState;

// One mesh on the GPU, seen from several sides.
class Comparison
{
public:
  Comparison(RelevoCheck& check, vtkOpenGLRenderWindow* window, vtkPolyData* input)
    : Check(check)
    , Window(window)
    , Input(input)
  {
    const double* center = input->GetCenter();
    this->Camera->SetFocalPoint(center);
    this->Camera->SetPosition(center[0] + 0.4 * input->GetLength(),
      center[1] + 0.3 * input->GetLength(), center[2] + 0.5 * input->GetLength());
    this->Transform->RotateX(20.0);
    this->Transform->Scale(1.0, 1.2, 0.9);
  }
  ~Comparison()
  {
    this->Faces.ReleaseGraphicsResources();
    this->Instances.ReleaseGraphicsResources();
    this->MorphTags.ReleaseGraphicsResources();
    this->State.ReleaseGraphicsResources();
    this->Patterns.ReleaseGraphicsResources();
  }

  void Compare(const std::string& name, vtkAdaptiveRefinement* recipe)
  {
    relevo::RefinementView view;
    view.Camera = this->Camera;
    view.ModelToWorld = this->Transform->GetMatrix();
    view.ViewportSize[0] = 800;
    view.ViewportSize[1] = 600;
    relevo::RefinementMesh mesh;
    relevo::EdgeTags tags;
    relevo::EdgeTags described;
    std::string error;
    if (!this->Check.That(
          mesh.Build(this->Input, recipe->GetSurface(), recipe->GetDisplacement()) &&
            tags.Compute(recipe, this->Input, mesh, view, error) &&
            described.ComputeOrDescribe(recipe, this->Input, mesh, view, error),
          (name + " can be selected").c_str(), __FILE__, __LINE__))
    {
      return;
    }
    relevo::PatternSelection selection;
    selection.Select(mesh, tags, *relevo::GetPatternFamily(recipe, this->Input),
      recipe->GetMaximumLevel(), static_cast<float>(recipe->GetLevelOffset()));
    selection.Group();
    this->MaximumGroups = std::max(this->MaximumGroups, selection.Groups.size());
    relevo::FaceCulling culling;
    culling.Build(mesh, recipe);
    const relevo::CullingView sight(this->Camera, 4.0 / 3.0, view.ModelToWorld, mesh.Origin);
    if (this->Prepare(mesh, culling, recipe))
    {
      this->Update(tags, culling, sight, recipe);
      this->CheckPatterns(name, mesh, selection, recipe, 0.0f);
      this->CheckHidden(mesh, culling, sight);
      if (described.GetShader())
      {
        ++this->NumberOfShaders;
        this->Update(described, culling, sight, recipe);
        this->CheckPatterns(name + ", tags on the GPU", mesh, selection, recipe, 1e-5f);
      }
    }
  }

  /// Number of comparisons of metrics that the GPU evaluates.
  int NumberOfShaders = 0;

  /// Maximum over all comparisons. If all faces had the same pattern, the comparison would prove
  /// little.
  size_t MaximumGroups = 0;

private:
  bool Prepare(const relevo::RefinementMesh& mesh, const relevo::FaceCulling& culling,
    vtkAdaptiveRefinement* recipe)
  {
    std::vector<int> corners(4 * mesh.Faces.size());
    for (size_t f = 0; f < mesh.Faces.size(); ++f)
    {
      std::copy_n(mesh.Faces[f].Corners, 3, &corners[4 * f]);
    }
    ++this->Time;
    RelevoCheck& check = this->Check;
    const bool prepared = CHECK(this->Faces.Upload(corners) &&
      this->Instances.Resize(4 * mesh.Faces.size()) &&
      this->MorphTags.Resize(12 * mesh.Faces.size()) && this->State.UpdateMesh(mesh, this->Time) &&
      this->State.UpdateCulling(culling, this->Time) &&
      this->State.UpdatePatterns(*recipe->GetPatternTable()->GetLibrary(),
        relevo::GetPatternFamily(recipe, this->Input), recipe->GetMaximumLevel(), this->Patterns,
        false));
    if (!prepared)
    {
      std::cerr << this->State.GetError() << "\n";
    }
    return prepared;
  }

  void Update(const relevo::EdgeTags& tags, const relevo::FaceCulling& culling,
    const relevo::CullingView& sight, vtkAdaptiveRefinement* recipe)
  {
    ++this->LevelsTime;
    const auto update = [&]()
    {
      return this->State.UpdateView(this->Window, 0, tags,
        static_cast<float>(recipe->GetLevelOffset()), this->LevelsTime, &sight,
        culling.HidesBackFaces(sight, true),
        { this->Faces.GetHandle(), this->Instances.GetHandle(), this->MorphTags.GetHandle() });
    };
    RelevoCheck& check = this->Check;
    if (!CHECK(update()))
    {
      std::cerr << this->State.GetError() << "\n";
    }
    const vtkMTimeType updated = this->State.GetTime(0);
    CHECK(update());
    CHECK_EQUAL(this->State.GetTime(0), updated); // nothing has changed
  }

  // Quotients and square roots may differ in the last bits, so that a tag is rounded to another
  // level.
  void CheckPatterns(const std::string& name, const relevo::RefinementMesh& mesh,
    const relevo::PatternSelection& selection, vtkAdaptiveRefinement* recipe, float tolerance)
  {
    const auto family = relevo::GetPatternFamily(recipe, this->Input);
    const std::vector<unsigned int> entries = this->State.ReadEntries(0);
    const std::vector<float> morphTags = this->MorphTags.Read<float>(3 * mesh.Faces.size());
    size_t wrong = 0;
    float largest = 0.0f;
    for (size_t f = 0; f < mesh.Faces.size(); ++f)
    {
      const relevo::FacePattern expected = selection.GetFacePattern(static_cast<int>(f));
      const int key = static_cast<int>(entries[f] >> 3);
      wrong += family->GetPattern(key).get() != expected.Pattern ||
        relevo::PatternFamily::IsMirrored(key) != expected.Mirrored ||
        static_cast<int>(entries[f] & 7u) != expected.Code;
      for (size_t e = 0; expected.MorphTags && e < 3; ++e)
      {
        largest = std::max(largest, std::abs(expected.MorphTags[e] - morphTags[3 * f + e]));
      }
    }
    std::cout << name << ": " << mesh.Faces.size() << " faces, " << selection.Groups.size()
              << " groups; wrong patterns " << wrong << ", largest difference of morph tags "
              << largest << std::endl;
    RelevoCheck& check = this->Check;
    CHECK_LESS_EQUAL(wrong, (tolerance > 0.0f ? mesh.Faces.size() / 1000 : 0));
    CHECK_LESS_EQUAL(largest, tolerance);
  }

  void CheckHidden(const relevo::RefinementMesh& mesh, const relevo::FaceCulling& culling,
    const relevo::CullingView& sight)
  {
    std::vector<unsigned char> hidden;
    const int numberOfHidden = culling.FindHidden(sight, true, hidden);
    const std::vector<int> counts = this->State.ReadCounts(0);
    const int drawn = std::accumulate(counts.begin(), counts.end(), 0);
    RelevoCheck& check = this->Check;
    CHECK_GREATER(numberOfHidden, 0);
    // All faces agree, except those at the border of the view.
    CHECK_LESS_EQUAL(std::abs(static_cast<int>(mesh.Faces.size()) - numberOfHidden - drawn), 2);
  }

  RelevoCheck& Check;
  vtkOpenGLRenderWindow* Window;
  vtkPolyData* Input;
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkTransform> Transform;
  RefinementComputeState State;
  relevo::RefinementPatternBuffer Patterns;
  RefinementComputeBuffer Faces;
  RefinementComputeBuffer Instances;
  RefinementComputeBuffer MorphTags;
  vtkMTimeType Time = 0;
  vtkMTimeType LevelsTime = 0;
};

struct NamedMetric
{
  std::string Name;
  vtkSmartPointer<vtkDepthTagMetric> Metric;
};

std::vector<NamedMetric> MakeMetrics(double length)
{
  auto distance = vtkSmartPointer<vtkDistanceDepthTagMetric>::New();
  distance->SetMaximumDistance(1.5 * length);
  auto edges = vtkSmartPointer<vtkScreenEdgeDepthTagMetric>::New();
  edges->SetReferenceLength(4.0);
  auto silhouette = vtkSmartPointer<vtkSilhouetteDepthTagMetric>::New();
  auto viewDependent = vtkSmartPointer<vtkViewDependentDepthTagMetric>::New();
  auto curvature = vtkSmartPointer<vtkCurvatureDepthTagMetric>::New();
  auto composite = vtkSmartPointer<vtkCompositeDepthTagMetric>::New();
  composite->AddMetric(distance);
  composite->AddMetric(silhouette);
  return { { "everywhere", nullptr }, { "distance", distance }, { "screen edge", edges },
    { "silhouette", silhouette }, { "view", viewDependent }, { "curvature", curvature },
    { "composite", composite } };
}

// A mountain range.
Mesh MakeTerrain()
{
  Mesh mesh = Plane(90, 80);
  vtkPoints* points = mesh->GetPoints();
  double x[3];
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->GetPoint(i, x);
    x[2] = 0.1 * std::sin(9.0 * x[0]) * std::cos(7.0 * x[1]) + 0.02 * std::sin(40.0 * x[0] * x[1]);
    points->SetPoint(i, x);
  }
  return mesh;
}

Mesh ReadBunny()
{
  const char* data = std::getenv("RELEVO_TEST_DATA");
  const std::string file = std::string(data ? data : "") + "/mesh/bunny.ply";
  if (!std::ifstream(file))
  {
    return nullptr;
  }
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  Mesh mesh = Make();
  mesh->DeepCopy(reader->GetOutput());
  return mesh;
}
}

int TestAdaptiveRefinementMapperComputeLevels(int, char*[])
{
  RelevoCheck check;
  vtkNew<vtkRenderWindow> window;
  window->SetSize(32, 32);
  window->Render();
  if (!relevo::RefinementComputeProgram::IsSupported())
  {
    std::cout << "The context has no OpenGL 4.3: skipped." << std::endl;
    return 125;
  }
  vtkOpenGLRenderWindow* context = vtkOpenGLRenderWindow::SafeDownCast(window);
  const double offset[3] = { 1e6, 2e6, -3e6 };
  const std::pair<std::string, Mesh> meshes[] = { { "apart", Explode(Sphere(24, 20)) },
    { "far away", Moved(Sphere(24, 20), 1.0, offset, VTK_DOUBLE) }, { "sphere", Sphere(40, 30) },
    { "cube", Cube() }, { "terrain", MakeTerrain() }, { "bunny", ReadBunny() } };
  for (const auto& mesh : meshes)
  {
    if (!mesh.second)
    {
      continue;
    }
    Comparison comparison(check, context, mesh.second);
    for (const NamedMetric& metric : MakeMetrics(mesh.second->GetLength()))
    {
      for (int rule : { vtkDepthTagMetric::PER_VERTEX, vtkDepthTagMetric::PER_EDGE })
      {
        for (bool morphing : { false, true })
        {
          vtkNew<vtkAdaptiveRefinement> recipe;
          recipe->SetMaximumLevel(morphing ? 3 : 5);
          recipe->SetLevelRule(rule);
          recipe->SetLevelOffset(morphing ? 0.7 : 0.0);
          recipe->SetGeomorphing(morphing);
          recipe->SetMetric(metric.Metric);
          comparison.Compare(mesh.first + ", " + metric.Name + (rule ? " per edge" : "") +
              (morphing ? ", morphing" : ""),
            recipe);
        }
      }
    }
    CHECK_GREATER(comparison.MaximumGroups, 5);
    CHECK_GREATER_EQUAL(comparison.NumberOfShaders, 16); // four metrics, both rules, both families
  }
  return check.GetResult();
}
