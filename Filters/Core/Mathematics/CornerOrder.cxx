// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mathematics/CornerOrder.h"

namespace relevo
{
const std::array<int, 3>& GetCornerOrder(int code)
{
  static const std::array<std::array<int, 3>, 6> orders = { { { { 0, 1, 2 } }, { { 1, 0, 2 } },
    { { 1, 2, 0 } }, { { 0, 2, 1 } }, { { 2, 0, 1 } }, { { 2, 1, 0 } } } };
  return orders[code];
}

int GetCornerOrderCode(int first, int second, int third)
{
  const std::array<int, 3> order = { { first, second, third } };
  int code = 0;
  while (GetCornerOrder(code) != order)
  {
    ++code;
  }
  return code;
}
}
