// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurvedScalars
 * @brief   splits a ray into parts along which scalars are nearly linear
 *
 * Private to the module.
 */
#ifndef CurvedScalars_h
#define CurvedScalars_h

#include "Integral/Ray.h"

#include <functional>
#include <vector>

namespace relevo
{
class CurvedScalars
{
public:
  /**
   * `get` returns the scalars at a distance along the ray. Parts are halved, at most 10 times,
   * until they are linear to 1/8192 of the range of the corner scalars. Parts end at extrema, so
   * that the largest and smallest scalars are at ends of parts.
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
