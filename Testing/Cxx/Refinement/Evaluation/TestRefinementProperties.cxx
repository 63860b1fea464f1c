// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// What holds for any mesh, camera, metric and recipe, in 100000 random cases: the refined faces of
// an edge have the same points on it, to the bit; all points are finite; no edge has fewer segments
// when tags are higher, nor others with geomorphing; and what fails says so and leaves nothing.
// Meshes are tiny and bad: faces in all directions, more than two at an edge, degenerate ones,
// points at one place, on a line, at infinity.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCamera.h"
#include "vtkCompositeDepthTagMetric.h"
#include "vtkCurvatureDepthTagMetric.h"
#include "vtkDisplacement.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkExecutive.h"
#include "vtkFieldVariationDepthTagMetric.h"
#include "vtkLinearSurface.h"
#include "vtkPNTriangleSurface.h"
#include "vtkRegionDepthTagMetric.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkSilhouetteDepthTagMetric.h"
#include "vtkViewDependentDepthTagMetric.h"

#include <algorithm>
#include <cstring>
#include <iostream>
#include <limits>

using namespace RelevoMeshes;

namespace
{
constexpr int NumberOfCases = 100000;

using Point = std::array<double, 3>;
using Chain = std::vector<Point>;
// Points along the edges of a coarse mesh, by their places, from the first to the second.
using Edges = std::map<std::pair<vtkIdType, vtkIdType>, Chain>;

class Dice
{
public:
  explicit Dice(unsigned int seed)
    : Engine(seed)
  {
  }
  // 0 to n - 1.
  int Choose(int n) { return static_cast<int>(this->Engine() % static_cast<unsigned int>(n)); }
  // One time in n.
  bool Once(int n) { return this->Choose(n) == 0; }
  double Between(double low, double high)
  {
    return low + (high - low) * (this->Engine() / 4294967296.0);
  }
  // From low to high, as likely small as large.
  double Scale(double low, double high)
  {
    return std::exp(this->Between(std::log(low), std::log(high)));
  }

private:
  std::mt19937 Engine;
};

Point RandomPoint(Dice& dice, bool onLattice)
{
  Point point;
  for (double& x : point)
  {
    x = onLattice ? dice.Choose(3) - 1.0 : dice.Between(-1.0, 1.0);
    x = x == 0.0 && dice.Once(2) ? -0.0 : x;
  }
  if (dice.Once(100))
  {
    point[dice.Choose(3)] = dice.Once(2) ? std::numeric_limits<double>::quiet_NaN()
                                         : -std::numeric_limits<double>::infinity();
  }
  return point;
}

vtkSmartPointer<vtkFloatArray> RandomArray(
  Dice& dice, const char* name, vtkIdType size, double low, double high, int oneNaNIn)
{
  vtkSmartPointer<vtkFloatArray> array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  for (vtkIdType i = 0; i < size; ++i)
  {
    array->InsertNextValue(dice.Once(oneNaNIn) ? std::numeric_limits<float>::quiet_NaN()
                                               : static_cast<float>(dice.Between(low, high)));
  }
  return array;
}

// Faces between some points. Either they share these, or each has points of its own there, so that
// their edges meet by place alone.
Mesh RandomFaces(Dice& dice)
{
  const bool onLattice = dice.Once(2);
  std::vector<Point> corners;
  for (int i = 3 + dice.Choose(6); i > 0; --i)
  {
    corners.push_back(RandomPoint(dice, onLattice));
  }
  const int numberOfCorners = static_cast<int>(corners.size());
  const bool shared = dice.Once(2);
  std::vector<Point> points;
  if (shared)
  {
    points = corners;
  }
  std::vector<Triangle> triangles;
  for (int i = 1 + dice.Choose(6); i > 0; --i)
  {
    Triangle triangle;
    for (vtkIdType& id : triangle)
    {
      id = dice.Choose(numberOfCorners);
      if (!shared)
      {
        points.push_back(corners[static_cast<size_t>(id)]);
        id = static_cast<vtkIdType>(points.size()) - 1;
      }
    }
    triangles.push_back(triangle);
  }
  return FromTriangles(points, triangles);
}

// "Corner" tells the points of the mesh from all that refinement adds.
Mesh RandomMesh(Dice& dice)
{
  const double none[3] = { 0.0, 0.0, 0.0 };
  Mesh mesh = Moved(RandomFaces(dice), 1.0, none, dice.Once(3) ? VTK_DOUBLE : VTK_FLOAT);
  const vtkIdType numberOfPoints = mesh->GetNumberOfPoints();
  vtkPointData* data = mesh->GetPointData();
  constexpr int Never = std::numeric_limits<int>::max();
  data->AddArray(RandomArray(dice, "Corner", numberOfPoints, 0.0, 1.0, Never));
  data->AddArray(RandomArray(dice, "Field", numberOfPoints, -1.0, 1.0, 20));
  if (dice.Once(3))
  {
    data->AddArray(RandomArray(dice, "DepthTag", numberOfPoints, -2.0, 6.0, 500));
  }
  AddRandomTextureCoordinates(mesh, static_cast<unsigned int>(dice.Choose(1000)));
  if (dice.Once(3))
  {
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < numberOfPoints; ++i)
    {
      double normal[3] = { dice.Between(-1.0, 1.0), dice.Between(-1.0, 1.0),
        dice.Between(-1.0, 1.0) };
      vtkMath::Normalize(normal);
      normals->InsertNextTuple(normal);
    }
    data->SetNormals(normals);
  }
  return mesh;
}

