// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/RefinementStream.h"

#include "OpenGL/RelevoOpenGL.h"

#include "relevoSplit.h"
#include "relevoSplitGS.h"
#include "relevoSplitVS.h"

#include "Buffers/RefinementLevelTable.h"
#include "Evaluation/PatternSelection.h"
#include "Mesh/RefinementMesh.h"
#include "OpenGL/ShaderLog.h"
#include "Patterns/TriangleSplit.h"
#include "State/ViewSelection.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>

namespace relevo
{
namespace
{
using Vertex = RefinementStreamVertex;

// The locations of the shader's attributes.
enum Attributes : GLuint
{
  WEIGHTS,
  FACE
};

constexpr const char* Header = "#version 150\n"
                               "#define RELEVO_FUNCTION\n";

// A face's corners in the order of its cell, and the levels of the edges between them.
struct CoarseTriangle
{
  int Corners[3];
  TriangleSplit::Levels Left;
};

CoarseTriangle MakeCoarseTriangle(const RefinementFace& face, const FacePattern& pattern)
{
  int segments[3];
  pattern.GetEdgeSegments(segments);
  int levels[3];
  std::transform(segments, segments + 3, levels, RefinementLevelTable::GetLevel);
  return face.IsTurned() ? CoarseTriangle{ { 0, 2, 1 }, { { levels[2], levels[1], levels[0] } } }
                         : CoarseTriangle{ { 0, 1, 2 }, { { levels[0], levels[1], levels[2] } } };
}

GLuint MakeBuffer(vtkIdType triangles, const Vertex* vertices)
{
  GLuint handle = 0;
  glGenBuffers(1, &handle);
  glBindBuffer(GL_ARRAY_BUFFER, handle);
  glBufferData(GL_ARRAY_BUFFER,
    static_cast<GLsizeiptr>(3 * std::max<vtkIdType>(triangles, 1) * sizeof(Vertex)), vertices,
    vertices ? GL_STATIC_DRAW : GL_STATIC_COPY);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  return handle;
}
}

//------------------------------------------------------------------------------
// The pass

bool RefinementSplitProgram::Build(std::string& error)
{
  if (this->Handle)
  {
    return true;
  }
  const GLuint vertex =
    CompileShader(GL_VERTEX_SHADER, "splitting vertex", std::string(Header) + relevoSplitVS, error);
  const GLuint geometry = CompileShader(GL_GEOMETRY_SHADER, "splitting geometry",
    std::string(Header) + relevoSplit + relevoSplitGS, error);
  this->Handle = glCreateProgram();
  for (GLuint shader : { vertex, geometry })
  {
    if (shader)
    {
      glAttachShader(this->Handle, shader);
      glDeleteShader(shader); // deleted together with the program
    }
  }
  glBindAttribLocation(this->Handle, WEIGHTS, "relevoWeights");
  glBindAttribLocation(this->Handle, FACE, "relevoFace");
  const GLchar* outputs[] = { "relevoWeightsGSOutput", "relevoFaceGSOutput" };
  glTransformFeedbackVaryings(this->Handle, 2, outputs, GL_INTERLEAVED_ATTRIBS);
  if (!vertex || !geometry || !LinkProgram(this->Handle, "splitting", error))
  {
    this->ReleaseGraphicsResources();
    return false;
  }
  glGenVertexArrays(1, &this->VertexArray);
  return true;
}

void RefinementSplitProgram::Run(
  unsigned int source, vtkIdType triangles, unsigned int target) const
{
  glUseProgram(this->Handle);
  glBindVertexArray(this->VertexArray);
  glBindBuffer(GL_ARRAY_BUFFER, source);
  glEnableVertexAttribArray(WEIGHTS);
  glVertexAttribPointer(WEIGHTS, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
  glEnableVertexAttribArray(FACE);
  glVertexAttribIPointer(FACE, 1, GL_UNSIGNED_INT, sizeof(Vertex),
    reinterpret_cast<const void*>(offsetof(Vertex, Face)));
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, target);
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_TRIANGLES);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * triangles));
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  glBindVertexArray(0);
  glUseProgram(0);
}

