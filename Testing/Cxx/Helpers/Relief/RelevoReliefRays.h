// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Intersections of rays with a relief's surface by its definition, in double precision: every ray
// is tested with every quad. Shares no code with the library.
#ifndef RelevoReliefRays_h
#define RelevoReliefRays_h

#include "RelevoVector.h"

#include <array>
#include <vector>

class vtkImageData;

struct RelevoReliefHit
{
  bool IsHit = false;
  double Distance = 0.0; // along the ray, in lengths of its direction
  double Column = 0.0;
  double Row = 0.0;
  RelevoVectors::Vector Point; // in the world
};

class RelevoReliefRays
{
public:
  explicit RelevoReliefRays(vtkImageData* relief, double maximumStretch = 8.0);

  // First point of the surface on the ray from `least` to `most`.
  RelevoReliefHit Cast(const RelevoVectors::Vector& origin, const RelevoVectors::Vector& direction,
    double least, double most) const;

  // All intersections, in order.
  std::vector<RelevoReliefHit> CastAll(const RelevoVectors::Vector& origin,
    const RelevoVectors::Vector& direction, double least, double most) const;

  // Column and row of a point in world coordinates.
  std::array<double, 2> Find(const RelevoVectors::Vector& point) const;

private:
  using Four = std::array<double, 4>;
  Four ToTexel(const Four& world) const;
  RelevoVectors::Vector GetPoint(double column, double row, double depth) const;
  bool AreJoined(int column, int row, int otherColumn, int otherRow) const;
  double GetDepth(int column, int row) const { return this->Depths[row * this->Width + column]; }

  int Width = 0;
  int Height = 0;
  bool IsPerspective = false;
  double Stretch;
  double Matrix[16];
  double Inverse[16];
  std::vector<double> Depths;
  std::vector<std::array<int, 2>> Quads; // valid ones
};

#endif