// A filter whose recipe, camera and input are set at random, again and again.
class Machine
{
public:
  Machine()
  {
    this->Heights->FillRandom(13, 9, 1);
    this->Displacement->SetHeightMap(this->Heights);
    this->Variation->SetArrayName("Field");
    this->Region->SetCenter(0.3, 0.1, -0.2);
    this->Composite->AddMetric(this->ScreenEdge);
    this->Composite->AddMetric(this->Distance);
    this->LinearNormals->QuadraticNormalsOff();
    this->Filter->SetRefinement(this->Recipe);
    this->Filter->SetCamera(this->Camera);
    for (vtkObject* object : std::initializer_list<vtkObject*>{ this->Filter,
           this->Filter->GetExecutive(), this->ScreenEdge, this->Distance, this->Silhouette,
           this->ViewDependent, this->Region, this->Variation, this->Curvature, this->Composite })
    {
      object->AddObserver(vtkCommand::ErrorEvent, this->Observer);
      object->AddObserver(vtkCommand::WarningEvent, this->Observer);
    }
  }

  void Shuffle(Dice& dice)
  {
    this->ShuffleMetrics(dice);
    this->ShuffleRecipe(dice);
    this->Input = RandomMesh(dice);
    this->ShuffleCamera(dice);
    this->Filter->SetInputData(this->Input);
    this->Filter->SetViewportSize(1 + dice.Choose(2000), 1 + dice.Choose(2000));
  }

  // Whether it worked.
  bool Run()
  {
    this->Observer->Clear();
    this->Filter->Update();
    return !this->Observer->GetError();
  }

  vtkNew<vtkAdaptiveRefinement> Recipe;
  vtkNew<vtkAdaptiveRefinementFilter> Filter;
  vtkNew<vtkScreenEdgeDepthTagMetric> ScreenEdge;
  Mesh Input;

private:
  void ShuffleMetrics(Dice& dice)
  {
    this->ScreenEdge->SetReferenceLength(dice.Scale(0.5, 500.0));
    this->Distance->SetMaximumDistance(dice.Scale(0.1, 10.0));
    this->Silhouette->SetCriterion(dice.Choose(2));
    this->ViewDependent->SetEdgeOnWeight(dice.Between(0.0, 1.0));
    this->Region->SetRadius(dice.Between(0.1, 2.0));
    this->Region->SetFallOff(dice.Between(0.0, 2.0));
    this->Composite->SetMode(dice.Choose(3));
    const std::array<vtkDepthTagMetric*, 9> metrics = { this->ScreenEdge, this->ScreenEdge,
      this->Distance, this->Silhouette, this->ViewDependent, this->Region, this->Variation,
      this->Curvature, this->Composite };
    this->Recipe->SetMetric(dice.Once(12) ? nullptr : metrics[static_cast<size_t>(dice.Choose(9))]);
  }

