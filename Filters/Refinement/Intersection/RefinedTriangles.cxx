// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Intersection/RefinedTriangles.h"

#include "Evaluation/HoleFinder.h"
#include "Evaluation/PatternSelection.h"
#include "Evaluation/RefinementEvaluator.h"
#include "Mesh/RefinementMesh.h"
#include "Patterns/RefinementPattern.h"
#include "vtkDataArray.h"
#include "vtkLine.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
struct Vector
{
  double X, Y, Z;
  explicit Vector(const float* p)
    : X(p[0])
    , Y(p[1])
    , Z(p[2])
  {
  }
  Vector(double x, double y, double z)
    : X(x)
    , Y(y)
    , Z(z)
  {
  }
  Vector operator-(const Vector& v) const
  {
    return { this->X - v.X, this->Y - v.Y, this->Z - v.Z };
  }
  double Dot(const Vector& v) const { return this->X * v.X + this->Y * v.Y + this->Z * v.Z; }
  Vector Cross(const Vector& v) const
  {
    return { this->Y * v.Z - this->Z * v.Y, this->Z * v.X - this->X * v.Z,
      this->X * v.Y - this->Y * v.X };
  }
};

// Computes the barycentric weights of the point of a triangle that is nearest to p (Ericson,
// Real-Time Collision Detection, 2005, section 5.1.5).
void FindNearestShares(
  const Vector& p, const Vector& a, const Vector& b, const Vector& c, double shares[3])
{
  const Vector ab = b - a;
  const Vector ac = c - a;
  const double ab1 = ab.Dot(p - a);
  const double ac1 = ac.Dot(p - a);
  const double ab2 = ab.Dot(p - b);
  const double ac2 = ac.Dot(p - b);
  const double ab3 = ab.Dot(p - c);
  const double ac3 = ac.Dot(p - c);
  const double ofC = ab1 * ac2 - ab2 * ac1;
  const double ofB = ab3 * ac1 - ab1 * ac3;
  const double ofA = ab2 * ac3 - ab3 * ac2;
  const auto set = [shares](double u, double v, double w)
  {
    shares[0] = u;
    shares[1] = v;
    shares[2] = w;
  };
  if (ab1 <= 0.0 && ac1 <= 0.0)
  {
    set(1.0, 0.0, 0.0);
  }
  else if (ab2 >= 0.0 && ac2 <= ab2)
  {
    set(0.0, 1.0, 0.0);
  }
  else if (ofC <= 0.0 && ab1 >= 0.0 && ab2 <= 0.0)
  {
    const double t = ab1 / (ab1 - ab2);
    set(1.0 - t, t, 0.0);
  }
  else if (ac3 >= 0.0 && ab3 <= ac3)
  {
    set(0.0, 0.0, 1.0);
  }
  else if (ofB <= 0.0 && ac1 >= 0.0 && ac3 <= 0.0)
  {
    const double t = ac1 / (ac1 - ac3);
    set(1.0 - t, 0.0, t);
  }
  else if (ofA <= 0.0 && ac2 >= ab2 && ab3 >= ac3)
  {
    const double t = (ac2 - ab2) / ((ac2 - ab2) + (ab3 - ac3));
    set(0.0, 1.0 - t, t);
  }
  else
  {
    const double sum = ofA + ofB + ofC;
    set(ofA / sum, ofB / sum, ofC / sum);
  }
}
}

LineFrame::LineFrame(const double start[3], const double end[3])
{
  double direction[3];
  for (int c = 0; c < 3; ++c)
  {
    this->Start[c] = start[c];
    direction[c] = end[c] - start[c];
  }
  int longest = 0;
  for (int c = 1; c < 3; ++c)
  {
    longest = std::abs(direction[c]) > std::abs(direction[longest]) ? c : longest;
  }
  this->Axes[0] = (longest + 1) % 3;
  this->Axes[1] = (longest + 2) % 3;
  this->Axes[2] = longest;
  this->Shear[0] = direction[this->Axes[0]] / direction[longest];
  this->Shear[1] = direction[this->Axes[1]] / direction[longest];
  this->Shear[2] = 1.0 / direction[longest];
}

