// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRefinementPatternGenerator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace
{
/// Weights are multiples of 1 / WeightScale, all exact in float, as are their sums.
constexpr std::int64_t WeightScale = std::int64_t(1) << 24;
/// The triangulation's coordinates are multiples of 1 / GridScale: coarse enough for a 64-bit
/// in-circle determinant.
constexpr std::int64_t GridScale = std::int64_t(1) << 14;
/// Inner points lie on multiples of 2^-12, so that products of two weights are exact in float.
constexpr std::int64_t InnerStep = GridScale >> 12;

/// How fast the distance between points may grow with the distance from a finer edge.
constexpr double Gradation = 0.3;
/// Stars with a smaller angle than this are improved.
constexpr double WantedAngleCotangent = 1.2799; // of 38 degrees
constexpr int MaximumNumberOfSweeps = 24;

/// 2 cos(60 degrees / k).
constexpr double TwoCosines[] = { 0.0, 1.0, 1.7320508075688772, 1.8793852415718169,
  1.9318516525781366, 1.9562952014676114, 1.9696155060244161, 1.9776616524502590 };
constexpr int MaximumNumberOfSpokes = 7;

/// The weights of P2 and P3: affine coordinates with P1 = (0,0), P2 = (1,0), P3 = (0,1).
struct Point
{
  std::int64_t V = 0;
  std::int64_t W = 0;
};

Point operator-(Point a, Point b)
{
  return { a.V - b.V, a.W - b.W };
}

std::int64_t Cross(Point a, Point b)
{
  return a.V * b.W - a.W * b.V;
}

/// Twice the dot product in the equilateral triangle.
std::int64_t TwiceDot(Point a, Point b)
{
  return 2 * (a.V * b.V + a.W * b.W) + a.V * b.W + a.W * b.V;
}

std::int64_t SquaredLength(Point a)
{
  return a.V * a.V + a.V * a.W + a.W * a.W;
}

/// Positive when the three points are in counter-clockwise order.
std::int64_t Orientation(Point a, Point b, Point c)
{
  return Cross(b - a, c - a);
}

/// Whether d is inside the circle through a, b, c of the equilateral triangle.
bool IsInCircle(Point a, Point b, Point c, Point d)
{
  const Point x = a - d;
  const Point y = b - d;
  const Point z = c - d;
  return SquaredLength(x) * Cross(y, z) + SquaredLength(y) * Cross(z, x) +
    SquaredLength(z) * Cross(x, y) >
    0;
}

/// sqrt(3) times the cotangent of the smallest angle: 1 is equilateral, infinity degenerate.
/// One rounded division of exact integers, so the same everywhere.
double Badness(Point a, Point b, Point c)
{
  const std::int64_t area = Orientation(a, b, c);
  if (area <= 0)
  {
    return std::numeric_limits<double>::infinity();
  }
  const std::int64_t dot =
    std::max({ TwiceDot(b - a, c - a), TwiceDot(c - b, a - b), TwiceDot(a - c, b - c) });
  return static_cast<double>(dot) / static_cast<double>(area);
}

std::int64_t DivideRounded(std::int64_t a, std::int64_t b)
{
  return (2 * a + b) / (2 * b);
}

/// Calls visit(from, to, k, n) for the inner points of edges 1, 2, 3, in the pattern's order:
/// point k of n from one corner to the other.
template <typename Visitor>
void ForEachBorderPoint(const int segments[3], Visitor&& visit)
{
  for (int edge = 0; edge < 3; ++edge)
  {
    for (int k = 1; k < segments[edge]; ++k)
    {
      visit(edge, (edge + 1) % 3, k, segments[edge]);
    }
  }
}

/// Weights of point k of n on an edge, in units of 1 / scale; the same from both ends.
std::array<std::int64_t, 3> BorderWeights(int from, int to, int k, int n, std::int64_t scale)
{
  std::array<std::int64_t, 3> weights = {};
  weights[to] = DivideRounded(k * scale, n);
  weights[from] = scale - weights[to];
  return weights;
}

/// A Delaunay triangulation of points in the triangle, made by insertion.
class Triangulation
{
public:
  struct Triangle
  {
    int Vertex[3];
    int Neighbor[3]; // opposite to the vertex; -1 outside
  };

  Triangulation()
  {
    this->Points = { { 0, 0 }, { GridScale, 0 }, { 0, GridScale } };
    this->Triangles = { { { 0, 1, 2 }, { -1, -1, -1 } } };
    this->TriangleOfVertex = { 0, 0, 0 };
  }

  void Insert(Point p);
  void MakeDelaunay();

  /// Triangles around an inner vertex as pairs of the other two vertices.
  void GetStar(int vertex, std::vector<std::pair<int, int>>& star) const;

  std::vector<Point> Points;
  std::vector<Triangle> Triangles;

private:
  static int Next(int i) { return (i + 1) % 3; }
  static int Previous(int i) { return (i + 2) % 3; }

  int Locate(Point p) const;
  int IndexOf(int triangle, int vertex) const;
  int IndexOfNeighbor(int triangle, int neighbor) const;
  void Set(int triangle, int a, int b, int c, int na, int nb, int nc);
  void Link(int triangle, int former, int current);
  void Legalize();
  bool Flip(int triangle, int side);

  std::vector<int> TriangleOfVertex;
  std::vector<std::pair<int, int>> Suspects; // triangle, vertex opposite to the suspect side
};

int Triangulation::Locate(Point p) const
{
  int t = static_cast<int>(this->Triangles.size()) - 1;
  for (bool found = false; !found;)
  {
    found = true;
    const Triangle& triangle = this->Triangles[t];
    for (int i = 0; i < 3 && found; ++i)
    {
      const Point& a = this->Points[triangle.Vertex[Next(i)]];
      const Point& b = this->Points[triangle.Vertex[Previous(i)]];
      if (Orientation(a, b, p) < 0)
      {
        t = triangle.Neighbor[i];
        found = false;
      }
    }
  }
  return t;
}

int Triangulation::IndexOf(int triangle, int vertex) const
{
  const int* vertices = this->Triangles[triangle].Vertex;
  return vertices[0] == vertex ? 0 : vertices[1] == vertex ? 1 : 2;
}

int Triangulation::IndexOfNeighbor(int triangle, int neighbor) const
{
  const int* neighbors = this->Triangles[triangle].Neighbor;
  return neighbors[0] == neighbor ? 0 : neighbors[1] == neighbor ? 1 : 2;
}

void Triangulation::Set(int triangle, int a, int b, int c, int na, int nb, int nc)
{
  this->Triangles[triangle] = { { a, b, c }, { na, nb, nc } };
  this->TriangleOfVertex[a] = triangle;
  this->TriangleOfVertex[b] = triangle;
  this->TriangleOfVertex[c] = triangle;
}

void Triangulation::Link(int triangle, int former, int current)
{
  if (triangle >= 0)
  {
    this->Triangles[triangle].Neighbor[this->IndexOfNeighbor(triangle, former)] = current;
  }
}

void Triangulation::Insert(Point p)
{
  const int t = this->Locate(p);
  const Triangle old = this->Triangles[t];
  int side = -1; // p lies on the side opposite to this vertex
  for (int i = 0; i < 3; ++i)
  {
    const Point& a = this->Points[old.Vertex[Next(i)]];
    const Point& b = this->Points[old.Vertex[Previous(i)]];
    if (SquaredLength(p - a) == 0)
    {
      return;
    }
    if (Orientation(a, b, p) == 0)
    {
      side = i;
    }
  }

  const int vertex = static_cast<int>(this->Points.size());
  this->Points.push_back(p);
  this->TriangleOfVertex.push_back(t);
  if (side < 0)
  {
    const int t1 = static_cast<int>(this->Triangles.size());
    const int t2 = t1 + 1;
    this->Triangles.resize(t1 + 2);
    const int* v = old.Vertex;
    const int* n = old.Neighbor;
    this->Set(t, vertex, v[1], v[2], n[0], t1, t2);
    this->Set(t1, v[0], vertex, v[2], t, n[1], t2);
    this->Set(t2, v[0], v[1], vertex, t, t1, n[2]);
    this->Link(n[1], t, t1);
    this->Link(n[2], t, t2);
    this->Suspects = { { t, vertex }, { t1, vertex }, { t2, vertex } };
  }
  else
  {
    // Halve this triangle (a, b, c), p on bc, and the one on the other side, (d, c, b).
    const int a = old.Vertex[side];
    const int b = old.Vertex[Next(side)];
    const int c = old.Vertex[Previous(side)];
    const int beyondB = old.Neighbor[Next(side)];
    const int beyondC = old.Neighbor[Previous(side)];
    const int o = old.Neighbor[side];
    const int t1 = static_cast<int>(this->Triangles.size());
    this->Triangles.resize(t1 + 1);
    this->Set(t, a, b, vertex, o, t1, beyondC);
    this->Set(t1, a, vertex, c, o, beyondB, t);
    this->Link(beyondB, t, t1);
    this->Suspects = { { t, vertex }, { t1, vertex } };
    if (o >= 0)
    {
      const int i = this->IndexOfNeighbor(o, t);
      const Triangle other = this->Triangles[o];
      const int d = other.Vertex[i];
      const int acrossB = other.Neighbor[Previous(i)]; // opposite to b
      const int acrossC = other.Neighbor[Next(i)];     // opposite to c
      const int o1 = t1 + 1;
      this->Triangles.resize(o1 + 1);
      this->Set(o, d, c, vertex, t1, o1, acrossB);
      this->Set(o1, d, vertex, b, t, acrossC, o);
      this->Link(acrossC, o, o1);
      this->Triangles[t].Neighbor[0] = o1;
      this->Triangles[t1].Neighbor[0] = o;
      this->Suspects.push_back({ o, vertex });
      this->Suspects.push_back({ o1, vertex });
    }
  }
  this->Legalize();
}

/// Replace the side opposite to a vertex by the other diagonal where the circle criterion wants it.
bool Triangulation::Flip(int t, int side)
{
  const Triangle abc = this->Triangles[t];
  const int o = abc.Neighbor[side];
  if (o < 0)
  {
    return false;
  }
  const int i = this->IndexOfNeighbor(o, t);
  const Triangle dcb = this->Triangles[o];
  const int a = abc.Vertex[side];
  const int b = abc.Vertex[Next(side)];
  const int c = abc.Vertex[Previous(side)];
  const int d = dcb.Vertex[i];
  if (!IsInCircle(this->Points[a], this->Points[b], this->Points[c], this->Points[d]))
  {
    return false;
  }
  const int beyondB = abc.Neighbor[Next(side)];     // across ca
  const int beyondC = abc.Neighbor[Previous(side)]; // across ab
  const int acrossC = dcb.Neighbor[Next(i)];        // across bd
  const int acrossB = dcb.Neighbor[Previous(i)];    // across dc
  this->Set(t, a, b, d, acrossC, o, beyondC);
  this->Set(o, a, d, c, acrossB, beyondB, t);
  this->Link(acrossC, o, t);
  this->Link(beyondB, t, o);
  for (int vertex : { a, d })
  {
    this->Suspects.push_back({ t, vertex });
    this->Suspects.push_back({ o, vertex });
  }
  return true;
}

void Triangulation::Legalize()
{
  while (!this->Suspects.empty())
  {
    const auto [triangle, vertex] = this->Suspects.back();
    this->Suspects.pop_back();
    const int side = this->IndexOf(triangle, vertex);
    if (this->Triangles[triangle].Vertex[side] == vertex)
    {
      this->Flip(triangle, side);
    }
  }
}

void Triangulation::MakeDelaunay()
{
  for (int t = 0; t < static_cast<int>(this->Triangles.size()); ++t)
  {
    for (int vertex : this->Triangles[t].Vertex)
    {
      this->Suspects.push_back({ t, vertex });
    }
  }
  this->Legalize();
}

void Triangulation::GetStar(int vertex, std::vector<std::pair<int, int>>& star) const
{
  star.clear();
  const int first = this->TriangleOfVertex[vertex];
  int t = first;
  do
  {
    const int i = this->IndexOf(t, vertex);
    const Triangle& triangle = this->Triangles[t];
    star.push_back({ triangle.Vertex[Next(i)], triangle.Vertex[Previous(i)] });
    t = triangle.Neighbor[Next(i)];
  } while (t != first);
}

/// The distance between neighbouring points that the border asks for inside.
class SizeField
{
public:
  explicit SizeField(const int segments[3])
  {
    for (int edge = 0; edge < 3; ++edge)
    {
      this->Length[edge] = 1.0 / segments[edge];
    }
  }

  /// Near an edge its segments' length; inside their mean, weighted by inverse distances, but never
  /// more than the gradation allows.
  double operator()(Point p) const
  {
    const double v = static_cast<double>(p.V) / GridScale;
    const double w = static_cast<double>(p.W) / GridScale;
    const double u = 1.0 - v - w;
    const double weights[3] = { u * v, v * w, w * u };
    double size =
      (weights[0] * this->Length[0] + weights[1] * this->Length[1] + weights[2] * this->Length[2]) /
      (weights[0] + weights[1] + weights[2]);
    const double heights[3] = { w, u, v }; // above edges 1, 2, 3
    for (int edge = 0; edge < 3; ++edge)
    {
      size = std::min(size, this->Length[edge] + Gradation * 0.8660254037844386 * heights[edge]);
    }
    return size;
  }

private:
  double Length[3];
};

/// Points in buckets, to ask for the neighbourhood of a place.
class PointBuckets
{
public:
  explicit PointBuckets(int resolution)
    : Resolution(resolution)
    , Buckets(static_cast<std::size_t>(resolution) * resolution)
  {
  }

  void Add(Point p)
  {
    this->Buckets[this->Bucket(p.W) * this->Resolution + this->Bucket(p.V)].push_back(p);
  }

  /// Whether some point is nearer to p than a distance (in units of the triangle's side).
  bool IsNear(Point p, double distance) const
  {
    const double limit = distance * GridScale;
    const double squaredLimit = limit * limit;
    // A length of 1 reaches at most 1.155 in a weight.
    const std::int64_t reach = static_cast<std::int64_t>(1.16 * limit) + 1;
    for (int j = this->Bucket(p.W - reach); j <= this->Bucket(p.W + reach); ++j)
    {
      for (int i = this->Bucket(p.V - reach); i <= this->Bucket(p.V + reach); ++i)
      {
        for (const Point& q : this->Buckets[j * this->Resolution + i])
        {
          if (static_cast<double>(SquaredLength(p - q)) < squaredLimit)
          {
            return true;
          }
        }
      }
    }
    return false;
  }

private:
  int Bucket(std::int64_t weight) const
  {
    weight = std::min(std::max<std::int64_t>(weight, 0), GridScale - 1);
    return static_cast<int>(weight * this->Resolution / GridScale);
  }

  int Resolution;
  std::vector<std::vector<Point>> Buckets;
};

Point Snapped(double v, double w)
{
  const double steps = static_cast<double>(GridScale / InnerStep);
  return { static_cast<std::int64_t>(v * steps + 0.5) * InnerStep,
    static_cast<std::int64_t>(w * steps + 0.5) * InnerStep };
}

bool IsInside(Point p)
{
  return p.V > 0 && p.W > 0 && p.V + p.W < GridScale;
}

/// The k-th root of x >= 1, by Newton's method from above.
double Root(double x, int k)
{
  double root = x;
  for (;;)
  {
    double power = 1.0;
    for (int i = 1; i < k; ++i)
    {
      power *= root;
    }
    const double next = root - (root - x / power) / k;
    if (!(next < root))
    {
      return root;
    }
    root = next;
  }
}

/// The triangles at a corner where a fine and a coarse edge meet. Spokes from the corner, each
/// about twice as long as the one before, share its 60 degrees evenly: the smallest angle is then
/// about the largest that the two edges allow.
class CornerFan
{
public:
  CornerFan(const int segments[3], int corner)
  {
    const int next = (corner + 1) % 3;
    const int previous = (corner + 2) % 3;
    const bool startsFine = segments[corner] >= segments[previous];
    const int fineEnd = startsFine ? next : previous;
    const int coarseEnd = startsFine ? previous : next;
    const int fine = std::max(segments[corner], segments[previous]);
    const int coarse = std::min(segments[corner], segments[previous]);
    const double ratio = static_cast<double>(fine) / coarse;
    int count = 1;
    while (count < MaximumNumberOfSpokes && ratio * ratio > (2 << (2 * count)))
    {
      ++count;
    }
    double sines[MaximumNumberOfSpokes + 1] = { 0.0, 1.0 }; // of s 60 / count, over that of s = 1
    for (int s = 2; s <= count; ++s)
    {
      sines[s] = TwoCosines[count] * sines[s - 1] - sines[s - 2];
    }
    const double growth = Root(ratio, count);
    double length = 1.0 / fine;
    for (int s = 0; s <= count; ++s)
    {
      double weights[3];
      weights[fineEnd] = length * sines[count - s] / sines[count];
      weights[coarseEnd] = length * sines[s] / sines[count];
      weights[corner] = 1.0 - weights[fineEnd] - weights[coarseEnd];
      this->Tips.push_back(Snapped(weights[1], weights[2]));
      length *= growth;
    }
    if (!startsFine)
    {
      std::reverse(this->Tips.begin(), this->Tips.end());
    }
    this->Corner = { corner == 1 ? GridScale : 0, corner == 2 ? GridScale : 0 };
  }

  bool Contains(Point p) const
  {
    for (std::size_t s = 1; s < this->Tips.size(); ++s)
    {
      const Point& a = this->Tips[s - 1];
      const Point& b = this->Tips[s];
      if (Orientation(this->Corner, a, p) >= 0 && Orientation(this->Corner, b, p) <= 0 &&
        Orientation(a, b, p) >= 0)
      {
        return true;
      }
    }
    return false;
  }

  /// Ends of the spokes, counter-clockwise; the first and the last are on the edges.
  std::vector<Point> Tips;

private:
  Point Corner;
};

/// Inner points: those of regular grids, each grid where the size field asks for its spacing.
std::vector<Point> MakeInnerPoints(const int segments[3], const std::vector<Point>& border)
{
  const SizeField size(segments);
  PointBuckets buckets(std::max(1, segments[0]));
  for (const Point& p : border)
  {
    buckets.Add(p);
  }
  std::vector<CornerFan> fans;
  std::vector<Point> points;
  auto accept = [&](Point p, double distance)
  {
    if (IsInside(p) && !buckets.IsNear(p, distance))
    {
      buckets.Add(p);
      points.push_back(p);
    }
  };
  for (int corner = 0; corner < 3; ++corner)
  {
    if (segments[corner] != segments[(corner + 2) % 3])
    {
      fans.emplace_back(segments, corner);
      for (const Point& p : fans.back().Tips)
      {
        accept(p, 0.25 * size(p));
      }
    }
  }
  auto isInFan = [&](Point p)
  {
    return std::any_of(
      fans.begin(), fans.end(), [&](const CornerFan& fan) { return fan.Contains(p); });
  };
  for (int n = segments[0]; n > 1; n = (n + 1) / 2)
  {
    const double spacing = 1.0 / n;
    for (int j = 1; j < n; ++j)
    {
      for (int i = 1; i + j < n; ++i)
      {
        const Point p = Snapped(i * spacing, j * spacing);
        const double h = size(p);
        const bool isRightGrid = h < 1.42 * spacing && (n == segments[0] || h >= 0.71 * spacing);
        if (isRightGrid && !isInFan(p))
        {
          accept(p, 0.72 * h);
        }
      }
    }
  }
  return points;
}

/// Makes the smallest angle around inner points larger, by moving some and taking out others.
class Smoother
{
public:
  Smoother(Triangulation& mesh, int firstInner)
    : Mesh(mesh)
    , FirstInner(firstInner)
  {
  }

  /// Move points for as long as it helps.
  void Move()
  {
    for (int sweep = 0; sweep < MaximumNumberOfSweeps; ++sweep)
    {
      bool moved = false;
      for (int v = this->FirstInner; v < static_cast<int>(this->Mesh.Points.size()); ++v)
      {
        moved |= this->MoveVertex(v);
      }
      if (!moved)
      {
        break;
      }
      this->Mesh.MakeDelaunay();
    }
  }

  /// Inner points without which the triangles around them would be better; no two are neighbours.
  std::vector<bool> FindObstacles()
  {
    std::vector<bool> obstacles(this->Mesh.Points.size(), false);
    for (int v = this->FirstInner; v < static_cast<int>(this->Mesh.Points.size()); ++v)
    {
      this->Mesh.GetStar(v, this->Star);
      obstacles[v] = this->IsObstacle(v) &&
        std::none_of(this->Star.begin(), this->Star.end(),
          [&](const std::pair<int, int>& side) { return obstacles[side.first]; });
    }
    return obstacles;
  }

private:
  /// Largest badness of the triangles between p and the sides of the star; at least the limit when
  /// it gets there.
  double StarBadness(Point p, double limit) const
  {
    double badness = 0.0;
    for (const auto& [a, b] : this->Star)
    {
      badness = std::max(badness, Badness(p, this->Mesh.Points[a], this->Mesh.Points[b]));
      if (badness >= limit)
      {
        break;
      }
    }
    return badness;
  }

  bool IsGood(double badness) const { return badness <= WantedAngleCotangent * 1.7320508075688772; }

  /// Whether the star is better filled from one of its corners.
  bool IsObstacle(int vertex) const
  {
    const double limit =
      this->StarBadness(this->Mesh.Points[vertex], std::numeric_limits<double>::infinity());
    if (this->IsGood(limit))
    {
      return false;
    }
    for (const auto& pair : this->Star)
    {
      const int corner = pair.first;
      double badness = 0.0;
      for (const auto& [a, b] : this->Star)
      {
        if (a != corner && b != corner && badness < limit)
        {
          badness = std::max(badness,
            Badness(this->Mesh.Points[corner], this->Mesh.Points[a], this->Mesh.Points[b]));
        }
      }
      if (badness < limit)
      {
        return true;
      }
    }
    return false;
  }

  bool MoveVertex(int vertex)
  {
    this->Mesh.GetStar(vertex, this->Star);
    Point& position = this->Mesh.Points[vertex];
    double best = this->StarBadness(position, std::numeric_limits<double>::infinity());
    if (this->IsGood(best))
    {
      return false;
    }
    std::int64_t shortest = std::numeric_limits<std::int64_t>::max();
    Point sum;
    for (const auto& pair : this->Star)
    {
      const Point& p = this->Mesh.Points[pair.first];
      shortest = std::min(shortest, SquaredLength(p - position));
      sum.V += p.V;
      sum.W += p.W;
    }
    bool moved = false;
    auto attempt = [&](Point p)
    {
      const double badness = this->StarBadness(p, best);
      if (badness < best)
      {
        best = badness;
        position = p;
        moved = true;
      }
    };
    const std::int64_t ring = static_cast<std::int64_t>(this->Star.size()) * InnerStep;
    attempt({ DivideRounded(sum.V, ring) * InnerStep, DivideRounded(sum.W, ring) * InnerStep });

    static constexpr int Directions[6][2] = { { 1, 0 }, { 0, 1 }, { -1, 1 }, { -1, 0 }, { 0, -1 },
      { 1, -1 } };
    std::int64_t step = InnerStep;
    while (64 * step * step < shortest)
    {
      step *= 2;
    }
    for (; step >= InnerStep; step /= 2)
    {
      const Point center = position;
      for (const auto& direction : Directions)
      {
        attempt({ center.V + step * direction[0], center.W + step * direction[1] });
      }
    }
    return moved;
  }

  Triangulation& Mesh;
  int FirstInner;
  std::vector<std::pair<int, int>> Star;
};

/// A mesh in the making: weights in units of 1 / WeightScale.
struct Mesh
{
  std::vector<std::array<std::int64_t, 3>> Weights;
  std::vector<std::array<int, 3>> Triangles;
};

void AddBorder(const int segments[3], Mesh& mesh)
{
  mesh.Weights = { { WeightScale, 0, 0 }, { 0, WeightScale, 0 }, { 0, 0, WeightScale } };
  ForEachBorderPoint(segments,
    [&](int from, int to, int k, int n)
    { mesh.Weights.push_back(BorderWeights(from, to, k, n, WeightScale)); });
}

/// Vertex of the regular grid of n segments at v = i / n, w = j / n; inner vertices by rows.
int RegularVertex(int n, int i, int j)
{
  const int k = n - i - j;
  if (k == n)
  {
    return 0;
  }
  if (i == n)
  {
    return 1;
  }
  if (j == n)
  {
    return 2;
  }
  if (j == 0)
  {
    return 2 + i;
  }
  if (k == 0)
  {
    return 1 + n + j;
  }
  if (i == 0)
  {
    return 2 * n + k;
  }
  // Row j follows j - 1 rows of n - 2, n - 3, ... vertices.
  return 3 * n + (j - 1) * (n - 1) - (j - 1) * j / 2 + i - 1;
}

Mesh MakeRegularMesh(int n)
{
  Mesh mesh;
  const int segments[3] = { n, n, n };
  AddBorder(segments, mesh);
  for (int j = 1; j < n; ++j)
  {
    for (int i = 1; i + j < n; ++i)
    {
      const std::int64_t v = DivideRounded(i * WeightScale, n);
      const std::int64_t w = DivideRounded(j * WeightScale, n);
      mesh.Weights.push_back({ WeightScale - v - w, v, w });
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i + j < n; ++i)
    {
      mesh.Triangles.push_back(
        { RegularVertex(n, i, j), RegularVertex(n, i + 1, j), RegularVertex(n, i, j + 1) });
      if (i + j + 1 < n)
      {
        mesh.Triangles.push_back({ RegularVertex(n, i + 1, j), RegularVertex(n, i + 1, j + 1),
          RegularVertex(n, i, j + 1) });
      }
    }
  }
  return mesh;
}

Mesh MakeGradedMesh(const int segments[3])
{
  Triangulation border;
  ForEachBorderPoint(segments,
    [&](int from, int to, int k, int n)
    {
      const auto weights = BorderWeights(from, to, k, n, GridScale);
      border.Insert({ weights[1], weights[2] });
    });
  const int firstInner = static_cast<int>(border.Points.size());
  std::vector<Point> inner = MakeInnerPoints(segments, border.Points);
  Triangulation triangulation;
  for (;;)
  {
    triangulation = border;
    for (const Point& p : inner)
    {
      triangulation.Insert(p);
    }
    Smoother smoother(triangulation, firstInner);
    smoother.Move();
    const std::vector<bool> obstacles = smoother.FindObstacles();
    inner.clear();
    for (std::size_t i = firstInner; i < obstacles.size(); ++i)
    {
      if (!obstacles[i])
      {
        inner.push_back(triangulation.Points[i]);
      }
    }
    if (firstInner + inner.size() == triangulation.Points.size())
    {
      break;
    }
  }

  Mesh mesh;
  AddBorder(segments, mesh);
  constexpr std::int64_t Unit = WeightScale / GridScale;
  for (std::size_t i = firstInner; i < triangulation.Points.size(); ++i)
  {
    const Point p = triangulation.Points[i];
    mesh.Weights.push_back({ (GridScale - p.V - p.W) * Unit, p.V * Unit, p.W * Unit });
  }
  for (const auto& triangle : triangulation.Triangles)
  {
    mesh.Triangles.push_back({ triangle.Vertex[0], triangle.Vertex[1], triangle.Vertex[2] });
  }
  return mesh;
}

/// Position of a cell on Hilbert's curve through a grid of 2^bits cells a side.
std::uint32_t HilbertIndex(std::uint32_t x, std::uint32_t y, int bits)
{
  std::uint32_t index = 0;
  for (std::uint32_t s = 1u << (bits - 1); s > 0; s /= 2)
  {
    const std::uint32_t rx = (x & s) ? 1 : 0;
    const std::uint32_t ry = (y & s) ? 1 : 0;
    index += s * s * ((3 * rx) ^ ry);
    if (ry == 0)
    {
      if (rx == 1)
      {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return index;
}

/// Neighbouring triangles one after the other, and inner vertices in the order of their first use:
/// what a cache of transformed vertices wants.
void OrderForCache(Mesh& mesh, int numberOfBorderVertices)
{
  constexpr int Bits = 12;
  const std::int64_t cell = 3 * WeightScale >> Bits;
  std::vector<std::pair<std::uint32_t, std::array<int, 3>>> order;
  order.reserve(mesh.Triangles.size());
  for (const auto& triangle : mesh.Triangles)
  {
    std::int64_t v = 0;
    std::int64_t w = 0;
    for (int vertex : triangle)
    {
      v += mesh.Weights[vertex][1];
      w += mesh.Weights[vertex][2];
    }
    order.push_back({ HilbertIndex(static_cast<std::uint32_t>(v / cell),
                        static_cast<std::uint32_t>(w / cell), Bits),
      triangle });
  }
  std::sort(order.begin(), order.end());

  std::vector<int> number(mesh.Weights.size(), -1);
  auto weights = mesh.Weights;
  int used = numberOfBorderVertices;
  for (std::size_t t = 0; t < order.size(); ++t)
  {
    mesh.Triangles[t] = order[t].second;
    for (int& vertex : mesh.Triangles[t])
    {
      if (vertex >= numberOfBorderVertices)
      {
        if (number[vertex] < 0)
        {
          number[vertex] = used++;
          weights[number[vertex]] = mesh.Weights[vertex];
        }
        vertex = number[vertex];
      }
    }
  }
  mesh.Weights.swap(weights);
}

/// The directed sides of all triangles, sorted.
std::vector<std::pair<unsigned int, unsigned int>> SortedSides(
  const std::vector<unsigned int>& triangles)
{
  std::vector<std::pair<unsigned int, unsigned int>> sides;
  sides.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); t += 3)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      sides.push_back({ triangles[t + i], triangles[t + (i + 1) % 3] });
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// The segments of edges 1, 2, 3, in order and direction.
std::vector<std::pair<unsigned int, unsigned int>> BorderSides(const int segments[3])
{
  std::vector<std::pair<unsigned int, unsigned int>> sides;
  unsigned int next = 3;
  for (unsigned int edge = 0; edge < 3; ++edge)
  {
    unsigned int last = edge;
    for (int k = 1; k < segments[edge]; ++k)
    {
      sides.push_back({ last, next });
      last = next++;
    }
    sides.push_back({ last, (edge + 1) % 3 });
  }
  return sides;
}

bool Contains(
  const std::vector<std::pair<unsigned int, unsigned int>>& sorted, unsigned int a, unsigned int b)
{
  return std::binary_search(sorted.begin(), sorted.end(), std::make_pair(a, b));
}

/// Weights as integers, or false when they are not multiples of 1 / WeightScale that sum to 1.
bool GetExactWeights(const float* weights, std::array<std::int64_t, 3>& exact)
{
  for (int i = 0; i < 3; ++i)
  {
    const float scaled = weights[i] * static_cast<float>(WeightScale);
    if (!(scaled >= 0.0f && scaled <= static_cast<float>(WeightScale)))
    {
      return false;
    }
    exact[i] = static_cast<std::int64_t>(scaled);
    if (static_cast<float>(exact[i]) != scaled)
    {
      return false;
    }
  }
  return exact[0] + exact[1] + exact[2] == WeightScale;
}
}

namespace relevo
{
vtkRefinementPattern GeneratePattern(int n1, int n2, int n3)
{
  const int segments[3] = { n1, n2, n3 };
  Mesh mesh = n1 == n3 ? MakeRegularMesh(n1) : MakeGradedMesh(segments);

  vtkRefinementPattern pattern;
  std::copy(segments, segments + 3, pattern.Segments);
  OrderForCache(mesh, pattern.GetNumberOfBorderVertices());
  pattern.Vertices.reserve(3 * mesh.Weights.size());
  for (const auto& weights : mesh.Weights)
  {
    for (const std::int64_t weight : weights)
    {
      pattern.Vertices.push_back(static_cast<float>(weight) / static_cast<float>(WeightScale));
    }
  }
  pattern.Triangles.reserve(3 * mesh.Triangles.size());
  for (const auto& triangle : mesh.Triangles)
  {
    pattern.Triangles.insert(pattern.Triangles.end(), triangle.begin(), triangle.end());
  }
  MakeLines(pattern);
  return pattern;
}

void MakeLines(vtkRefinementPattern& pattern)
{
  pattern.Lines.clear();
  for (const auto& [a, b] : BorderSides(pattern.Segments))
  {
    pattern.Lines.insert(pattern.Lines.end(), { a, b });
  }
  // A side inside comes twice, once in each direction; one of the border only once.
  const auto sides = SortedSides(pattern.Triangles);
  pattern.Lines.reserve(sides.size() + pattern.Lines.size() / 2);
  for (const auto& [a, b] : sides)
  {
    if (a < b && Contains(sides, b, a))
    {
      pattern.Lines.insert(pattern.Lines.end(), { a, b });
    }
  }
}

const char* FindDefect(const vtkRefinementPattern& pattern)
{
  const int* segments = pattern.Segments;
  if (segments[0] > MaximumNumberOfSegments || segments[0] < segments[1] ||
    segments[1] < segments[2] || segments[2] < 1)
  {
    return "its numbers of segments are not in descending order or out of range";
  }
  const int numberOfVertices = pattern.GetNumberOfVertices();
  const int numberOfBorderVertices = pattern.GetNumberOfBorderVertices();
  if (numberOfVertices < numberOfBorderVertices ||
    pattern.GetNumberOfTriangles() != 2 * numberOfVertices - 2 - numberOfBorderVertices)
  {
    return "its numbers of vertices and triangles do not fit together";
  }

  Mesh border;
  AddBorder(segments, border);
  std::vector<Point> points(numberOfVertices);
  for (int i = 0; i < numberOfVertices; ++i)
  {
    std::array<std::int64_t, 3> weights;
    if (!GetExactWeights(&pattern.Vertices[3 * static_cast<std::size_t>(i)], weights))
    {
      return "the weights of a vertex are not in [0, 1] or do not sum to 1";
    }
    if (i < numberOfBorderVertices ? weights != border.Weights[i]
                                   : *std::min_element(weights.begin(), weights.end()) == 0)
    {
      return "a vertex is not where its place in the list says";
    }
    points[i] = { weights[1], weights[2] };
  }

  std::int64_t area = 0;
  for (std::size_t t = 0; t < pattern.Triangles.size(); t += 3)
  {
    const unsigned int* triangle = &pattern.Triangles[t];
    for (int i = 0; i < 3; ++i)
    {
      if (triangle[i] >= points.size())
      {
        return "a triangle has a vertex that does not exist";
      }
    }
    const std::int64_t orientation =
      Orientation(points[triangle[0]], points[triangle[1]], points[triangle[2]]);
    if (orientation <= 0)
    {
      return "a triangle is degenerate or turned over";
    }
    area += orientation;
  }

  // Each side is used once, and its opposite as well unless it is of the border.
  const auto sides = SortedSides(pattern.Triangles);
  if (area != WeightScale * WeightScale ||
    std::adjacent_find(sides.begin(), sides.end()) != sides.end())
  {
    return "its triangles overlap or leave a gap";
  }
  std::size_t numberOfOpenSides = 0;
  for (const auto& [a, b] : sides)
  {
    numberOfOpenSides += Contains(sides, b, a) ? 0 : 1;
  }
  for (const auto& [a, b] : BorderSides(segments))
  {
    if (!Contains(sides, a, b))
    {
      return "a segment of its border is no side of a triangle";
    }
  }
  if (numberOfOpenSides != static_cast<std::size_t>(numberOfBorderVertices))
  {
    return "its triangles leave a gap";
  }
  return nullptr;
}
}