  void ShuffleRecipe(Dice& dice)
  {
    this->Recipe->SetMaximumLevel(dice.Once(200) ? dice.Choose(8) : dice.Choose(5));
    this->Recipe->SetLevelRule(dice.Choose(2));
    this->Recipe->SetLevelOffset(dice.Once(2) ? 0.0 : dice.Between(-2.0, 2.0));
    this->Recipe->SetSegmentPolicy(
      dice.Once(3) ? vtkAdaptiveRefinement::WHOLE_NUMBERS : vtkAdaptiveRefinement::POWERS_OF_TWO);
    this->Recipe->SetGeomorphing(dice.Choose(3));
    const std::array<vtkRefinementSurface*, 4> surfaces = { nullptr, this->Linear, this->Quadratic,
      this->LinearNormals };
    this->Recipe->SetSurface(surfaces[static_cast<size_t>(dice.Choose(4))]);
    this->Displacement->SetScale(dice.Between(-0.5, 0.5));
    if (dice.Once(2))
    {
      this->Displacement->SetDirectionToNormal();
    }
    else
    {
      this->Displacement->SetDirection(0.3, -1.0, 2.0);
    }
    this->Recipe->SetDisplacement(dice.Once(2) ? this->Displacement.Get() : nullptr);
  }

  void ShuffleCamera(Dice& dice)
  {
    double eye[3];
    double focus[3];
    for (int c = 0; c < 3; ++c)
    {
      eye[c] = dice.Between(-3.0, 3.0);
      focus[c] = dice.Between(-1.0, 1.0);
    }
    if (dice.Once(10)) // on a point of the mesh
    {
      this->Input->GetPoint(dice.Choose(3), eye);
    }
    this->Camera->SetPosition(eye);
    this->Camera->SetFocalPoint(dice.Once(50) ? eye : focus);
    this->Camera->SetViewUp(dice.Between(-1.0, 1.0), 1.0, dice.Between(-1.0, 1.0));
    this->Camera->SetParallelProjection(dice.Once(3));
    this->Camera->SetParallelScale(dice.Scale(0.01, 100.0));
    this->Camera->SetViewAngle(dice.Between(1.0, 170.0));
    const double nearest = dice.Scale(1e-3, 2.0);
    this->Camera->SetClippingRange(nearest, nearest * dice.Scale(1.1, 1000.0));
  }

  vtkNew<vtkTest::ErrorObserver> Observer;
  vtkNew<vtkCamera> Camera;
  vtkNew<RelevoHeights> Heights;
  vtkNew<vtkDisplacement> Displacement;
  vtkNew<vtkLinearSurface> Linear;
  vtkNew<vtkPNTriangleSurface> Quadratic;
  vtkNew<vtkPNTriangleSurface> LinearNormals;
  vtkNew<vtkDistanceDepthTagMetric> Distance;
  vtkNew<vtkSilhouetteDepthTagMetric> Silhouette;
  vtkNew<vtkViewDependentDepthTagMetric> ViewDependent;
  vtkNew<vtkRegionDepthTagMetric> Region;
  vtkNew<vtkFieldVariationDepthTagMetric> Variation;
  vtkNew<vtkCurvatureDepthTagMetric> Curvature;
  vtkNew<vtkCompositeDepthTagMetric> Composite;
};

Point GetPoint(vtkPolyData* mesh, vtkIdType id)
{
  Point point;
  mesh->GetPoint(id, point.data());
  return point;
}

bool IsFinite(const Point& point)
{
  return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}

// The lowest id of the points at the place of each.
std::vector<vtkIdType> GetPlaces(vtkPolyData* mesh)
{
  std::vector<vtkIdType> places;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    vtkIdType place = 0;
    while (place < i && GetPoint(mesh, place) != GetPoint(mesh, i))
    {
      ++place;
    }
    places.push_back(place);
  }
  return places;
}