void LineFrame::Transform(const float* point, double out[3]) const
{
  const double z = point[this->Axes[2]] - this->Start[this->Axes[2]];
  out[0] = point[this->Axes[0]] - this->Start[this->Axes[0]] - this->Shear[0] * z;
  out[1] = point[this->Axes[1]] - this->Start[this->Axes[1]] - this->Shear[1] * z;
  out[2] = this->Shear[2] * z;
}

RefinedTriangles::RefinedTriangles(const RefinementMesh& mesh, const RefinementEvaluator& evaluator,
  const HoleFinder* holes, const PatternSelection& selection, vtkDataArray* normals)
  : Mesh(mesh)
  , Evaluator(evaluator)
  , Holes(holes)
  , Selection(selection)
  , InputNormals(mesh.Normals.empty() ? normals : nullptr)
{
}

void RefinedTriangles::Refine(int face)
{
  const FacePattern pattern = this->Selection.GetFacePattern(face);
  const int n = pattern.Pattern->GetNumberOfVertices();
  this->Triangles = pattern.Pattern->Triangles.data();
  this->Turned = pattern.Mirrored;
  for (std::vector<float>* values : { &this->Points, &this->Normals, &this->Weights })
  {
    values->resize(3 * static_cast<size_t>(n));
  }
  for (int i = 0; i < n; ++i)
  {
    const size_t at = 3 * static_cast<size_t>(i);
    pattern.GetWeights(i, &this->Weights[at]);
    this->Evaluator.Evaluate(face, &this->Weights[at], &this->Points[at], &this->Normals[at]);
  }
  if (this->InputNormals)
  {
    this->InterpolateNormals(face);
  }
  this->Out.assign(static_cast<size_t>(pattern.Pattern->GetNumberOfTriangles()), 0);
  if (this->Holes)
  {
    this->Holes->Find(face, pattern, this->Out.data());
  }
}

// The input's normals are interpolated linearly.
void RefinedTriangles::InterpolateNormals(int face)
{
  double corners[3][3];
  for (int i = 0; i < 3; ++i)
  {
    this->InputNormals->GetTuple(this->Mesh.Faces[face].Corners[i], corners[i]);
    vtkMath::Normalize(corners[i]);
  }
  for (size_t at = 0; at < this->Normals.size(); at += 3)
  {
    double normal[3] = { 0.0, 0.0, 0.0 };
    for (int i = 0; i < 3; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        normal[c] += this->Weights[at + i] * corners[i][c];
      }
    }
    vtkMath::Normalize(normal);
    std::copy_n(normal, 3, &this->Normals[at]);
  }
}

template <typename Visitor>
void RefinedTriangles::ForEachTriangle(const Visitor& visit) const
{
  for (size_t t = 0; t < this->Out.size(); ++t)
  {
    if (!this->Out[t])
    {
      visit(this->Triangles + 3 * t);
    }
  }
}

void RefinedTriangles::Interpolate(
  const unsigned int vertices[3], const double shares[3], TrianglePoint& point) const
{
  for (int c = 0; c < 3; ++c)
  {
    point.Position[c] = point.Normal[c] = point.Weights[c] = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const size_t at = 3 * static_cast<size_t>(vertices[i]) + c;
      point.Position[c] += shares[i] * this->Points[at];
      point.Normal[c] += shares[i] * this->Normals[at];
      point.Weights[c] += shares[i] * this->Weights[at];
    }
  }
  const Vector a(&this->Points[3 * static_cast<size_t>(vertices[0])]);
  const Vector b(&this->Points[3 * static_cast<size_t>(vertices[this->Turned ? 2 : 1])]);
  const Vector c(&this->Points[3 * static_cast<size_t>(vertices[this->Turned ? 1 : 2])]);
  const Vector normal = (b - a).Cross(c - a);
  point.FlatNormal[0] = normal.X;
  point.FlatNormal[1] = normal.Y;
  point.FlatNormal[2] = normal.Z;
  vtkMath::Normalize(point.FlatNormal);
}

