// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Compute/RefinementComputeView.h"

#include "OpenGL/RelevoOpenGL.h"

#include <cstddef>

namespace relevo
{
namespace
{
// The sizes in integers, as in relevoGroupCS.glsl and OpenGL.
constexpr size_t GroupSize = 4;
constexpr size_t ElementsCommandSize = 5;
constexpr size_t ArraysCommandSize = 4;
}

bool RefinementComputeView::Resize(int numberOfFaces, int numberOfKeys)
{
  if (this->NumberOfFaces != numberOfFaces)
  {
    this->Singles.ReleaseGraphicsResources();
  }
  this->NumberOfFaces = numberOfFaces;
  this->NumberOfKeys = numberOfKeys;
  const size_t faces = sizeof(GLuint) * static_cast<size_t>(numberOfFaces);
  const size_t keys = sizeof(GLuint) * static_cast<size_t>(numberOfKeys);
  return this->Entries.Resize(faces) && this->Ranks.Resize(faces) &&
    this->Members.Resize(2 * faces) && this->Counts.Resize(keys) &&
    this->Groups.Resize(GroupSize * keys) && this->Triangles.Resize(ElementsCommandSize * keys) &&
    this->Others.Resize(3 * ArraysCommandSize * keys);
}

size_t RefinementComputeView::GetFirstCommand(Primitives primitives) const
{
  return primitives == TRIANGLES
    ? 0
    : ArraysCommandSize * static_cast<size_t>((primitives - LINES) * this->NumberOfKeys);
}

void RefinementComputeView::Draw(Primitives primitives) const
{
  const void* first =
    reinterpret_cast<const void*>(sizeof(GLuint) * this->GetFirstCommand(primitives));
  if (primitives == TRIANGLES)
  {
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, this->Triangles.GetHandle());
    glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, first, this->NumberOfKeys, 0);
  }
  else
  {
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, this->Others.GetHandle());
    glMultiDrawArraysIndirect(
      primitives == LINES ? GL_LINES : GL_POINTS, first, this->NumberOfKeys, 0);
  }
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

unsigned int RefinementComputeView::GetMembers(Primitives primitives)
{
  if (primitives == TRIANGLES)
  {
    return this->Members.GetHandle();
  }
  if (!this->Singles.GetHandle())
  {
    std::vector<GLuint> singles;
    singles.reserve(2 * static_cast<size_t>(this->NumberOfFaces));
    for (int face = 0; face < this->NumberOfFaces; ++face)
    {
      singles.push_back(static_cast<GLuint>(face));
      singles.push_back(1);
    }
    this->Singles.Upload(singles);
  }
  return this->Singles.GetHandle();
}

std::vector<unsigned int> RefinementComputeView::ReadEntries() const
{
  return this->Entries.Read<unsigned int>(static_cast<size_t>(this->NumberOfFaces));
}

std::vector<unsigned int> RefinementComputeView::ReadRanks() const
{
  return this->Ranks.Read<unsigned int>(static_cast<size_t>(this->NumberOfFaces));
}

std::vector<unsigned int> RefinementComputeView::ReadCounts() const
{
  return this->Counts.Read<unsigned int>(static_cast<size_t>(this->NumberOfKeys));
}

std::vector<unsigned int> RefinementComputeView::ReadCommands(Primitives primitives) const
{
  const bool triangles = primitives == TRIANGLES;
  return (triangles ? this->Triangles : this->Others)
    .Read<unsigned int>(static_cast<size_t>(this->NumberOfKeys) *
        (triangles ? ElementsCommandSize : ArraysCommandSize),
      this->GetFirstCommand(primitives));
}

vtkTypeInt64 RefinementComputeView::GetMemorySize() const
{
  vtkTypeInt64 size = 0;
  for (const RefinementComputeBuffer* buffer : { &this->Entries, &this->Counts, &this->Ranks,
         &this->Groups, &this->Members, &this->Singles, &this->Triangles, &this->Others })
  {
    size += buffer->GetMemorySize();
  }
  return size;
}

void RefinementComputeView::ReleaseGraphicsResources()
{
  for (RefinementComputeBuffer* buffer : { &this->Entries, &this->Counts, &this->Ranks,
         &this->Groups, &this->Members, &this->Singles, &this->Triangles, &this->Others })
  {
    buffer->ReleaseGraphicsResources();
  }
}
}
