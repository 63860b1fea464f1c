// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RankExchange
 * @brief   messages between the ranks that draw a view
 *
 * The functions are collective: all ranks call them in the same order. The root is rank 0, which
 * has the composited picture.
 *
 * Private to the module.
 */
#ifndef RankExchange_h
#define RankExchange_h

#include "vtkMultiProcessController.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace relevo
{
using Bytes = std::vector<std::uint8_t>;

class RankExchange
{
public:
  static constexpr int Root = 0;

  explicit RankExchange(vtkMultiProcessController* controller)
    : Controller(controller)
  {
  }

  bool IsRoot() const { return this->Controller->GetLocalProcessId() == Root; }
  int GetNumberOfRanks() const { return this->Controller->GetNumberOfProcesses(); }

  /// At one rank, return the messages of all ranks in their order. Other ranks get none.
  std::vector<Bytes> Gather(const Bytes& own, int at = Root) const;

  /// Give the root's values to all ranks. T has no pointers.
  template <typename T>
  void Broadcast(std::vector<T>& values) const
  {
    static_assert(std::is_trivially_copyable<T>::value, "only bytes are exchanged");
    auto size = static_cast<vtkIdType>(values.size());
    this->Controller->Broadcast(&size, 1, Root);
    values.resize(static_cast<std::size_t>(size));
    if (size > 0)
    {
      this->Controller->Broadcast(
        reinterpret_cast<char*>(values.data()), size * static_cast<vtkIdType>(sizeof(T)), Root);
    }
  }

  /// Return the values of all ranks in their order. T has no pointers.
  template <typename T>
  std::vector<T> Share(const T& own) const
  {
    static_assert(std::is_trivially_copyable<T>::value, "only bytes are exchanged");
    std::vector<T> all(static_cast<std::size_t>(this->GetNumberOfRanks()));
    this->Controller->AllGather(reinterpret_cast<const char*>(&own),
      reinterpret_cast<char*>(all.data()), static_cast<vtkIdType>(sizeof(T)));
    return all;
  }

private:
  vtkMultiProcessController* Controller;
};
}

#endif