// Where each point of a face's border leads to. Empty unless every other side of its triangles is
// used once in each direction.
std::map<vtkIdType, vtkIdType> GetBorder(const std::vector<Triangle>& triangles)
{
  std::vector<std::pair<vtkIdType, vtkIdType>> sides;
  for (const Triangle& triangle : triangles)
  {
    for (size_t i = 0; i < 3; ++i)
    {
      sides.push_back({ triangle[i], triangle[(i + 1) % 3] });
    }
  }
  std::sort(sides.begin(), sides.end());
  std::map<vtkIdType, vtkIdType> border;
  bool once = std::adjacent_find(sides.begin(), sides.end()) == sides.end();
  for (const auto& [a, b] : sides)
  {
    if (!std::binary_search(sides.begin(), sides.end(), std::make_pair(b, a)))
    {
      once = once && border.emplace(a, b).second;
    }
  }
  return once ? border : std::map<vtkIdType, vtkIdType>();
}

bool IsSame(const Chain& a, const Chain& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Point)) == 0;
}

// Reads the edges of the coarse mesh off the refined one. Returns what is wrong with them.
class EdgeReader
{
public:
  EdgeReader(vtkPolyData* coarse, vtkPolyData* fine)
    : Coarse(coarse)
    , Fine(fine)
    , Places(GetPlaces(coarse))
  {
  }

  std::string Read(Edges& edges)
  {
    std::vector<std::vector<Triangle>> faces(static_cast<size_t>(this->Coarse->GetNumberOfCells()));
    vtkDataArray* cells = this->Fine->GetCellData()->GetArray("vtkOriginalCellIds");
    vtkIdType size;
    const vtkIdType* ids;
    for (vtkIdType t = 0; t < this->Fine->GetNumberOfCells(); ++t)
    {
      this->Fine->GetCellPoints(t, size, ids);
      faces[static_cast<size_t>(cells->GetComponent(t, 0))].push_back({ ids[0], ids[1], ids[2] });
      for (vtkIdType i = 0; i < size; ++i)
      {
        if (!IsFinite(GetPoint(this->Fine, ids[i])))
        {
          return "a point is not finite";
        }
      }
    }
    for (size_t face = 0; face < faces.size(); ++face)
    {
      this->Coarse->GetCellPoints(static_cast<vtkIdType>(face), size, ids);
      const std::string fault = this->IsProper(ids)
        ? this->ReadFace(ids, faces[face], edges)
        : std::string(faces[face].empty() ? "" : "a degenerate face was refined");
      if (!fault.empty())
      {
        return "face " + std::to_string(face) + ": " + fault;
      }
    }
    return {};
  }

private:
  bool IsProper(const vtkIdType* ids)
  {
    const auto& p = this->Places;
    return p[ids[0]] != p[ids[1]] && p[ids[1]] != p[ids[2]] && p[ids[2]] != p[ids[0]] &&
      std::all_of(
        ids, ids + 3, [this](vtkIdType id) { return IsFinite(GetPoint(this->Coarse, id)); });
  }

  std::string ReadFace(
    const vtkIdType* corners, const std::vector<Triangle>& triangles, Edges& edges)
  {
    const std::map<vtkIdType, vtkIdType> border = GetBorder(triangles);
    if (border.empty())
    {
      return "it is missing, or its triangles do not fit together";
    }
    size_t length = 0;
    for (int e = 0; e < 3; ++e)
    {
      const vtkIdType from = corners[e];
      const vtkIdType to = corners[(e + 1) % 3];
      Chain chain;
      if (!this->Follow(border, from, to, chain))
      {
        return "an edge does not lead from corner to corner";
      }
      length += chain.size() - 1;
      std::pair<vtkIdType, vtkIdType> key(this->Places[from], this->Places[to]);
      if (key.first > key.second)
      {
        std::swap(key.first, key.second);
        std::reverse(chain.begin(), chain.end());
      }
      if (!IsSame(chain, edges.emplace(key, chain).first->second))
      {
        return "an edge is not that of another face";
      }
    }
    return length == border.size() ? "" : "its border has more than three edges";
  }

  bool Follow(
    const std::map<vtkIdType, vtkIdType>& border, vtkIdType from, vtkIdType to, Chain& chain)
  {
    vtkIdType here = this->FindCorner(border, from);
    const vtkIdType end = this->FindCorner(border, to);
    if (here < 0 || end < 0)
    {
      return false;
    }
    chain.push_back(GetPoint(this->Fine, here));
    while (here != end && chain.size() <= border.size())
    {
      here = border.at(here);
      chain.push_back(GetPoint(this->Fine, here));
    }
    return here == end;
  }

