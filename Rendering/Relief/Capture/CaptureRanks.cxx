// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/CaptureRanks.h"

#include "Capture/CaptureTarget.h"
#include "Capture/CapturedImage.h"
#include "Parallel/ProcessReduction.h"

#include "vtkMultiProcessController.h"

#include <algorithm>
#include <utility>

namespace relevo
{
namespace
{
constexpr int Tag = 7301; // of messages

// The drawn pixels of a rank, without the empty ones around them.
struct DrawnPixels
{
  int Window[4] = { 0, 0, 0, 0 }; // first column and row, and one past the last ones
  std::vector<unsigned char> Colors;
  std::vector<float> Depths; // z-buffer, and the two depths of the shader

  vtkIdType Count() const
  {
    return static_cast<vtkIdType>(this->Window[2] - this->Window[0]) *
      (this->Window[3] - this->Window[1]);
  }

  void Resize()
  {
    this->Colors.resize(static_cast<std::size_t>(3 * this->Count()));
    this->Depths.resize(static_cast<std::size_t>(3 * this->Count()));
  }
};

template <class Visitor>
void VisitPixels(const DrawnPixels& drawn, int width, const Visitor& visit)
{
  std::size_t i = 0;
  for (int row = drawn.Window[1]; row < drawn.Window[3]; ++row)
  {
    for (int column = drawn.Window[0]; column < drawn.Window[2]; ++column)
    {
      visit(i++, static_cast<std::size_t>(row) * width + column);
    }
  }
}

void Send(const CapturedPixels& pixels, int rank, vtkMultiProcessController* controller)
{
  DrawnPixels drawn;
  const PixelWindow window = FindDrawn(pixels);
  if (window.End[0] > 0)
  {
    std::copy_n(window.Begin, 2, drawn.Window);
    std::copy_n(window.End, 2, drawn.Window + 2);
  }
  drawn.Resize();
  VisitPixels(drawn, pixels.Width,
    [&](std::size_t to, std::size_t from)
    {
      std::copy_n(&pixels.Colors[3 * from], 3, &drawn.Colors[3 * to]);
      drawn.Depths[3 * to] = pixels.ZBuffer[from];
      std::copy_n(&pixels.Depths[2 * from], 2, &drawn.Depths[3 * to + 1]);
    });
  controller->Send(drawn.Window, 4, rank, Tag);
  if (drawn.Count() > 0)
  {
    controller->Send(drawn.Colors.data(), 3 * drawn.Count(), rank, Tag);
    controller->Send(drawn.Depths.data(), 3 * drawn.Count(), rank, Tag);
  }
}

void Receive(CapturedPixels& pixels, int rank, vtkMultiProcessController* controller)
{
  DrawnPixels drawn;
  controller->Receive(drawn.Window, 4, rank, Tag);
  if (drawn.Count() == 0)
  {
    return;
  }
  drawn.Resize();
  controller->Receive(drawn.Colors.data(), 3 * drawn.Count(), rank, Tag);
  controller->Receive(drawn.Depths.data(), 3 * drawn.Count(), rank, Tag);
  VisitPixels(drawn, pixels.Width,
    [&](std::size_t from, std::size_t to)
    {
      if (drawn.Depths[3 * from] < pixels.ZBuffer[to])
      {
        std::copy_n(&drawn.Colors[3 * from], 3, &pixels.Colors[3 * to]);
        pixels.ZBuffer[to] = drawn.Depths[3 * from];
        std::copy_n(&drawn.Depths[3 * from + 1], 2, &pixels.Depths[2 * to]);
      }
    });
}
}

bool CaptureRanks::AreSeveral() const
{
  return this->Controller && this->Controller->GetNumberOfProcesses() > 1;
}

bool CaptureRanks::IsAny(bool value) const
{
  if (!this->AreSeveral())
  {
    return value;
  }
  std::vector<double> number = { value ? 1.0 : 0.0 };
  ProcessReduction(this->Controller).TakeLargest(number);
  return number[0] > 0.0;
}

std::vector<double> CaptureRanks::GetFirst(std::vector<double> numbers) const
{
  if (this->AreSeveral())
  {
    this->Controller->Broadcast(numbers.data(), static_cast<vtkIdType>(numbers.size()), 0);
  }
  return numbers;
}

std::vector<dvec3> CaptureRanks::Collect(const std::vector<dvec3>& points) const
{
  if (!this->AreSeveral())
  {
    return points;
  }
  std::vector<double> numbers;
  for (const dvec3& point : points)
  {
    numbers.insert(numbers.end(), { point.x, point.y, point.z });
  }
  numbers = ProcessReduction(this->Controller).Collect(std::move(numbers));
  std::vector<dvec3> all;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
  {
    all.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
  return all;
}

// In each round, half of the ranks send their pixels to the other half.
void CaptureRanks::Composite(CapturedPixels& pixels) const
{
  if (!this->AreSeveral())
  {
    return;
  }
  const int rank = this->Controller->GetLocalProcessId();
  const int number = this->Controller->GetNumberOfProcesses();
  for (int step = 1; step < number; step *= 2)
  {
    if (rank % (2 * step) != 0)
    {
      Send(pixels, rank - step, this->Controller);
      return;
    }
    if (rank + step < number)
    {
      Receive(pixels, rank + step, this->Controller);
    }
  }
}
}
