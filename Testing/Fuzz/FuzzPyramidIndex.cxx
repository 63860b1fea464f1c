// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Indices of raster pyramids (.relevo-index). The target adds the header and the checksum, which
// random bytes would never have.
#include "Pyramid/Checksum.h"
#include "Pyramid/PyramidIndex.h"
#include "RelevoFuzzAssert.h"
#include "RelevoFuzzFolder.h"

#include <cmath>

namespace
{
const std::vector<std::array<int, 2>> Sizes = { { { 1000, 700 } }, { { 500, 350 } },
  { { 250, 175 } } };
const std::string Signature = "signature";

std::string Complete(const unsigned char* bytes, size_t size)
{
  std::string file = "relevo pyramid index 3\n" + Signature + "\n";
  file.append(reinterpret_cast<const char*>(bytes), size);
  const std::uint64_t checksum = relevo::GetChecksum(file);
  return file.append(reinterpret_cast<const char*>(&checksum), sizeof(checksum));
}

// Asks for everything that an index knows.
void Ask(const relevo::PyramidIndex& index)
{
  for (int level = 0; level < static_cast<int>(Sizes.size()); ++level)
  {
    double range[2];
    FUZZ_ASSERT(!std::isnan(index.GetMaximumDeviation(level)));
    FUZZ_ASSERT(!index.GetRange(level, range) || range[0] <= range[1]);
    index.Find(level, 1, 1);
  }
  FUZZ_ASSERT(index.GetMemorySize() >= 0);
  index.MakeElevationRanges(-2.0, 1.0).Get(3, { { 0.0, 900.0 } }, { { 0.0, 600.0 } });
  const relevo::BlockErrors& errors = *index.GetBlockErrors();
  for (int level = relevo::BlockErrors::FinestLevel; level <= errors.GetRootLevel() + 1; ++level)
  {
    FUZZ_ASSERT(errors.GetSquareError(level, 0, 0) >= 0.0f);
    FUZZ_ASSERT(errors.GetEdgeError(level, 1, 0, 0) >= 0.0f);
    FUZZ_ASSERT(errors.GetEdgeError(level, 0, 1, 1) >= 0.0f);
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, size_t size)
{
  static const RelevoFuzzFolder folder;
  relevo::PyramidIndex index(Sizes);
  const std::string file = folder.Write("a.relevo-index", Complete(bytes, size));
  if (!index.Read(file, Signature))
  {
    return 0;
  }
  Ask(index);
  const std::string again = folder.GetFile("b.relevo-index");
  FUZZ_ASSERT(index.Write(again, Signature).empty());
  relevo::PyramidIndex other(Sizes);
  FUZZ_ASSERT(other.Read(again, Signature));
  return 0;
}
