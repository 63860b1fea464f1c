// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/TerrainPainter.h"

#include "OpenGL/RelevoOpenGL.h"

#include "Actors/ShaderVariantKey.h"
#include "Lattice/BlockErrors.h"
#include "OpenGL/PositionShift.h"
#include "View/TerrainViewpoint.h"
#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
constexpr int UnitsPerSample = 1 << -BlockErrors::FinestLevel;

// The longest side of a small triangle, in pixels.
constexpr double LargestSmallTriangle = 2.0;

// Borders of the raster are drawn in spite of rounding errors between vertices, in samples.
constexpr double BorderTolerance = 1.0 / 1024.0;

// Larger than all columns and rows.
constexpr float NoLimit = 1e30f;

double GetDeterminant(const TerrainPlacement& placement)
{
  return placement.Column[0] * placement.Row[1] - placement.Column[1] * placement.Row[0];
}

TerrainPatterns::Primitives GetTerrainPrimitives(vtkActor* actor)
{
  switch (actor->GetProperty()->GetRepresentation())
  {
    case VTK_POINTS:
      return TerrainPatterns::POINTS;
    case VTK_WIREFRAME:
      return TerrainPatterns::LINES;
    default:
      return TerrainPatterns::TRIANGLES;
  }
}

GLenum GetTerrainMode(TerrainPatterns::Primitives primitives)
{
  return primitives == TerrainPatterns::POINTS ? GL_POINTS
    : primitives == TerrainPatterns::LINES     ? GL_LINES
                                               : GL_TRIANGLES;
}

int ToSample(double coordinate, int size)
{
  return static_cast<int>(std::clamp(std::round(coordinate), 0.0, size - 1.0));
}
}

vtkStandardNewMacro(TerrainPainter);

TerrainPainter::TerrainPainter()
  : VariantPainter(NUMBER_OF_PROGRAMS)
{
  this->SetVBOShiftScaleMethod(
    static_cast<int>(vtkOpenGLVertexBufferObject::ShiftScaleMethod::MANUAL_SHIFT_SCALE));
  // VTK's shaders have normals if the points have.
  vtkPoints* points = this->Box->GetPoints();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(1);
  points->SetPoint(0, 0.0, 0.0, 0.0);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(1);
  normals->Fill(0.0);
  this->Box->GetPointData()->SetNormals(normals);
}

TerrainPainter::~TerrainPainter() = default;

//------------------------------------------------------------------------------
// Faces of a view

std::string TerrainPainter::Prepare(vtkRenderer* renderer, vtkActor* actor,
  const std::vector<TerrainFace>& faces, const std::vector<MipmapTiles::Item>& shading,
  const Settings& settings)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  this->Current = settings;
  this->NumberOfDrawCalls = 0;
  this->Instances.SetMemoryLimit(settings.MemoryLimit);
  this->Instances.SetImageryContent(settings.Coloring == TerrainColoring::RASTER
      ? TerrainTileTextures::Content::NUMBERS
      : TerrainTileTextures::Content::IMAGERY);
  this->Instances.SetHasHeights(HasHeights(settings.Coloring, settings.ContourInterval > 0.0));
  const TerrainViewpoint viewpoint(renderer, actor);
  this->HalfViewport = viewpoint.GetHalfViewport();
  this->UpdateBorder(faces);
  this->FindKinds(viewpoint, faces);
  std::string error = this->Instances.Upload(window, faces, this->Kinds, shading);
  error = error.empty() ? this->UploadBorder(window, actor) : error;
  if (!error.empty())
  {
    return error;
  }
  if (renderer->GetSelector() && !this->Instances.UploadIds(window))
  {
    return "The graphics memory does not suffice for a selection.";
  }
  this->ChooseOrigin(viewpoint, faces);
  if (settings.Placement.Globe)
  {
    std::array<double, 3> origin;
    this->Box->GetPoint(0, origin.data());
    const std::string globeError =
      this->Globe.Upload(window, this->Instances.GetOrder(), *settings.Vertices,
        { origin, this->OriginHeight * settings.Placement.HeightScale,
          settings.Placement.Exaggeration, settings.NumberOfComputedFaces });
    if (!globeError.empty())
    {
      return globeError;
    }
  }
  this->Options.IsGlobe = settings.Placement.Globe != nullptr;
  this->UpdateColors(window);
  this->Options.Coloring = this->ColorError.empty() ? settings.Coloring : TerrainColoring::SOLID;
  if (HasImagery(this->Options.Coloring) && !this->Instances.HasImagery())
  {
    this->Options.Coloring = TerrainColoring::SOLID;
  }
  this->Options.HasContours = settings.ContourInterval > 0.0;
  return "";
}

