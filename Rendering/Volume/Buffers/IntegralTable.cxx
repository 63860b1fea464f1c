// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/IntegralTable.h"

#include "Integral/TransferFunctions.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSMPTools.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace relevo
{
namespace
{
// A tolerance for lengths, which vary by rounding while a volume rotates.
constexpr double LengthMargin = 1e-6;
constexpr double MaximumExtinction = 1e30;

// The pieces between the scalars at the front and at the back, in which the functions are linear.
class PreIntegration
{
public:
  PreIntegration(const TransferFunctions& functions, double front, double back)
    : Functions(functions)
    , Whole({ { { front } }, { { back } }, 1.0 })
  {
    const std::vector<double> cuts = functions.FindCuts(this->Whole.Front, this->Whole.Back);
    for (size_t i = 1; i < cuts.size(); ++i)
    {
      const Segment piece = this->Whole.Cut(cuts[i - 1], cuts[i]);
      const auto ends = functions.Evaluate(piece);
      this->Pieces.push_back({ ends[0], ends[1], piece.Length });
    }
  }

  dvec4 Integrate(double length) const
  {
    dvec4 seen(0.0);
    for (const Piece& piece : this->Pieces)
    {
      seen = frontOverBack(seen, linearSegment(piece.Front, piece.Back, piece.Share * length));
    }
    return seen;
  }

  // Return the mean extinction, and the mean colour that is visible of this length.
  dvec4 GetMean(double length) const
  {
    const double extinction = std::min(this->Functions.Sum(this->Whole).w, MaximumExtinction);
    const dvec4 seen = this->Integrate(length);
    const dvec3 color = seen.w > 0.0 ? dvec3(seen) / seen.w : dvec3(0.0);
    return extinction * dvec4(color, 1.0);
  }

private:
  struct Piece
  {
    dvec4 Front;
    dvec4 Back;
    double Share;
  };
  const TransferFunctions& Functions;
  const Segment Whole;
  std::vector<Piece> Pieces;
};

void Put(const dvec4& value, float* texel)
{
  for (int c = 0; c < 4; ++c)
  {
    texel[c] = static_cast<float>(value[c]);
  }
}

// Return layers of lengths, with rows of scalars at the back.
std::vector<float> Tabulate(
  const TransferFunctions& functions, const IntegralTable::Settings& settings)
{
  const vtkIdType size = settings.Size;
  const vtkIdType layers = settings.Is2D ? 1 : size;
  std::vector<float> table(static_cast<size_t>(4 * size * size * layers));
  const auto getScalar = [&](vtkIdType texel)
  {
    return settings.ScalarLow +
      settings.ScalarSize * static_cast<double>(texel) / static_cast<double>(size - 1);
  };
  vtkSMPTools::For(0, size * size,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const PreIntegration part(functions, getScalar(i % size), getScalar(i / size));
        for (vtkIdType layer = 0; layer < layers; ++layer)
        {
          const double share = static_cast<double>(layer) / static_cast<double>(size - 1);
          Put(settings.Is2D ? part.GetMean(0.5 * settings.Longest)
                            : part.Integrate(share * settings.Longest),
            &table[4 * (layer * size * size + i)]);
        }
      }
    });
  return table;
}
}

IntegralTable::IntegralTable() = default;
IntegralTable::~IntegralTable() = default;

bool IntegralTable::Upload(
  vtkOpenGLRenderWindow* window, const TransferFunctions& functions, const Settings& settings)
{
  this->ReleaseGraphicsResources(window);
  std::vector<float> table = Tabulate(functions, settings);
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
  const unsigned int size = static_cast<unsigned int>(settings.Size);
  if (settings.Is2D ? !texture->Create2DFromRaw(size, size, 4, VTK_FLOAT, table.data())
                    : !texture->Create3DFromRaw(size, size, size, 4, VTK_FLOAT, table.data()))
  {
    return false;
  }
  this->Texture = texture;
  this->Kept = settings;
  return true;
}

bool IntegralTable::Has(const Settings& settings) const
{
  return this->Texture && this->Kept.Size == settings.Size && this->Kept.Is2D == settings.Is2D &&
    this->Kept.ScalarLow == settings.ScalarLow && this->Kept.ScalarSize == settings.ScalarSize &&
    std::abs(this->Kept.Longest - settings.Longest) <= LengthMargin * settings.Longest;
}

void IntegralTable::Activate(vtkShaderProgram* program)
{
  if (this->Texture && program->IsUniformUsed("integrals"))
  {
    this->Texture->Activate();
    program->SetUniformi("integrals", this->Texture->GetTextureUnit());
    program->SetUniformf("tableSize", static_cast<float>(this->Kept.Size));
    if (!this->Kept.Is2D)
    {
      program->SetUniformf("longestPart", static_cast<float>(this->Kept.Longest));
    }
  }
}

void IntegralTable::Deactivate()
{
  if (this->Texture)
  {
    this->Texture->Deactivate();
  }
}

void IntegralTable::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture = nullptr;
  }
}

vtkTypeInt64 IntegralTable::GetMemorySize() const
{
  const vtkTypeInt64 size = this->Kept.Size;
  return this->Texture
    ? static_cast<vtkTypeInt64>(4 * sizeof(float)) * size * size * (this->Kept.Is2D ? 1 : size)
    : 0;
}
}
