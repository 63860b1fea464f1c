// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurvedScalars
 * @brief   scalars that do not change linearly along a ray, in parts in which they do
 *
 * Private to the module's own sources.
 */
#ifndef CurvedScalars_h
#define CurvedScalars_h

#include "Cells/Ray.h"

#include <functional>
#include <vector>

namespace relevo
{
class CurvedScalars
{
public:
  /**
   * `get` gives the scalars at a distance along the ray. Parts are halved until they are within
   * 1/8192 of how far apart the scalars of the corners are, or 2^10 of them. They end where a
   * scalar turns round, so that its extremes are those of ends.
   */
  CurvedScalars(std::function<Scalars(double)> get, const std::vector<Scalars>& corners);

  void Split(double begin, double end, std::vector<RayPart>& parts) const;

private:
  void Split(const RayPart& part, int depth, std::vector<RayPart>& parts) const;
  void AddTurns(const RayPart& part, const Scalars& middle, std::vector<RayPart>& parts) const;
  bool FindTurn(const RayPart& part, const Scalars& middle, size_t component, double& turn) const;

  std::function<Scalars(double)> Get;
  Scalars Tolerance;
  Scalars Rounding;
};
}

#endif
