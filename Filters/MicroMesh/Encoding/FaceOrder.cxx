// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Encoding/FaceOrder.h"

#include "Encoding/SurfaceSampling.h"

#include <utility>

namespace relevo
{
namespace
{
// A face and the corner that comes first.
struct Turned
{
  std::size_t Face;
  int First;
};

int GetSide(std::size_t face, int edge)
{
  return 3 * static_cast<int>(face) + edge;
}

// The side of the other face at each side, or -1.
std::vector<int> FindOpposite(const EncodedMesh& encoded)
{
  constexpr int splitting = DenseMesh::SHARP | DenseMesh::UNCLEAR | DenseMesh::SEAM;
  const std::vector<MicroMesh::Face>& faces = encoded.Mesh.Faces;
  std::vector<int> opposite(3 * faces.size(), -1);
  std::vector<int> firsts(encoded.Mesh.Edges.size(), -1);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    for (int e = 0; e < 3; ++e)
    {
      const auto edge = static_cast<std::size_t>(faces[f].Edges[e] >> 1);
      if ((encoded.Base.EdgeFlags[edge] & splitting) != 0)
      {
        continue;
      }
      const int side = GetSide(f, e);
      if (firsts[edge] < 0)
      {
        firsts[edge] = side;
      }
      else
      {
        opposite[static_cast<std::size_t>(side)] = firsts[edge];
        opposite[static_cast<std::size_t>(firsts[edge])] = side;
      }
    }
  }
  return opposite;
}

std::vector<Turned> FindOrder(const EncodedMesh& encoded)
{
  const std::vector<int> opposite = FindOpposite(encoded);
  const std::size_t number = encoded.Mesh.Faces.size();
  std::vector<Turned> order;
  std::vector<char> areDone(number, 0);
  std::vector<int> gates; // sides of faces that follow
  for (std::size_t start = 0; start < number; ++start)
  {
    gates.push_back(GetSide(start, 0));
    while (!gates.empty())
    {
      const int side = gates.back();
      gates.pop_back();
      const auto face = static_cast<std::size_t>(side / 3);
      if (areDone[face] != 0)
      {
        continue;
      }
      areDone[face] = 1;
      order.push_back({ face, side % 3 });
      for (int e : { 0, 2, 1 }) // the face across the side after the first one is next
      {
        const int next = opposite[static_cast<std::size_t>(GetSide(face, (side + e) % 3))];
        if (next >= 0)
        {
          gates.push_back(next);
        }
      }
    }
  }
  return order;
}

template <typename T>
std::array<T, 3> Turn(const std::array<T, 3>& values, int first)
{
  const auto i = static_cast<std::size_t>(first);
  return { { values[i], values[(i + 1) % 3], values[(i + 2) % 3] } };
}

// Numbers the edges of faces anew. Samples of an edge run along the first side that has it.
void NumberEdges(const EncodedMesh& encoded, MicroMesh& mesh, std::vector<unsigned char>& flags,
  std::vector<int>& references)
{
  references.assign(encoded.Mesh.Edges.size(), -1); // per old edge: the new one for a flag of 0
  for (MicroMesh::Face& face : mesh.Faces)
  {
    for (int& reference : face.Edges)
    {
      const auto old = static_cast<std::size_t>(reference >> 1);
      const int isReversed = reference & 1;
      if (references[old] < 0)
      {
        references[old] = static_cast<int>(mesh.Edges.size()) << 1 | isReversed;
        mesh.Edges.push_back(encoded.Mesh.Edges[old]);
        flags.push_back(encoded.Base.EdgeFlags[old]);
      }
      reference = references[old] ^ isReversed;
    }
  }
}

void CopySamples(const MicroMesh& from, const std::vector<int>& references,
  const std::vector<Turned>& order, MicroMesh& to)
{
  for (std::size_t e = 0; e < references.size(); ++e)
  {
    const MicroMesh::Edge& edge = to.Edges[static_cast<std::size_t>(references[e] >> 1)];
    const int number = (1 << edge.Level) - 1;
    for (int i = 0; i < number; ++i)
    {
      const int place = (references[e] & 1) != 0 ? number - 1 - i : i;
      to.Samples[static_cast<std::size_t>(edge.First + place)] =
        from.Samples[static_cast<std::size_t>(from.Edges[e].First + i)];
    }
  }
  for (std::size_t f = 0; f < order.size(); ++f)
  {
    const MicroMesh::Face& face = from.Faces[order[f].Face];
    const int n = 1 << face.Level;
    ForEachGridPoint(n,
      [&](const GridPoint& point)
      {
        if (GetGridEdge(point) < 0)
        {
          const int turned = GetInnerIndex(n, Turn(point, order[f].First));
          to.Samples[static_cast<std::size_t>(to.Faces[f].FirstInner + turned)] =
            from.Samples[static_cast<std::size_t>(face.FirstInner + GetInnerIndex(n, point))];
        }
      });
  }
}
}

void OrderFaces(EncodedMesh& encoded)
{
  const std::vector<Turned> order = FindOrder(encoded);
  MicroMesh mesh;
  std::vector<int> triangles;
  std::vector<DenseMesh::Triangle> wedges;
  for (const Turned& turned : order)
  {
    MicroMesh::Face face = encoded.Mesh.Faces[turned.Face];
    face.Corners = Turn(face.Corners, turned.First);
    face.Edges = Turn(face.Edges, turned.First);
    mesh.Faces.push_back(face);
    triangles.push_back(encoded.Base.Triangles[turned.Face]);
    wedges.push_back(Turn(encoded.Base.Wedges[turned.Face], turned.First));
  }
  std::vector<unsigned char> flags;
  std::vector<int> references;
  NumberEdges(encoded, mesh, flags, references);
  NumberSamples(mesh);
  CopySamples(encoded.Mesh, references, order, mesh);
  mesh.Points = std::move(encoded.Mesh.Points);
  mesh.Directions = std::move(encoded.Mesh.Directions);
  encoded.Mesh = std::move(mesh);
  encoded.Base.Mesh = {}; // its faces have another order
  encoded.Base.Triangles = std::move(triangles);
  encoded.Base.Wedges = std::move(wedges);
  encoded.Base.EdgeFlags = std::move(flags);
}
}
