// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Heights/NoDataFill.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <vector>

namespace relevo
{
namespace
{
// Relaxations per level. Each one halves the error of interpolation from the coarser level.
constexpr int NumberOfRelaxations = 4;

// A level of the pyramid. The finest level refers to the samples of the caller.
struct Level
{
  int Width;
  int Height;
  float* Samples;
  const unsigned char* Validity;

  std::size_t Index(int x, int y) const { return static_cast<std::size_t>(y) * this->Width + x; }
};

struct OwnedLevel
{
  std::vector<float> Samples;
  std::vector<unsigned char> Validity;
  Level View;

  OwnedLevel(int width, int height)
    : Samples(static_cast<std::size_t>(width) * height)
    , Validity(Samples.size())
    , View{ width, height, Samples.data(), Validity.data() }
  {
  }
};

// A coarse sample is the mean of the valid samples among the 2 x 2 that it covers.
void push(const Level& fine, OwnedLevel& coarse)
{
  vtkSMPTools::For(0, coarse.View.Height,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int y = static_cast<int>(begin); y < end; ++y)
      {
        for (int x = 0; x < coarse.View.Width; ++x)
        {
          double sum = 0.0;
          int count = 0;
          for (int fineY = 2 * y; fineY < std::min(2 * y + 2, fine.Height); ++fineY)
          {
            for (int fineX = 2 * x; fineX < std::min(2 * x + 2, fine.Width); ++fineX)
            {
              const std::size_t index = fine.Index(fineX, fineY);
              if (fine.Validity[index])
              {
                sum += fine.Samples[index];
                ++count;
              }
            }
          }
          const std::size_t index = coarse.View.Index(x, y);
          coarse.Samples[index] = count ? static_cast<float>(sum / count) : 0.0f;
          coarse.Validity[index] = count > 0;
        }
      }
    });
}

// Interpolates bilinearly from the coarser level, whose sample centres are in the middle of four
// fine samples.
void pull(const Level& coarse, const Level& fine)
{
  vtkSMPTools::For(0, fine.Height,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int y = static_cast<int>(begin); y < end; ++y)
      {
        const int nearY = y / 2;
        const int farY = std::clamp(y % 2 ? nearY + 1 : nearY - 1, 0, coarse.Height - 1);
        for (int x = 0; x < fine.Width; ++x)
        {
          const std::size_t index = fine.Index(x, y);
          if (!fine.Validity[index])
          {
            const int nearX = x / 2;
            const int farX = std::clamp(x % 2 ? nearX + 1 : nearX - 1, 0, coarse.Width - 1);
            fine.Samples[index] = 0.5625f * coarse.Samples[coarse.Index(nearX, nearY)] +
              0.1875f * coarse.Samples[coarse.Index(farX, nearY)] +
              0.1875f * coarse.Samples[coarse.Index(nearX, farY)] +
              0.0625f * coarse.Samples[coarse.Index(farX, farY)];
          }
        }
      }
    });
}

// Gauss-Seidel in red-black order: each sample becomes the mean of its grid neighbours.
void relax(const Level& level)
{
  for (int sweep = 0; sweep < 2 * NumberOfRelaxations; ++sweep)
  {
    vtkSMPTools::For(0, level.Height,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (int y = static_cast<int>(begin); y < end; ++y)
        {
          for (int x = (y + sweep) % 2; x < level.Width; x += 2)
          {
            const std::size_t index = level.Index(x, y);
            if (level.Validity[index])
            {
              continue;
            }
            float sum = 0.0f;
            int count = 0;
            const auto add = [&](bool inside, std::size_t neighbour)
            {
              if (inside)
              {
                sum += level.Samples[neighbour];
                ++count;
              }
            };
            add(x > 0, index - 1);
            add(x + 1 < level.Width, index + 1);
            add(y > 0, index - level.Width);
            add(y + 1 < level.Height, index + level.Width);
            if (count)
            {
              level.Samples[index] = sum / static_cast<float>(count);
            }
          }
        }
      });
  }
}

void fill(const Level& level)
{
  const std::size_t size = static_cast<std::size_t>(level.Width) * level.Height;
  if (std::find(level.Validity, level.Validity + size, 0) == level.Validity + size)
  {
    return;
  }
  if (level.Width > 1 || level.Height > 1)
  {
    OwnedLevel coarse((level.Width + 1) / 2, (level.Height + 1) / 2);
    push(level, coarse);
    fill(coarse.View);
    pull(coarse.View, level);
    relax(level);
  }
}
}

void FillNoData(int width, int height, float* samples, const unsigned char* validity)
{
  fill(Level{ width, height, samples, validity });
}
}