int TerrainPainter::GetMaximumNumberOfTiles(vtkTypeInt64 memoryLimit)
{
  this->Instances.SetMemoryLimit(memoryLimit);
  return this->Instances.GetMaximumNumberOfTiles();
}

// Fragments of large triangles have the gradient of their own point. Where triangles are hardly
// larger than pixels, vertices do as well and cost less.
void TerrainPainter::FindKinds(
  const TerrainViewpoint& viewpoint, const std::vector<TerrainFace>& faces)
{
  using Kind = TerrainInstances::Kind;
  this->Kinds.assign(faces.size(), Kind::Large);
  const TerrainPlacement& placement = this->Current.Placement;
  const bool canBeSmall = !placement.Globe && !HasGradients(this->Current.Coloring);
  constexpr int segments = TerrainFace::Segments;
  const int vertices[3][2] = { { 0, 0 }, { segments, 0 }, { 0, segments } };
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (this->Current.Base && this->Border.GetAreAtBorder()[i])
    {
      this->Kinds[i] = Kind::Border;
      continue;
    }
    if (!canBeSmall)
    {
      continue;
    }
    const TerrainFace& face = faces[i];
    std::array<std::array<double, 3>, 3> corners;
    for (int c = 0; c < 3; ++c)
    {
      const std::array<double, 2> sample = face.GetSample(vertices[c][0], vertices[c][1]);
      corners[c] = placement.ToWorld(sample[0], sample[1], face.CornerHeights[c]);
    }
    const bool isSmall =
      viewpoint.GetLongestSide(corners) <= segments * LargestSmallTriangle; // not NaN
    this->Kinds[i] = isSmall ? Kind::Small : Kind::Large;
  }
}

// The columns of a closed globe and its rows at poles have no borders.
void TerrainPainter::UpdateBorder(const std::vector<TerrainFace>& faces)
{
  const TerrainPlacement& placement = this->Current.Placement;
  if (!this->Current.Base)
  {
    this->Border.Clear();
    return;
  }
  TerrainBorder::Settings settings;
  settings.IsMirrored = !(GetDeterminant(placement) > 0.0);
  const GlobeShape* globe = placement.Globe.get();
  settings.Vertices = globe ? this->Current.Vertices : nullptr;
  const bool isClosed = globe && globe->GetPeriod() > 0;
  const bool hasFirstPole = globe && globe->HasFirstPole();
  const bool hasLastPole = globe && globe->HasLastPole();
  settings.HasFirst = { { !isClosed, !hasFirstPole } };
  for (int axis = 0; axis < 2; ++axis)
  {
    if (axis == 0 ? !isClosed : !hasLastPole)
    {
      settings.Last[axis] = std::int64_t(UnitsPerSample) * (this->Current.Dimensions[axis] - 1);
    }
  }
  this->Border.Update(faces, settings);
}

