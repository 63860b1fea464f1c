// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PatternLibrary.h"

#include "Patterns/CanonicalOrder.h"
#include "Patterns/PatternFamily.h"
#include "Patterns/PatternStore.h"

#include <utility>

namespace relevo
{
PatternLibrary::PatternLibrary()
  : PatternLibrary(std::make_shared<PatternStore>())
{
}

PatternLibrary::PatternLibrary(std::shared_ptr<PatternStore> store)
  : HighestLevel(relevo::HighestLevel)
  , Store(std::move(store))
{
  this->MakeTime.Modified();
}

PatternLibrary::PatternLibrary(
  std::string fileName, int highestLevel, std::vector<RefinementPattern>&& canonical)
  : FileName(std::move(fileName))
  , HighestLevel(highestLevel)
  , Store(std::make_shared<PatternStore>(std::move(canonical)))
{
  this->MakeTime.Modified();
}

PatternLibrary::~PatternLibrary() = default;

std::string PatternLibrary::GetError(Families family) const
{
  if (this->FileName.empty() || family == POWERS_OF_TWO)
  {
    return {};
  }
  return "the pattern table was read from " + this->FileName +
    (family == WHOLE_NUMBERS
        ? ", whose patterns have 2^level segments per edge: call SetSegmentPolicyToPowersOfTwo()"
        : ", whose patterns cannot morph: call GeomorphingOff()") +
    ", or set another table with SetPatternTable()";
}

std::shared_ptr<const PatternFamily> PatternLibrary::GetFamily(Families family) const
{
  if (!this->GetError(family).empty())
  {
    return nullptr;
  }
  const auto i = static_cast<std::size_t>(family);
  std::call_once(this->Flags[i], [&] { this->Made[i] = this->MakeFamily(family); });
  return this->Made[i];
}

std::shared_ptr<const PatternFamily> PatternLibrary::MakeFamily(Families family) const
{
  using Steps = std::array<unsigned char, 3>;
  const auto store = this->Store;
  if (family == NESTED)
  {
    return std::make_shared<const PatternFamily>(SegmentSteps::MakePowersOfTwo(this->HighestLevel),
      PatternFamily::MORPHING,
      [store](const Steps& levels) {
        return store->GetNested({ levels[0], levels[1], levels[2] });
      });
  }
  const SegmentSteps segments = family == WHOLE_NUMBERS
    ? SegmentSteps::MakeWholeNumbers()
    : SegmentSteps::MakePowersOfTwo(this->HighestLevel);
  return std::make_shared<const PatternFamily>(segments, PatternFamily::CANONICAL,
    [store, segments](const Steps& steps)
    {
      return store->GetCanonical({ segments.GetSegments(steps[0]), segments.GetSegments(steps[1]),
        segments.GetSegments(steps[2]) });
    });
}

PatternLibrary::Pattern PatternLibrary::GetPatternOfSegments(int n1, int n2, int n3) const
{
  return this->Store->GetCanonical({ n1, n2, n3 });
}

vtkTypeInt64 PatternLibrary::GetMemorySize() const
{
  return this->Store->GetMemorySize();
}
}
