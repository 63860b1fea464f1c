// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/CurveFrames.h"

#include "Curves/CurveEvaluator.h"
#include "Curves/CurveMesh.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace relevo
{
namespace
{
constexpr int MaximumIntervals = 16; // More intervals only help at cusps, which have no smooth
                                     // frame anyway.
constexpr int SamplesOfInterval = 8;
// Cosine of half the largest angle between joined tangents.
constexpr double SharpestJoint = 0.25;

// Returns any perpendicular unit vector.
dvec3 FindPerpendicular(const dvec3& v)
{
  const dvec3 size = abs(v);
  const double least = std::min({ size.x, size.y, size.z });
  const dvec3 axis = size.x == least
    ? dvec3(1.0, 0.0, 0.0)
    : (size.y == least ? dvec3(0.0, 1.0, 0.0) : dvec3(0.0, 0.0, 1.0));
  return normalize(axis - dot(axis, v) * v);
}

// Whether the tangent within each interval stays within a right angle of the tangent at its start.
bool AreIntervalsShort(CurveEvaluator& curve, int intervals)
{
  for (int station = 0; station < intervals; ++station)
  {
    const double start = static_cast<double>(station) / intervals;
    const dvec3 first = curve.curveTangent(curve.curveLine(start), start);
    for (int i = 1; i <= SamplesOfInterval; ++i)
    {
      const double t = start + static_cast<double>(i) / (SamplesOfInterval * intervals);
      if (dot(curve.curveTangent(curve.curveLine(t), t), first) < 0.0)
      {
        return false;
      }
    }
  }
  return true;
}

int CountIntervals(CurveEvaluator& curve)
{
  int intervals = 1;
  while (
    curve.curveDegree() > 1 && intervals < MaximumIntervals && !AreIntervalsShort(curve, intervals))
  {
    intervals *= 2;
  }
  return intervals;
}
}

// The predecessor and successor of each curve.
struct CurveFrames::Joints
{
  static constexpr vtkIdType None = -1;
  std::vector<vtkIdType> Next;
  std::vector<vtkIdType> Last;

  explicit Joints(const CurveMesh& mesh)
    : Next(mesh.GetNumberOfCurves(), None)
    , Last(mesh.GetNumberOfCurves(), None)
  {
    struct Ends
    {
      int NumberOfStarts = 0;
      int NumberOfEnds = 0;
      vtkIdType Start = None;
      vtkIdType End = None;
    };
    std::unordered_map<vtkIdType, Ends> all;
    all.reserve(this->Next.size() + 1);
    for (vtkIdType c = 0; c < mesh.GetNumberOfCurves(); ++c)
    {
      const CurveMesh::Curve& curve = mesh.GetCurves()[c];
      Ends& start = all[mesh.GetNodes()[curve.FirstPoint]];
      ++start.NumberOfStarts;
      start.Start = c;
      Ends& end = all[mesh.GetNodes()[curve.FirstPoint + curve.Degree]];
      ++end.NumberOfEnds;
      end.End = c;
    }
    for (const auto& [node, ends] : all)
    {
      if (ends.NumberOfStarts == 1 && ends.NumberOfEnds == 1)
      {
        this->Next[ends.End] = ends.Start;
        this->Last[ends.Start] = ends.End;
      }
    }
  }
};

void CurveFrames::Build(const CurveMesh& mesh)
{
  Joints joints(mesh);
  this->FindStations(mesh);
  this->JoinTangents(mesh, joints);
  this->FollowNormals(mesh, joints);
}

void CurveFrames::FindStations(const CurveMesh& mesh)
{
  const vtkIdType number = mesh.GetNumberOfCurves();
  this->AllStations.resize(number);
  vtkSMPTools::For(0, number,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType c = begin; c < end; ++c)
      {
        CurveEvaluator curve(mesh, c);
        this->AllStations[c] = { 0, CountIntervals(curve), true, true };
      }
    });
  vtkIdType next = 0;
  for (Stations& stations : this->AllStations)
  {
    stations.First = next;
    next += stations.Intervals + 1;
  }
  this->Tangents.resize(next);
  this->Normals.resize(next);
  vtkSMPTools::For(0, number,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType c = begin; c < end; ++c)
      {
        CurveEvaluator curve(mesh, c);
        const Stations& stations = this->AllStations[c];
        for (int k = 0; k <= stations.Intervals; ++k)
        {
          const double t = static_cast<double>(k) / stations.Intervals;
          this->Tangents[stations.First + k] = curve.curveTangent(curve.curveLine(t), t);
        }
      }
    });
}