std::string TerrainPainter::UploadBorder(vtkOpenGLRenderWindow* window, vtkActor* actor)
{
  std::vector<unsigned int> numbers;
  if (this->Current.Base)
  {
    const std::vector<unsigned int>& order = this->Instances.GetOrder();
    std::vector<unsigned int> places(order.size());
    for (std::size_t place = 0; place < order.size(); ++place)
    {
      places[order[place]] = static_cast<unsigned int>(place);
    }
    numbers = this->Border.Expand(GetTerrainPrimitives(actor), places);
  }
  if (numbers == this->BorderNumbers && (numbers.empty() || !this->BorderTexture.IsEmpty()))
  {
    return "";
  }
  this->BorderNumbers.swap(numbers);
  if (this->BorderNumbers.empty())
  {
    this->BorderTexture.ReleaseGraphicsResources(window);
    return "";
  }
  return this->BorderTexture.Upload(window, this->BorderNumbers, TerrainBorder::NumbersPerVertex)
    ? ""
    : "The base has too many triangles for a buffer texture of this OpenGL: at most " +
      std::to_string(TerrainInstances::GetMaximumNumberOfFaces() / 3) +
      ". Set a larger screen-space error.";
}

// Positions are exact in floats near the origin.
void TerrainPainter::ChooseOrigin(
  const TerrainViewpoint& viewpoint, const std::vector<TerrainFace>& faces)
{
  float heights[2] = { std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest() };
  for (const TerrainFace& face : faces)
  {
    for (float height : face.CornerHeights)
    {
      if (!std::isnan(height))
      {
        heights[0] = std::min(heights[0], height);
        heights[1] = std::max(heights[1], height);
      }
    }
  }
  const TerrainPlacement& placement = this->Current.Placement;
  const auto& near = viewpoint.GetNearPoint();
  if (placement.Globe)
  {
    this->ChooseGlobeOrigin(faces, near, heights);
    return;
  }
  const double x = near[0] - placement.Origin[0];
  const double y = near[1] - placement.Origin[1];
  const double determinant = GetDeterminant(placement);
  this->OriginSample[0] = ToSample(
    (x * placement.Row[1] - y * placement.Row[0]) / determinant, this->Current.Dimensions[0]);
  this->OriginSample[1] = ToSample(
    (placement.Column[0] * y - placement.Column[1] * x) / determinant, this->Current.Dimensions[1]);
  const double height = near[2] / placement.HeightScale;
  this->OriginHeight = heights[0] <= heights[1] && std::isfinite(height)
    ? std::round(std::clamp(static_cast<float>(height), heights[0], heights[1]))
    : 0.0f;
  this->SetOrigin(placement.ToWorld(
    this->OriginSample[0], this->OriginSample[1], static_cast<double>(this->OriginHeight)));
}

// The origin is the eye, in whole metres. The sample is one near the eye.
void TerrainPainter::ChooseGlobeOrigin(
  const std::vector<TerrainFace>& faces, const std::array<double, 3>& near, const float heights[2])
{
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const std::array<double, 3>& position = this->Current.Vertices->at(i)->front().Position;
    const double distance =
      vtkMath::Distance2BetweenPoints(position.data(), near.data()); // NaN outside of a projection
    if (distance < nearest)
    {
      nearest = distance;
      const std::array<double, 2> sample = faces[i].GetSample(0, 0);
      this->OriginSample = { { static_cast<int>(sample[0]), static_cast<int>(sample[1]) } };
    }
  }
  const double height = this->Current.Placement.Globe->GetFrame().ToGeographic(near)[2] /
    this->Current.Placement.HeightScale;
  this->OriginHeight = heights[0] <= heights[1]
    ? std::round(std::clamp(static_cast<float>(height), heights[0], heights[1]))
    : 0.0f;
  this->SetOrigin({ { std::round(near[0]), std::round(near[1]), std::round(near[2]) } });
}

void TerrainPainter::SetOrigin(const std::array<double, 3>& origin)
{
  vtkPoints* points = this->Box->GetPoints();
  double last[3];
  points->GetPoint(0, last);
  if (!std::equal(origin.begin(), origin.end(), last))
  {
    points->SetPoint(0, origin.data());
    points->Modified(); // VTK builds its buffers again, with another shift
  }
}