void RefinementSplitProgram::ReleaseGraphicsResources()
{
  if (this->Handle)
  {
    glDeleteProgram(this->Handle);
    this->Handle = 0;
  }
  if (this->VertexArray)
  {
    glDeleteVertexArrays(1, &this->VertexArray);
    this->VertexArray = 0;
  }
}

//------------------------------------------------------------------------------
// The stream

bool RefinementStream::Refine(vtkOpenGLRenderWindow* window, const RefinementMesh& mesh,
  const PatternSelection& selection, RefinementSplitProgram& program, std::string& error)
{
  this->ReleaseGraphicsResources();
  const std::vector<unsigned int>& instances = selection.Instances;
  std::vector<Vertex> vertices;
  vertices.reserve(3 * instances.size());
  std::map<TriangleSplit::Levels, vtkIdType> faces; // by their levels
  for (unsigned int instance : instances)
  {
    const unsigned int face = instance >> 3;
    const CoarseTriangle triangle =
      MakeCoarseTriangle(mesh.Faces[face], selection.GetFacePattern(static_cast<int>(face)));
    for (size_t k = 0; k < 3; ++k)
    {
      Vertex vertex{ { 0.0f, 0.0f, 0.0f },
        face << 3 | static_cast<unsigned int>(triangle.Left[k]) };
      vertex.Weights[triangle.Corners[k]] = 1.0f;
      vertices.push_back(vertex);
    }
    ++faces[triangle.Left];
  }
  TriangleSplit split;
  TriangleSplit::Counts counts{};
  int steps = 0;
  for (const auto& group : faces)
  {
    const TriangleSplit::Counts& each = split.Count(group.first);
    for (size_t step = 0; step < counts.size(); ++step)
    {
      counts[step] += group.second * each[step];
    }
    steps = std::max(steps, *std::max_element(group.first.begin(), group.first.end()));
  }
  const vtkIdType most = counts.back();
  const std::string tooMany = "there is not enough graphics memory for a stream of " +
    std::to_string(most) + " triangles, " +
    std::to_string(3 * most * static_cast<vtkIdType>(sizeof(Vertex))) + " bytes";
  if (most > std::numeric_limits<GLsizei>::max() / 3)
  {
    error = tooMany;
    return false;
  }
  if (!program.Build(error))
  {
    return false;
  }
  window->GetShaderCache()->ReleaseCurrentShader();
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
  {
    // This clears earlier errors. A lost context reports errors without end.
  }
  this->Handle = MakeBuffer(counts[0], vertices.data());
  for (int step = 1; step <= steps && glGetError() == GL_NO_ERROR; ++step)
  {
    const size_t s = static_cast<size_t>(step);
    const GLuint target = MakeBuffer(counts[s], nullptr);
    program.Run(this->Handle, counts[s - 1], target);
    glDeleteBuffers(1, &this->Handle);
    this->Handle = target;
  }
  this->NumberOfTriangles = most;
  if (glGetError() != GL_NO_ERROR)
  {
    this->ReleaseGraphicsResources();
    error = tooMany;
    return false;
  }
  return true;
}

FaceSums RefinementStream::CountTriangles(
  const RefinementMesh& mesh, const ViewSelection& selection)
{
  TriangleSplit split;
  return selection.SumOverFaces(
    [&](int face)
    {
      const FacePattern pattern = selection.GetSelection().GetFacePattern(face);
      return split.Count(MakeCoarseTriangle(mesh.Faces[face], pattern).Left).back();
    });
}

std::vector<RefinementStreamVertex> RefinementStream::Read() const
{
  std::vector<Vertex> vertices(3 * static_cast<size_t>(this->NumberOfTriangles));
  glBindBuffer(GL_ARRAY_BUFFER, this->Handle);
  glGetBufferSubData(
    GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)), vertices.data());
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  return vertices;
}

vtkTypeInt64 RefinementStream::GetMemorySize() const
{
  return this->Handle ? 3 * this->NumberOfTriangles * static_cast<vtkTypeInt64>(sizeof(Vertex)) : 0;
}

void RefinementStream::ReleaseGraphicsResources()
{
  if (this->Handle)
  {
    glDeleteBuffers(1, &this->Handle);
    this->Handle = 0;
  }
  this->NumberOfTriangles = 0;
}
}