bool RefinedTriangles::Intersect(const LineFrame& frame, double& t, TrianglePoint& point) const
{
  bool found = false;
  this->ForEachTriangle(
    [&](const unsigned int* vertices)
    {
      double a[3];
      double b[3];
      double c[3];
      frame.Transform(&this->Points[3 * static_cast<size_t>(vertices[0])], a);
      frame.Transform(&this->Points[3 * static_cast<size_t>(vertices[1])], b);
      frame.Transform(&this->Points[3 * static_cast<size_t>(vertices[2])], c);
      // From the other side of an edge, these have exactly the opposite sign.
      const double u = c[0] * b[1] - c[1] * b[0];
      const double v = a[0] * c[1] - a[1] * c[0];
      const double w = b[0] * a[1] - b[1] * a[0];
      const double sum = u + v + w;
      const bool inside = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
      if (!inside || sum == 0.0)
      {
        return;
      }
      const double shares[3] = { u / sum, v / sum, w / sum };
      const double here = shares[0] * a[2] + shares[1] * b[2] + shares[2] * c[2];
      if (here >= 0.0 && here < t)
      {
        t = here;
        found = true;
        this->Interpolate(vertices, shares, point);
      }
    });
  return found;
}

bool RefinedTriangles::Approach(const double start[3], const double end[3], double tolerance,
  double& t, TrianglePoint& point) const
{
  bool found = false;
  double p1[3];
  double p2[3];
  std::copy_n(start, 3, p1);
  std::copy_n(end, 3, p2);
  this->ForEachTriangle(
    [&](const unsigned int* vertices)
    {
      for (int edge = 0; edge < 3; ++edge)
      {
        const float* a = &this->Points[3 * static_cast<size_t>(vertices[edge])];
        const float* b = &this->Points[3 * static_cast<size_t>(vertices[(edge + 1) % 3])];
        double m0[3] = { a[0], a[1], a[2] };
        double m1[3] = { b[0], b[1], b[2] };
        double near0[3];
        double near1[3];
        double here;
        double along;
        const double distance2 =
          vtkLine::DistanceBetweenLineSegments(p1, p2, m0, m1, near0, near1, here, along);
        if (distance2 <= tolerance * tolerance && here < t)
        {
          t = here;
          found = true;
          double shares[3] = { 0.0, 0.0, 0.0 };
          shares[edge] = 1.0 - along;
          shares[(edge + 1) % 3] = along;
          this->Interpolate(vertices, shares, point);
        }
      }
    });
  return found;
}

bool RefinedTriangles::FindClosest(
  const double place[3], double& distance2, TrianglePoint& point) const
{
  bool found = false;
  const Vector p(place[0], place[1], place[2]);
  this->ForEachTriangle(
    [&](const unsigned int* vertices)
    {
      const Vector a(&this->Points[3 * static_cast<size_t>(vertices[0])]);
      const Vector b(&this->Points[3 * static_cast<size_t>(vertices[1])]);
      const Vector c(&this->Points[3 * static_cast<size_t>(vertices[2])]);
      double shares[3];
      FindNearestShares(p, a, b, c, shares);
      const Vector nearest(shares[0] * a.X + shares[1] * b.X + shares[2] * c.X,
        shares[0] * a.Y + shares[1] * b.Y + shares[2] * c.Y,
        shares[0] * a.Z + shares[1] * b.Z + shares[2] * c.Z);
      const double here = (p - nearest).Dot(p - nearest);
      if (here < distance2)
      {
        distance2 = here;
        found = true;
        this->Interpolate(vertices, shares, point);
      }
    });
  return found;
}
}