void TerrainPainter::UpdateColors(vtkOpenGLRenderWindow* window)
{
  this->ColorError.clear();
  if (!HasTable(this->Current.Coloring))
  {
    return;
  }
  vtkScalarsToColors* table = this->Current.Table;
  const double* range = table->GetRange();
  this->ColorError = ColorTable::FindError(table, range);
  Dependencies source;
  source.AddObject(table);
  if (this->ColorError.empty() && this->TableSource.Update(source))
  {
    const double all[2] = { std::numeric_limits<float>::lowest(),
      std::numeric_limits<float>::max() };
    if (!this->Table.Upload(window, table, 0.0, all))
    {
      this->ColorError = "the lookup table does not fit into graphics memory";
    }
    this->TableSource = Dependencies();
    this->TableSource.AddObject(table); // after the upload, which builds the table
  }
}

//------------------------------------------------------------------------------
// Drawing

void TerrainPainter::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  if (this->PointPicking)
  {
    return;
  }
  for (Program part : { LARGE_TRIANGLES, SMALL_TRIANGLES, BOTTOM, BORDER })
  {
    if (!this->IsEmpty(part) && !this->DrawPart(renderer, actor, part))
    {
      return;
    }
  }
}

bool TerrainPainter::IsEmpty(Program part) const
{
  const auto isEmpty = [this](bool areSmall)
  {
    return this->Instances.GetGroup(areSmall, false).Count == 0 &&
      this->Instances.GetGroup(areSmall, true).Count == 0;
  };
  switch (part)
  {
    case BORDER:
      return this->BorderNumbers.empty();
    case BOTTOM:
      return !this->Current.Base || (isEmpty(false) && isEmpty(true));
    default:
      return isEmpty(part == SMALL_TRIANGLES);
  }
}

bool TerrainPainter::DrawPart(vtkRenderer* renderer, vtkActor* actor, Program part)
{
  this->Options.HasVertexNormals = part == SMALL_TRIANGLES;
  this->Options.Part = part == BORDER ? TerrainPart::BORDER
    : part == BOTTOM                  ? TerrainPart::BOTTOM
                                      : TerrainPart::SURFACE;
  vtkOpenGLHelper& helper = this->Variants.GetHelper(part);
  if (!this->UpdateProgram(helper, this->Options.GetKey(), renderer, actor))
  {
    return false;
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const TerrainPatterns::Primitives primitives = GetTerrainPrimitives(actor);
  if (primitives == TerrainPatterns::LINES && !this->HaveWideLines(renderer, actor))
  {
    window->GetState()->vtkglLineWidth(actor->GetProperty()->GetLineWidth());
  }
  helper.VAO->Bind(); // VTK releases it when the program changes
  if (part == BORDER)
  {
    glDrawArrays(GetTerrainMode(primitives), 0,
      static_cast<GLsizei>(this->BorderNumbers.size() / TerrainBorder::NumbersPerVertex));
    ++this->NumberOfDrawCalls;
  }
  else
  {
    this->DrawGroups(primitives, part);
  }
  helper.VAO->Release();
  this->Instances.Deactivate(window);
  this->Globe.Deactivate();
  this->BorderTexture.Deactivate();
  this->Table.Deactivate();
  return true;
}

void TerrainPainter::DrawGroups(TerrainPatterns::Primitives primitives, Program part)
{
  for (bool isMirrored : { false, true })
  {
    this->Patterns.GetRange(primitives, isMirrored);
  }
  if (!this->Patterns.Bind())
  {
    return;
  }
  // All triangles face up, but those of the bottom face down.
  const bool facesUp = part != BOTTOM;
  for (bool areSmall : { false, true })
  {
    for (bool isPositive : { false, true })
    {
      if (part == BOTTOM || areSmall == (part == SMALL_TRIANGLES))
      {
        const bool isMirrored =
          (isPositive != (GetDeterminant(this->Current.Placement) > 0.0)) == facesUp;
        this->DrawGroup(
          primitives, this->Instances.GetGroup(areSmall, isPositive), isMirrored, part);
      }
    }
  }
  this->Patterns.Release();
}

void TerrainPainter::DrawGroup(TerrainPatterns::Primitives primitives,
  const TerrainInstances::Group& group, bool isMirrored, Program part)
{
  if (group.Count == 0)
  {
    return;
  }
  const PatternRange& range = this->Patterns.GetRange(primitives, isMirrored);
  const auto [instances, copies] = CountInstances(group.Count, range.Copies);
  const vtkOpenGLHelper& helper = this->Variants.GetHelper(part);
  const GLint location =
    glGetUniformLocation(static_cast<GLuint>(helper.Program->GetHandle()), "relevoGroup");
  glUniform3i(location, group.First, group.Count, copies);
  glDrawElementsInstanced(GetTerrainMode(primitives), copies * range.NumberOfIndices,
    GL_UNSIGNED_SHORT, TerrainPatterns::GetOffset(range), instances);
  ++this->NumberOfDrawCalls;
}

void TerrainPainter::BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  double origin[3];
  this->Box->GetPoints()->GetPoint(0, origin);
  ShiftPositions(this->VBOs, this->Box->GetPoints()->GetData(), renderer,
    { origin[0], origin[1], origin[2] }, { 1.0, 1.0, 1.0 });
  this->Superclass::BuildBufferObjects(renderer, actor);
}

