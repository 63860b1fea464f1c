// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/PatchDeviations.h"

#include "Mesh/PatchArrays.h"
#include "Mesh/SurfaceEdges.h"
#include "Metrics/ChordDeviation.h"
#include "Metrics/DeviationBounds.h"
#include "Metrics/MetricMesh.h"
#include "Metrics/TriangleForm.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace relevo
{
namespace
{
// Returns the box of homogeneous points relative to an origin.
PointBox GetBox(const std::vector<dvec4>& points, const dvec3& origin)
{
  PointBox box{ dvec3(points[0]) / points[0].w, dvec3(points[0]) / points[0].w };
  for (const dvec4& point : points)
  {
    const dvec3 x = dvec3(point) / point.w;
    box.Low = min(box.Low, x);
    box.High = max(box.High, x);
  }
  return { box.Low + origin, box.High + origin };
}

bool ArePointsOf(vtkPolyData* mesh, vtkIdList* ids)
{
  return std::all_of(ids->begin(), ids->end(),
    [mesh](vtkIdType id) { return id >= 0 && id < mesh->GetNumberOfPoints(); });
}

// Returns homogeneous points relative to an origin. The weight is 0 if it is missing.
std::vector<dvec4> GetControlPoints(vtkPolyData* mesh, vtkIdList* ids, const dvec3& origin)
{
  vtkDataArray* weights = mesh->GetPointData()->GetRationalWeights();
  std::vector<dvec4> points;
  for (vtkIdType id : *ids)
  {
    dvec3 x;
    mesh->GetPoint(id, &x.x);
    const double given =
      weights && id < weights->GetNumberOfTuples() ? weights->GetComponent(id, 0) : 0.0;
    const double weight = weights ? given : 1.0;
    points.emplace_back((x - origin) * weight, weight);
  }
  return points;
}

bool IsFinite(const dvec4& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}
}

bool PatchDeviations::BuildFaces(MetricMesh& mesh, std::string& error)
{
  PatchArrays patches;
  if (!patches.Take(mesh.GetPolyData(), error))
  {
    return false;
  }
  std::vector<vtkIdType> cells;
  this->FindFaces(mesh, cells);
  std::vector<dvec3> chords(this->Faces.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(cells.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType f = begin; f < end; ++f)
      {
        const Patch patch = patches.GetPatch(patches.GetPatchId(cells[f]));
        dvec2 corners[3];
        for (int c = 0; c < 3; ++c)
        {
          corners[c] = dvec2(patches.GetCoordinates(cells[f], c));
        }
        const dvec3 origin(patches.GetPoint(patch.FirstPoint));
        const TriangleForm form(patches, patch, corners, origin);
        this->Faces[f].Form = ComputeDeviationForm(form);
        this->Faces[f].Box = GetBox(form.GetPoints(), origin);
        for (int c = 0; c < 3; ++c)
        {
          chords[f][c] = ComputeChordDeviation(form.GetEdge(c));
        }
      }
    });
  const int numberOfEdges = mesh.GetEdges()->GetNumberOfEdges();
  this->Chords.assign(static_cast<std::size_t>(numberOfEdges), 0.0);
  for (std::size_t f = 0; f < this->Faces.size(); ++f)
  {
    for (int c = 0; c < 3; ++c)
    {
      double& chord = this->Chords[this->Faces[f].Edges[c]];
      chord = std::max(chord, chords[f][c]);
    }
  }
  this->BuildUses(numberOfEdges);
  return true;
}

// Includes triangles with two coincident corners, which SurfaceTriangles omits.
void PatchDeviations::FindFaces(MetricMesh& mesh, std::vector<vtkIdType>& cells)
{
  const SurfaceEdges& edges = *mesh.GetEdges();
  const SurfaceTriangles& surface = edges.GetTriangles();
  vtkPolyData* data = mesh.GetPolyData();
  const vtkIdType first = data->GetNumberOfVerts() + data->GetNumberOfLines();
  this->Faces.clear();
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < data->GetNumberOfPolys(); ++i)
  {
    data->GetPolys()->GetCellAtId(i, ids);
    vtkIdType places[3];
    bool isValid = true;
    for (int c = 0; c < 3; ++c)
    {
      const vtkIdType id = ids->GetId(c);
      isValid = isValid && id >= 0 && id < surface.GetNumberOfPoints();
      places[c] = isValid ? surface.GetMergedPoint(id) : 0;
    }
    FaceDeviation face;
    for (int c = 0; c < 3 && isValid; ++c)
    {
      const vtkIdType a = places[(c + 1) % 3];
      const vtkIdType b = places[(c + 2) % 3];
      face.Edges[c] = edges.FindEdge(a, a != b ? b : places[c]);
      isValid = face.Edges[c] >= 0;
    }
    if (isValid)
    {
      this->Faces.push_back(face);
      cells.push_back(first + i);
    }
  }
}

void PatchDeviations::BuildUses(int numberOfEdges)
{
  this->Starts.assign(static_cast<std::size_t>(numberOfEdges) + 1, 0);
  for (const FaceDeviation& face : this->Faces)
  {
    for (int edge : face.Edges)
    {
      ++this->Starts[edge + 1];
    }
  }
  for (int edge = 0; edge < numberOfEdges; ++edge)
  {
    this->Starts[edge + 1] += this->Starts[edge];
  }
  this->Uses.resize(3 * this->Faces.size());
  std::vector<int> next(this->Starts.begin(), this->Starts.end() - 1);
  for (std::size_t f = 0; f < this->Faces.size(); ++f)
  {
    for (int edge : this->Faces[f].Edges)
    {
      this->Uses[next[edge]++] = static_cast<int>(f);
    }
  }
}

bool PatchDeviations::BuildCurves(vtkPolyData* mesh, std::string& error)
{
  this->Curves.clear();
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < mesh->GetNumberOfLines(); ++line)
  {
    mesh->GetLines()->GetCellAtId(line, ids);
    const vtkIdType size = ids->GetNumberOfIds();
    if (size > LargestDegree + 1)
    {
      std::ostringstream text;
      text << "line " << line << " has " << size
           << " points, but the control polygon of a curve must have 2 to " << LargestDegree + 1;
      error = text.str();
      return false;
    }
    if (size < 2 || !ArePointsOf(mesh, ids))
    {
      continue;
    }
    dvec3 origin;
    mesh->GetPoint(ids->GetId(0), &origin.x);
    const std::vector<dvec4> points = GetControlPoints(mesh, ids, origin);
    if (std::all_of(points.begin(), points.end(),
          [](const dvec4& point) { return IsFinite(point) && point.w > 0.0; }))
    {
      this->Curves.push_back({ ComputeChordDeviation(points), GetBox(points, origin), line });
    }
  }
  return true;
}
}