void CurveFrames::JoinTangents(const CurveMesh& mesh, Joints& joints)
{
  for (vtkIdType c = 0; c < mesh.GetNumberOfCurves(); ++c)
  {
    const vtkIdType next = joints.Next[c];
    if (next == Joints::None)
    {
      continue;
    }
    dvec3& end = this->Tangents[this->AllStations[c].First + this->AllStations[c].Intervals];
    dvec3& start = this->Tangents[this->AllStations[next].First];
    const dvec3 sum = end + start;
    const double size = length(sum); // twice the cosine
    if (size > 2.0 * SharpestJoint)
    {
      end = start = sum / size;
      this->AllStations[c].IsEndOpen = false;
      this->AllStations[next].IsStartOpen = false;
    }
    else
    {
      joints.Next[c] = Joints::None;
      joints.Last[next] = Joints::None;
    }
  }
}

void CurveFrames::FollowNormals(const CurveMesh& mesh, const Joints& joints)
{
  const vtkIdType number = mesh.GetNumberOfCurves();
  std::fill(this->Normals.begin(), this->Normals.end(), dvec3(0.0));
  // Start at curves without a predecessor. The remaining curves form rings.
  vtkSMPTools::For(0, number,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType c = begin; c < end; ++c)
      {
        if (joints.Last[c] == Joints::None)
        {
          this->FollowChain(mesh, joints, c);
        }
      }
    });
  for (vtkIdType c = 0; c < number; ++c)
  {
    if (this->Normals[this->AllStations[c].First] == dvec3(0.0))
    {
      this->FollowChain(mesh, joints, c);
      this->CloseRing(joints, c);
    }
  }
}

void CurveFrames::FollowChain(const CurveMesh& mesh, const Joints& joints, vtkIdType first)
{
  dvec3 normal = FindPerpendicular(this->Tangents[this->AllStations[first].First]);
  vtkIdType c = first;
  do
  {
    CurveEvaluator curve(mesh, c);
    const Stations& stations = this->AllStations[c];
    const int samples = curve.curveDegree() > 1 ? SamplesOfInterval : 1;
    for (int k = 0; k < stations.Intervals; ++k)
    {
      const vtkIdType station = stations.First + k;
      this->Normals[station] = normal;
      dvec3 tangent = this->Tangents[station];
      for (int i = 1; i <= samples; ++i)
      {
        const double t = (k + static_cast<double>(i) / samples) / stations.Intervals;
        const dvec3 next =
          i == samples ? this->Tangents[station + 1] : curve.curveTangent(curve.curveLine(t), t);
        normal = curve.curveTurn(normal, tangent, next);
        tangent = next;
      }
    }
    this->Normals[stations.First + stations.Intervals] = normal;
    c = joints.Next[c];
  } while (c != Joints::None && c != first);
}

// After a whole turn around a ring, the frame is rotated about its tangent. The rotation is
// distributed over all stations.
void CurveFrames::CloseRing(const Joints& joints, vtkIdType first)
{
  int intervals = 0;
  vtkIdType last = first;
  for (vtkIdType c = first; intervals == 0 || c != first; c = joints.Next[c])
  {
    intervals += this->AllStations[c].Intervals;
    last = c;
  }
  const dvec3 start = this->Normals[this->AllStations[first].First];
  const dvec3 tangent = this->Tangents[this->AllStations[first].First];
  const dvec3 end =
    this->Normals[this->AllStations[last].First + this->AllStations[last].Intervals];
  const double angle = std::atan2(dot(cross(end, start), tangent), dot(end, start));
  int next = 0;
  for (vtkIdType c = first; next == 0 || c != first; c = joints.Next[c])
  {
    for (int k = 0; k <= this->AllStations[c].Intervals; ++k)
    {
      const double share = angle * (next + k) / intervals;
      const vtkIdType station = this->AllStations[c].First + k;
      dvec3& normal = this->Normals[station];
      normal = normal * std::cos(share) + cross(this->Tangents[station], normal) * std::sin(share);
    }
    next += this->AllStations[c].Intervals;
  }
  this->Normals[this->AllStations[last].First + this->AllStations[last].Intervals] = start;
}

void CurveFrames::Set(CurveEvaluator& evaluator, vtkIdType curve) const
{
  const Stations& stations = this->AllStations[curve];
  evaluator.SetStations(
    stations.Intervals, &this->Tangents[stations.First], &this->Normals[stations.First]);
}
}