//------------------------------------------------------------------------------
// Shaders

bool TerrainPainter::GetNeedToRebuildShaders(
  vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  this->Options.HasCells = this->IsSelectingCells();
  const bool needed = this->Superclass::GetNeedToRebuildShaders(helper, renderer, actor);
  return this->Variants.NeedsBuild(helper, needed, this->Options.GetKey());
}

void TerrainPainter::PrepareShaders(ShaderVariants::Shaders& shaders, vtkActor* actor)
{
  PrepareTerrainShaders(
    this->Options, HasOwnFragments(actor), shaders, this->Variants.GetMissing());
}

void TerrainPainter::FinishShaders(ShaderVariants::Shaders& shaders)
{
  FinishTerrainShaders(this->Options, shaders, this->Variants.GetMissing());
}

bool TerrainPainter::IsLit() const
{
  return this->Options.Coloring != TerrainColoring::HILLSHADE; // its sun is the only light
}

void TerrainPainter::SetMapperShaderParameters(
  vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(helper, renderer, actor);
  this->Instances.Activate(
    static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()), helper.Program);
  if (this->Options.IsGlobe)
  {
    this->Globe.Activate(helper.Program);
  }
  if (this->Options.Part == TerrainPart::BORDER)
  {
    this->BorderTexture.Activate(helper.Program, "relevoBorder");
  }
  this->SetPositionUniforms(helper.Program, actor->IsRenderingTranslucentPolygonalGeometry() != 0);
  this->SetColorUniforms(helper.Program);
}

