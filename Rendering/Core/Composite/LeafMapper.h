// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LeafMapper
 * @brief   the leaves of a mapper's input by flat index, with the painters that draw them
 *
 * `Leaf` is the data that a mapper stores of one leaf. It has a type Painter of reference-counted
 * objects, and GetPainters(), which returns a vector of pointers to those that draw the leaf. A
 * painter has a type Counts, whose numbers only grow and can be added by +=, GetCounts(),
 * GetMemorySize() and ReleaseGraphicsResources(). Copies of a leaf share its painters. Private to
 * the modules.
 */
#ifndef LeafMapper_h
#define LeafMapper_h

#include "Composite/LeafSelection.h"
#include "vtkType.h" // for numbers

#include <algorithm> // for find
#include <map>       // for members
#include <utility>   // for move
#include <vector>    // for painters

class vtkRenderer;
class vtkWindow;

namespace relevo
{
template <typename Leaf>
class LeafMapper
{
public:
  using Painter = typename Leaf::Painter;
  using Counts = typename Painter::Counts;
  using Leaves = std::map<unsigned int, Leaf>;

  /**
   * Call update(item, leaf) for each item, which has a FlatIndex. The leaf is the previous one with
   * this index, or a new one. Painters that are no longer in use release their resources in the
   * window. An exception leaves everything unchanged.
   */
  template <typename Items, typename UpdateLeaf>
  void Update(const Items& items, vtkWindow* window, const UpdateLeaf& update)
  {
    Leaves leaves;
    for (auto& item : items)
    {
      Leaf& leaf = leaves[item.FlatIndex];
      const auto last = this->Current.find(item.FlatIndex);
      if (last != this->Current.end())
      {
        leaf = last->second;
      }
      update(item, leaf);
    }
    const std::vector<Painter*> inUse = FindPainters(leaves);
    for (Painter* painter : this->GetPainters())
    {
      if (std::find(inUse.begin(), inUse.end(), painter) == inUse.end())
      {
        this->Retire(painter, window);
      }
    }
    this->Current.swap(leaves);
  }

  /// Add a painter's counts to the retired ones and release its resources, before it is deleted;
  /// nullptr is ignored.
  void Retire(Painter* painter, vtkWindow* window)
  {
    if (painter)
    {
      this->Retired += painter->GetCounts();
      painter->ReleaseGraphicsResources(window);
    }
  }

  /**
   * Call draw(leaf) for all leaves as one prop. In a selection, each leaf has its flat index as
   * composite index.
   */
  template <typename DrawLeaf>
  void Render(vtkRenderer* renderer, const DrawLeaf& draw)
  {
    LeafSelection selection(renderer);
    for (auto& entry : this->Current)
    {
      selection.Begin(entry.first);
      draw(entry.second);
    }
  }

  Leaves& GetLeaves() { return this->Current; }
  Leaf* Find(unsigned int flatIndex)
  {
    const auto found = this->Current.find(flatIndex);
    return found == this->Current.end() ? nullptr : &found->second;
  }

  std::vector<Painter*> GetPainters() const { return FindPainters(this->Current); }

  /// Return the sum of getNumber(leaf).
  template <typename GetNumber>
  vtkIdType Sum(const GetNumber& getNumber) const
  {
    vtkIdType sum = 0;
    for (const auto& entry : this->Current)
    {
      sum += getNumber(entry.second);
    }
    return sum;
  }

  /// Return the counts of all current and former painters.
  Counts GetCounts() const
  {
    Counts counts = this->Retired;
    for (Painter* painter : this->GetPainters())
    {
      counts += painter->GetCounts();
    }
    return counts;
  }

  vtkTypeInt64 GetMemorySize() const
  {
    vtkTypeInt64 size = 0;
    for (Painter* painter : this->GetPainters())
    {
      size += painter->GetMemorySize();
    }
    return size;
  }

  void ReleaseGraphicsResources(vtkWindow* window)
  {
    for (Painter* painter : this->GetPainters())
    {
      painter->ReleaseGraphicsResources(window);
    }
  }

private:
  static std::vector<Painter*> FindPainters(const Leaves& leaves)
  {
    std::vector<Painter*> all;
    for (const auto& entry : leaves)
    {
      const std::vector<Painter*> painters = entry.second.GetPainters();
      all.insert(all.end(), painters.begin(), painters.end());
    }
    return all;
  }

  Leaves Current;
  Counts Retired; // of deleted painters
};
}

#endif
