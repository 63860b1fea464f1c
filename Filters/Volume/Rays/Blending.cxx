// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Rays/Blending.h"

namespace relevo
{
dvec4 BlendComposite(const TransferFunctions& functions, const std::vector<RayPart>& parts)
{
  dvec4 seen(0.0);
  for (const RayPart& part : parts)
  {
    seen = frontOverBack(seen, functions.Integrate(part.Front, part.Back, part.End - part.Begin));
  }
  return seen;
}
}