  // The coarse point on the border, -1 if it is not there. It comes before those that refinement
  // adds, of which some may lie on it.
  vtkIdType FindCorner(const std::map<vtkIdType, vtkIdType>& border, vtkIdType coarse)
  {
    vtkDataArray* fineCorners = this->Fine->GetPointData()->GetArray("Corner");
    const double corner = this->Coarse->GetPointData()->GetArray("Corner")->GetComponent(coarse, 0);
    const auto found = std::find_if(border.begin(), border.end(),
      [&](const auto& side) { return fineCorners->GetComponent(side.first, 0) == corner; });
    return found == border.end() ? -1 : found->first;
  }

  vtkPolyData* Coarse;
  vtkPolyData* Fine;
  std::vector<vtkIdType> Places;
};

// Whether every edge has at least the segments that it had; exactly them if `same`.
bool AreNoFewer(const Edges& before, const Edges& after, bool same)
{
  return before.size() == after.size() &&
    std::all_of(before.begin(), before.end(),
      [&](const auto& edge)
      {
        const auto found = after.find(edge.first);
        return found != after.end() &&
          (same ? found->second.size() == edge.second.size()
                : found->second.size() >= edge.second.size());
      });
}

std::string CheckSegments(const Edges& edges, vtkAdaptiveRefinement* recipe)
{
  const bool whole = recipe->GetSegmentPolicy() == vtkAdaptiveRefinement::WHOLE_NUMBERS;
  for (const auto& edge : edges)
  {
    const size_t segments = edge.second.size() - 1;
    if (segments > size_t(1) << recipe->GetMaximumLevel() ||
      (!whole && (segments & (segments - 1)) != 0))
    {
      return "an edge has " + std::to_string(segments) + " segments";
    }
  }
  return {};
}

// One case with a change for which there is a rule. Returns what is wrong.
std::string CheckChange(Machine& machine, Dice& dice, const Edges& before)
{
  bool same = false;
  switch (dice.Choose(3))
  {
    case 0:
      machine.Recipe->SetLevelOffset(machine.Recipe->GetLevelOffset() + dice.Between(0.0, 1.5));
      break;
    case 1:
      machine.ScreenEdge->SetReferenceLength(
        dice.Between(0.3, 1.0) * machine.ScreenEdge->GetReferenceLength());
      break;
    default:
      machine.Recipe->SetGeomorphing(machine.Recipe->GetGeomorphing() == 0 ? 1 : 0);
      same = true;
      break;
  }
  if (!machine.Run())
  {
    return "it fails after a change";
  }
  Edges after;
  const std::string fault = EdgeReader(machine.Input, machine.Filter->GetOutput()).Read(after);
  if (!fault.empty())
  {
    return fault;
  }
  return AreNoFewer(before, after, same) ? "" : "an edge has other segments than it should";
}
}

int TestRefinementProperties(int, char*[])
{
  RelevoCheck check;
  Machine machine;
  int numberOfFailures = 0;
  vtkIdType numberOfTriangles = 0;
  for (int i = 0; i < NumberOfCases; ++i)
  {
    Dice dice(static_cast<unsigned int>(i));
    machine.Shuffle(dice);
    std::string fault;
    vtkPolyData* output = machine.Filter->GetOutput();
    if (machine.Run())
    {
      numberOfTriangles += output->GetNumberOfCells();
      Edges edges;
      fault = EdgeReader(machine.Input, output).Read(edges);
      if (fault.empty())
      {
        fault = CheckSegments(edges, machine.Recipe);
      }
      if (fault.empty() && i % 3 == 0)
      {
        fault = CheckChange(machine, dice, edges);
      }
    }
    else
    {
      ++numberOfFailures;
      fault = output->GetNumberOfPoints() + output->GetNumberOfCells() == 0 ? "" : "output left";
    }
    if (!fault.empty())
    {
      check.Fail(__FILE__, __LINE__, "case " + std::to_string(i) + ": " + fault);
    }
  }
  std::cout << numberOfTriangles << " triangles; " << numberOfFailures << " cases refused\n";
  CHECK(numberOfTriangles > 10 * NumberOfCases);
  CHECK(numberOfFailures > 0 && numberOfFailures < NumberOfCases / 10);
  return check.GetResult();
}
