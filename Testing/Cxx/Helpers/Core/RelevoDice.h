// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Random choices that are the same on every machine for the same seed.
#ifndef RelevoDice_h
#define RelevoDice_h

#include <random>

class RelevoDice
{
public:
  explicit RelevoDice(unsigned int seed)
    : Random(seed)
  {
  }
  // Returns 0 to sides - 1.
  int Throw(int sides)
  {
    return static_cast<int>(this->Random() % static_cast<unsigned int>(sides));
  }
  // Returns true once in `sides` times.
  bool Once(int sides) { return this->Throw(sides) == 0; }
  double Share() { return this->Random() / 4294967296.0; }
  double Signed() { return 2.0 * this->Share() - 1.0; }

private:
  std::mt19937 Random;
};

#endif
