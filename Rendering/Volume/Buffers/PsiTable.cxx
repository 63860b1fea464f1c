// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/PsiTable.h"

#include "Integral/LinearSegment.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSMPTools.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <vector>

namespace relevo
{
namespace
{
// The depth that a texel is for; of the last ones, where it is infinite, one that is as good.
double GetDepth(vtkIdType texel)
{
  const double share = static_cast<double>(texel) / (PsiTable::Size - 1);
  return share < 1.0 ? share / (1.0 - share) : 1e6;
}

std::vector<float> Tabulate()
{
  std::vector<float> table(static_cast<size_t>(PsiTable::Size) * PsiTable::Size);
  vtkSMPTools::For(0, PsiTable::Size,
    [&table](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType back = first; back < last; ++back)
      {
        for (vtkIdType front = 0; front < PsiTable::Size; ++front)
        {
          table[back * PsiTable::Size + front] =
            static_cast<float>(linearSegmentPsi(GetDepth(front), GetDepth(back)));
        }
      }
    });
  return table;
}
}

PsiTable::PsiTable() = default;
PsiTable::~PsiTable() = default;

bool PsiTable::Upload(vtkOpenGLRenderWindow* window)
{
  std::vector<float> table = Tabulate();
  this->Texture = vtkSmartPointer<vtkTextureObject>::New();
  this->Texture->SetContext(window);
  this->Texture->SetMinificationFilter(vtkTextureObject::Linear);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  return this->Texture->Create2DFromRaw(Size, Size, 1, VTK_FLOAT, table.data());
}

void PsiTable::Activate(vtkShaderProgram* program)
{
  if (this->Texture && program->IsUniformUsed("psiTable"))
  {
    this->Texture->Activate();
    program->SetUniformi("psiTable", this->Texture->GetTextureUnit());
  }
}

void PsiTable::Deactivate()
{
  if (this->Texture)
  {
    this->Texture->Deactivate();
  }
}

void PsiTable::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture = nullptr;
  }
}

vtkTypeInt64 PsiTable::GetMemorySize() const
{
  return this->Texture ? static_cast<vtkTypeInt64>(sizeof(float)) * Size * Size : 0;
}
}
