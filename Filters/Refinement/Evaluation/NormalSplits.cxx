// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/NormalSplits.h"

#include "Evaluation/RefinedTopology.h"
#include "Evaluation/RefinementEvaluator.h"
#include "Mesh/NormalGroups.h"
#include "Mesh/RefinementMesh.h"
#include "vtkRefinementSurface.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace relevo
{
namespace
{
constexpr float NormalTolerance = 1e-3f;

// Orders normals. Zero vectors come last, because they are no normals.
bool IsLess(const vec3& a, const vec3& b)
{
  const auto key = [](const vec3& n) { return std::make_tuple(n == vec3(0.0f), n.x, n.y, n.z); };
  return key(a) < key(b);
}

// The uses of points or edges by faces, sorted by element.
class Uses
{
public:
  // Collects the uses of the marked elements. `getElement` returns the element of a use.
  template <typename GetElement>
  Uses(const std::vector<char>& marks, size_t numberOfUses, const GetElement& getElement)
    : Starts(marks.size() + 1, 0)
  {
    for (size_t use = 0; use < numberOfUses; ++use)
    {
      const size_t element = getElement(use);
      this->Starts[element + 1] += marks[element];
    }
    for (size_t element = 0; element < marks.size(); ++element)
    {
      this->Starts[element + 1] += this->Starts[element];
    }
    this->All.resize(this->Starts.back());
    std::vector<size_t> next(this->Starts.begin(), this->Starts.end() - 1);
    for (size_t use = 0; use < numberOfUses; ++use)
    {
      const size_t element = getElement(use);
      if (marks[element])
      {
        this->All[next[element]++] = static_cast<int>(use);
      }
    }
  }

  size_t GetNumberOfElements() const { return this->Starts.size() - 1; }
  size_t GetNumberOfUses(size_t element) const
  {
    return this->Starts[element + 1] - this->Starts[element];
  }
  const int* GetUses(size_t element) const { return this->All.data() + this->Starts[element]; }

private:
  std::vector<size_t> Starts;
  std::vector<int> All;
};
}

// Processes one element at a time.
class NormalSplits::Visitor
{
public:
  Visitor() = default;
  Visitor(const RefinedTopology& topology, const RefinementEvaluator& evaluator,
    std::vector<Value>& values)
    : Topology(&topology)
    , Evaluator(&evaluator)
    , Values(&values)
  {
  }

  void VisitPoint(vtkIdType point, const int* uses, size_t numberOfUses)
  {
    this->Evaluate(uses, numberOfUses, { 0 });
    const size_t owner = this->FindOwner(numberOfUses);
    this->Points.PointOwners.push_back({ static_cast<int>(point), uses[owner] });
    this->Keep(point, 0, owner);
    if (!this->IsSmooth())
    {
      this->Divide(uses, owner, 0, this->Rows[0], point);
    }
  }

  void VisitEdge(int edge, const int* uses, size_t numberOfUses)
  {
    const int segments = this->Topology->GetNumberOfInnerPoints(uses[0]) + 1;
    if (segments < 2)
    {
      return;
    }
    // Creases are rare, and a few points are enough to exclude one.
    constexpr int samples = 3;
    std::vector<int>& steps = this->Steps;
    steps.clear();
    for (int i = 1; segments > samples + 1 && i <= samples; ++i)
    {
      steps.push_back(segments * i / (samples + 1));
    }
    bool isSmooth = !steps.empty();
    if (isSmooth)
    {
      this->Evaluate(uses, numberOfUses, steps);
      isSmooth = this->IsSmooth();
    }
    if (!isSmooth)
    {
      steps.resize(static_cast<size_t>(segments) - 1);
      std::iota(steps.begin(), steps.end(), 1);
      this->Evaluate(uses, numberOfUses, steps);
      isSmooth = this->IsSmooth();
    }
    const size_t owner = this->FindOwner(numberOfUses);
    this->Points.EdgeOwners.push_back({ edge, uses[owner] });
    for (size_t k = 0; k < steps.size(); ++k)
    {
      const vtkIdType point = this->Topology->GetEdgePoint(edge, steps[k]);
      this->Keep(point, k, owner);
      if (!isSmooth)
      {
        this->Divide(uses, owner, steps[k], this->Rows[k], point);
      }
    }
  }

  SplitPoints Points;

private:
  // Evaluates the normals of all uses, one row per step.
  void Evaluate(const int* uses, size_t numberOfUses, const std::vector<int>& steps)
  {
    this->Rows.resize(steps.size());
    this->Positions.resize(steps.size());
    for (size_t k = 0; k < steps.size(); ++k)
    {
      this->Rows[k].resize(numberOfUses);
      this->Positions[k].resize(numberOfUses);
      for (size_t u = 0; u < numberOfUses; ++u)
      {
        float weights[3];
        vec3& normal = this->Rows[k][u];
        this->Topology->GetWeights(uses[u], steps[k], weights);
        this->Evaluator->Evaluate(uses[u] / 3, weights, &this->Positions[k][u].x, &normal.x);
        if (!std::isfinite(normal.x + normal.y + normal.z))
        {
          normal = vec3(0.0f);
        }
      }
    }
  }

  // Whether the normals of all uses match in each row.
  bool IsSmooth()
  {
    return std::all_of(this->Rows.begin(), this->Rows.end(),
      [this](const std::vector<vec3>& row)
      {
        GroupNormals(row, NormalTolerance, this->Groups);
        return std::all_of(
          this->Groups.begin(), this->Groups.end(), [](vtkIdType group) { return group == 0; });
      });
  }

  // Returns the use with the lowest sequence of normals.
  size_t FindOwner(size_t numberOfUses) const
  {
    const auto isLess = [this](size_t a, size_t b)
    {
      for (const std::vector<vec3>& row : this->Rows)
      {
        if (row[a] != row[b])
        {
          return IsLess(row[a], row[b]);
        }
      }
      return false;
    };
    size_t owner = 0;
    for (size_t u = 1; u < numberOfUses; ++u)
    {
      owner = isLess(u, owner) ? u : owner;
    }
    return owner;
  }

  // Each point is visited once, so that threads do not conflict. Non-finite normals, which are 0
  // here, are evaluated again later.
  void Keep(vtkIdType point, size_t row, size_t owner)
  {
    const vec3& normal = this->Rows[row][owner];
    if (normal != vec3(0.0f))
    {
      (*this->Values)[static_cast<size_t>(point)] = { this->Positions[row][owner], normal, true };
    }
  }

  // Adds copies for the uses whose normals do not match the owner's.
  void Divide(
    const int* uses, size_t owner, int step, const std::vector<vec3>& normals, vtkIdType point)
  {
    GroupNormals(normals, NormalTolerance, this->Groups);
    this->Least = normals;
    for (size_t u = 0; u < normals.size(); ++u)
    {
      vec3& least = this->Least[static_cast<size_t>(this->Groups[u])];
      least = IsLess(normals[u], least) ? normals[u] : least;
    }
    for (size_t u = 0; u < normals.size(); ++u)
    {
      // A face without a normal uses the owner's.
      if (this->Groups[u] != this->Groups[owner] && normals[u] != vec3(0.0f))
      {
        this->Points.Copies.push_back(
          { point, uses[u], step, this->Least[static_cast<size_t>(this->Groups[u])] });
      }
    }
  }

  const RefinedTopology* Topology = nullptr;
  const RefinementEvaluator* Evaluator = nullptr;
  std::vector<Value>* Values = nullptr;
  std::vector<int> Steps;
  std::vector<std::vector<vec3>> Rows;
  std::vector<std::vector<vec3>> Positions; // one row per step
  std::vector<vtkIdType> Groups;
  std::vector<vec3> Least;
};

NormalSplits::NormalSplits(const RefinementMesh& mesh, vtkRefinementSurface* surface,
  const RefinementEvaluator& evaluator, const RefinedTopology& topology,
  vtkIdType numberOfInputPoints)
{
  std::vector<char> isSplitPoint(static_cast<size_t>(numberOfInputPoints), 0);
  std::vector<char> isSplitEdge(mesh.EdgeOwners.size(), 0);
  bool any = false;
  for (size_t f = 0; surface && f < mesh.Faces.size(); ++f)
  {
    if (surface->SplitsNormals(mesh.GetSurfaceFace(static_cast<int>(f))))
    {
      any = true;
      for (size_t i = 0; i < 3; ++i)
      {
        isSplitPoint[static_cast<size_t>(mesh.Faces[f].Corners[i])] = 1;
        isSplitEdge[static_cast<size_t>(mesh.FaceEdges[3 * f + i])] = 1;
      }
    }
  }
  if (!any)
  {
    return;
  }
  const size_t numberOfUses = 3 * mesh.Faces.size();
  const Uses points(isSplitPoint, numberOfUses,
    [&](size_t use) { return static_cast<size_t>(mesh.Faces[use / 3].Corners[use % 3]); });
  const Uses edges(isSplitEdge, numberOfUses,
    [&](size_t use) { return static_cast<size_t>(mesh.FaceEdges[use]); });
  this->Values.resize(static_cast<size_t>(topology.GetNumberOfPoints()));
  vtkSMPThreadLocal<Visitor> visitors(Visitor(topology, evaluator, this->Values));
  const auto visit = [&](const Uses& elements, const auto& visitOne)
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(elements.GetNumberOfElements()),
      [&](vtkIdType begin, vtkIdType end)
      {
        Visitor& visitor = visitors.Local();
        for (vtkIdType i = begin; i < end; ++i)
        {
          const size_t element = static_cast<size_t>(i);
          const size_t number = elements.GetNumberOfUses(element);
          if (number > 1)
          {
            visitOne(visitor, i, elements.GetUses(element), number);
          }
        }
      });
  };
  visit(points,
    [](Visitor& visitor, vtkIdType point, const int* uses, size_t number)
    { visitor.VisitPoint(point, uses, number); });
  visit(edges,
    [](Visitor& visitor, vtkIdType edge, const int* uses, size_t number)
    { visitor.VisitEdge(static_cast<int>(edge), uses, number); });
  for (const Visitor& visitor : visitors)
  {
    const auto append = [](auto& to, const auto& from)
    { to.insert(to.end(), from.begin(), from.end()); };
    append(this->Points.Copies, visitor.Points.Copies);
    append(this->Points.PointOwners, visitor.Points.PointOwners);
    append(this->Points.EdgeOwners, visitor.Points.EdgeOwners);
  }
  std::sort(this->Points.Copies.begin(), this->Points.Copies.end(),
    [](const SplitPoints::Copy& l, const SplitPoints::Copy& r)
    { return std::tie(l.Point, l.Use) < std::tie(r.Point, r.Use); });
}
}
