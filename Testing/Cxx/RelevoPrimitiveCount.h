// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// How many primitives OpenGL itself makes of what a mapper draws.
#ifndef RelevoPrimitiveCount_h
#define RelevoPrimitiveCount_h

#include "RelevoScene.h"

#include "vtkCommand.h"
#include "vtkRelevoOpenGL.h"

// Counts as long as it lives: from the mapper's shaders on to the end of the renderer's frame, so
// the mapper must be the last to draw.
class RelevoPrimitiveCount
{
public:
  RelevoPrimitiveCount(vtkAdaptiveRefinementMapper* mapper, vtkRenderer* renderer)
    : Mapper(mapper)
    , Renderer(renderer)
    , Begin(
        mapper->AddObserver(vtkCommand::UpdateShaderEvent, this, &RelevoPrimitiveCount::BeginQuery))
    , End(renderer->AddObserver(vtkCommand::EndEvent, this, &RelevoPrimitiveCount::EndQuery))
  {
  }
  ~RelevoPrimitiveCount()
  {
    this->Mapper->RemoveObserver(this->Begin);
    this->Renderer->RemoveObserver(this->End);
  }
  RelevoPrimitiveCount(const RelevoPrimitiveCount&) = delete;
  void operator=(const RelevoPrimitiveCount&) = delete;

  // Of the last frame.
  vtkIdType GetCount() const { return this->Count; }

private:
  void BeginQuery()
  {
    if (!this->Query)
    {
      glGenQueries(1, &this->Query);
      glBeginQuery(GL_PRIMITIVES_GENERATED, this->Query);
    }
  }
  void EndQuery()
  {
    this->Count = 0;
    if (this->Query)
    {
      GLuint count = 0;
      glEndQuery(GL_PRIMITIVES_GENERATED);
      glGetQueryObjectuiv(this->Query, GL_QUERY_RESULT, &count);
      glDeleteQueries(1, &this->Query);
      this->Query = 0;
      this->Count = count;
    }
  }

  vtkAdaptiveRefinementMapper* Mapper;
  vtkRenderer* Renderer;
  unsigned long Begin;
  unsigned long End;
  GLuint Query = 0;
  vtkIdType Count = 0;
};

#endif
