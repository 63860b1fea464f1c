// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pairs/PairSearch.h"

#include "Exact/ExactPredicates.h"
#include "Mesh/MovedSurface.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace relevo
{
namespace
{
using NodePair = std::pair<vtkIdType, vtkIdType>;

class Search
{
public:
  Search(const MovedSurface& first, const MovedSurface& second)
    : First(first)
    , Second(second)
    , IsSelf(&first == &second)
  {
  }

  std::vector<IntersectingPair> Run() const
  {
    if (this->First.GetTree().GetNodes().empty() || this->Second.GetTree().GetNodes().empty())
    {
      return {};
    }
    const std::vector<NodePair> tasks = this->MakeTasks();
    std::vector<std::vector<IntersectingPair>> found(tasks.size());
    vtkSMPTools::For(0, static_cast<vtkIdType>(tasks.size()), 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          this->Visit(tasks[i], found[i]);
        }
      });
    std::vector<IntersectingPair> pairs;
    for (const std::vector<IntersectingPair>& part : found)
    {
      pairs.insert(pairs.end(), part.begin(), part.end());
    }
    vtkSMPTools::Sort(pairs.begin(), pairs.end());
    return pairs;
  }

private:
  const DoubleBoxTree::Node& GetFirst(const NodePair& pair) const
  {
    return this->First.GetTree().GetNodes()[pair.first];
  }
  const DoubleBoxTree::Node& GetSecond(const NodePair& pair) const
  {
    return this->Second.GetTree().GetNodes()[pair.second];
  }

  // Returns pairs of nodes to distribute to threads. They do not depend on the number of threads.
  std::vector<NodePair> MakeTasks() const
  {
    constexpr std::size_t enough = 512;
    std::vector<NodePair> tasks{ { 0, 0 } };
    bool isSplit = true;
    while (isSplit && tasks.size() < enough)
    {
      isSplit = false;
      std::vector<NodePair> next;
      for (const NodePair& task : tasks)
      {
        const bool isLeaf = this->AreLeaves(task);
        isSplit = isSplit || !isLeaf;
        if (isLeaf)
        {
          next.push_back(task);
        }
        else
        {
          this->Split(task, next);
        }
      }
      tasks = std::move(next);
    }
    return tasks;
  }

  bool AreLeaves(const NodePair& pair) const
  {
    return this->GetFirst(pair).Count > 0 && this->GetSecond(pair).Count > 0;
  }

  // Adds the pairs of children whose boxes intersect.
  void Split(const NodePair& pair, std::vector<NodePair>& pairs) const
  {
    const DoubleBoxTree::Node& first = this->GetFirst(pair);
    const DoubleBoxTree::Node& second = this->GetSecond(pair);
    if (this->IsSelf && pair.first == pair.second)
    {
      pairs.emplace_back(pair.first + 1, pair.first + 1);
      pairs.emplace_back(first.First, first.First);
      this->AddIfMeeting({ pair.first + 1, first.First }, pairs);
      return;
    }
    const bool splitsFirst = second.Count > 0 ||
      (first.Count == 0 && first.Bounds.GetSumOfLengths() >= second.Bounds.GetSumOfLengths());
    if (splitsFirst)
    {
      this->AddIfMeeting({ pair.first + 1, pair.second }, pairs);
      this->AddIfMeeting({ first.First, pair.second }, pairs);
    }
    else
    {
      this->AddIfMeeting({ pair.first, pair.second + 1 }, pairs);
      this->AddIfMeeting({ pair.first, second.First }, pairs);
    }
  }

  void AddIfMeeting(const NodePair& pair, std::vector<NodePair>& pairs) const
  {
    if (this->GetFirst(pair).Bounds.Intersects(this->GetSecond(pair).Bounds))
    {
      pairs.push_back(pair);
    }
  }

  void Visit(const NodePair& root, std::vector<IntersectingPair>& found) const
  {
    std::vector<NodePair> stack{ root };
    while (!stack.empty())
    {
      const NodePair pair = stack.back();
      stack.pop_back();
      if (this->AreLeaves(pair))
      {
        this->VisitLeaves(pair, found);
      }
      else
      {
        this->Split(pair, stack);
      }
    }
  }

  void VisitLeaves(const NodePair& pair, std::vector<IntersectingPair>& found) const
  {
    const DoubleBoxTree& firstTree = this->First.GetTree();
    const DoubleBoxTree& secondTree = this->Second.GetTree();
    const DoubleBoxTree::Node& first = this->GetFirst(pair);
    const DoubleBoxTree::Node& second = this->GetSecond(pair);
    const bool isSameLeaf = this->IsSelf && pair.first == pair.second;
    for (vtkIdType i = first.First; i < first.First + first.Count; ++i)
    {
      const vtkIdType begin = isSameLeaf ? i + 1 : second.First;
      for (vtkIdType j = begin; j < second.First + second.Count; ++j)
      {
        if (firstTree.GetBox(i).Intersects(secondTree.GetBox(j)))
        {
          this->Intersect(firstTree.GetItem(i), secondTree.GetItem(j), found);
        }
      }
    }
  }

  void Intersect(vtkIdType first, vtkIdType second, std::vector<IntersectingPair>& found) const
  {
    if (!this->First.HasArea(first) || !this->Second.HasArea(second))
    {
      return;
    }
    if (this->IsSelf && second < first)
    {
      std::swap(first, second);
    }
    if (this->IsSelf && this->AreOnlyNeighbors(first, second))
    {
      return;
    }
    IntersectingPair pair;
    pair.Triangles[0] = first;
    pair.Triangles[1] = second;
    pair.Common = IntersectTriangles(this->First.GetPoints(first), this->Second.GetPoints(second));
    if (pair.Common.Count > 0 && !(this->IsSelf && this->IsShared(pair)))
    {
      found.push_back(pair);
    }
  }

  // Whether two triangles share an edge and are not coplanar, which is the most common case.
  bool AreOnlyNeighbors(vtkIdType first, vtkIdType second) const
  {
    const auto& a = this->First.GetCorners(first);
    const auto& b = this->First.GetCorners(second);
    int shared = 0;
    int own = 0;
    for (int i = 0; i < 3; ++i)
    {
      const bool isShared = std::find(a.begin(), a.end(), b[i]) != a.end();
      shared += isShared;
      own = isShared ? own : i;
    }
    const auto points = this->First.GetPoints(first);
    return shared == 2 &&
      Orient3D(points[0], points[1], points[2], this->First.GetPoint(b[own])) != 0;
  }

  // Whether the intersection is only a shared corner or edge.
  bool IsShared(const IntersectingPair& pair) const
  {
    const CommonPoints& common = pair.Common;
    for (int i = 0; i < common.Count; ++i)
    {
      const auto& parts = common.Points[i].Parts;
      if (!IsCorner(parts[0]) || !IsCorner(parts[1]) ||
        this->First.GetCorners(pair.Triangles[0])[parts[0]] !=
          this->First.GetCorners(pair.Triangles[1])[parts[1]])
      {
        return false;
      }
    }
    return common.Count < 3;
  }

  const MovedSurface& First;
  const MovedSurface& Second;
  const bool IsSelf;
};
}

std::vector<IntersectingPair> FindMeetingPairs(
  const MovedSurface& first, const MovedSurface& second)
{
  return Search(first, second).Run();
}
}