void TerrainPainter::SetPositionUniforms(vtkShaderProgram* program, bool isTranslucent)
{
  const TerrainPlacement& placement = this->Current.Placement;
  const auto set4 = [program](const char* name, const std::array<double, 4>& values)
  {
    float floats[4];
    std::transform(
      values.begin(), values.end(), floats, [](double value) { return static_cast<float>(value); });
    program->SetUniform4f(name, floats);
  };
  const int origin[2] = { UnitsPerSample * this->OriginSample[0],
    UnitsPerSample * this->OriginSample[1] };
  program->SetUniform2i("relevoOrigin", origin);
  if (program->IsUniformUsed("relevoHalfViewport"))
  {
    const float viewport[2] = { static_cast<float>(this->HalfViewport[0]),
      static_cast<float>(this->HalfViewport[1]) };
    program->SetUniform2f("relevoHalfViewport", viewport);
  }
  program->SetUniformf("relevoOriginHeight", this->OriginHeight);
  program->SetUniformf("relevoHeightScale", static_cast<float>(placement.HeightScale));
  program->SetUniformf(
    "relevoUnit", static_cast<float>(placement.HeightScale / this->Current.Exaggeration));
  set4("relevoPlacement",
    { { placement.Column[0], placement.Column[1], placement.Row[0], placement.Row[1] } });
  // The inverse transpose maps derivatives, without the exaggeration.
  const double scale =
    placement.HeightScale / this->Current.Exaggeration / GetDeterminant(placement);
  set4("relevoGradients",
    { { scale * placement.Row[1], -scale * placement.Row[0], -scale * placement.Column[1],
      scale * placement.Column[0] } });
  program->SetUniformf("relevoExaggeration", static_cast<float>(this->Current.Exaggeration));
  float last[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const double sample =
      placement.Globe ? placement.Globe->GetBorder()[axis] : this->Current.Dimensions[axis] - 1.0;
    last[axis] = static_cast<float>(sample - this->OriginSample[axis] + BorderTolerance);
  }
  if (this->Current.Base)
  {
    // Triangles end at the borders, except at the seam of a globe.
    last[0] = placement.Globe && placement.Globe->GetPeriod() > 0 ? last[0] : NoLimit;
    last[1] = NoLimit;
    program->SetUniformf("relevoBaseHeight", static_cast<float>(*this->Current.Base));
  }
  // An opaque globe overlaps by a column, which hides differences of the sides of the seam. A
  // translucent one would show the overlap.
  if (placement.Globe && placement.Globe->GetPeriod() > 0 && isTranslucent)
  {
    last[0] = static_cast<float>(placement.Globe->GetPeriod() - this->OriginSample[0]);
  }
  program->SetUniform2f("relevoLastSample", last);
  if (placement.Globe)
  {
    // Imagery covers whole samples.
    const double size[2] = { static_cast<double>(this->Current.Dimensions[0]),
      static_cast<double>(this->Current.Dimensions[1]) };
    const float closing[3] = { static_cast<float>(size[0] - 0.5 - this->OriginSample[0]),
      static_cast<float>(placement.Globe->GetPeriod()),
      static_cast<float>(size[1] - 0.51 - this->OriginSample[1]) };
    program->SetUniform3f("relevoClosing", closing);
    program->SetUniformf("relevoPole", static_cast<float>(placement.Globe->GetPoleCosine()));
  }
}

void TerrainPainter::SetColorUniforms(vtkShaderProgram* program)
{
  if (HasTable(this->Options.Coloring))
  {
    this->Table.Activate(program);
  }
  if (program->IsUniformUsed("relevoNotANumber"))
  {
    program->SetUniformf("relevoNotANumber", std::numeric_limits<float>::quiet_NaN());
  }
  if (this->Options.HasContours)
  {
    const float contours[2] = { static_cast<float>(this->Current.ContourInterval),
      static_cast<float>(this->Current.ContourWidth) };
    program->SetUniform2f("relevoContours", contours);
    float color[3];
    std::transform(this->Current.ContourColor.begin(), this->Current.ContourColor.end(), color,
      [](double component) { return static_cast<float>(component); });
    program->SetUniform3f("relevoContourColor", color);
  }
}

//------------------------------------------------------------------------------
// Selection

void TerrainPainter::AnnounceIds(vtkHardwareSelector* selector) const
{
  selector->UpdateMaximumCellId(this->Instances.GetNumberOfFaces());
}

//------------------------------------------------------------------------------

vtkTypeInt64 TerrainPainter::GetMemorySize() const
{
  return this->Instances.GetMemorySize() + this->Globe.GetMemorySize() +
    this->Patterns.GetMemorySize() + this->Table.GetMemorySize() +
    this->BorderTexture.GetMemorySize();
}

void TerrainPainter::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Instances.ReleaseGraphicsResources(window);
  this->Globe.ReleaseGraphicsResources(window);
  this->Patterns.ReleaseGraphicsResources();
  this->Table.ReleaseGraphicsResources(window);
  this->BorderTexture.ReleaseGraphicsResources(window);
  this->TableSource.Clear();
}
}
