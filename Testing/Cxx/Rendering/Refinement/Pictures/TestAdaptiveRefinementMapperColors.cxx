// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves guide.md: SetColorModeToLevel(), SetColorModeToPattern() and SetColorModeToMetric() colour
// faces by the levels of vtkDepthTagFilter, by tags computed here, and with the colours of the
// legend.
#include "RelevoFaceColors.h"

#include "Mesh/SurfaceEdges.h"
#include "View/RefinementView.h"
#include "vtkCallbackCommand.h"
#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDepthTagFilter.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRefinementPatternTable.h"
#include "vtkScalarBarActor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace
{
using namespace RelevoFaceColors;
using namespace RelevoMeshes;

// Levels from vtkDepthTagFilter.
std::array<int, 3> GetLevels(View& view, vtkIdType face)
{
  vtkNew<vtkDepthTagFilter> filter;
  filter->SetInputData(view.Plane);
  filter->SetMetric(view.Metric);
  filter->SetMaximumLevel(MaximumLevel);
  filter->SetLevelRule(view.Recipe->GetLevelRule());
  filter->SetCamera(view.Renderer->GetActiveCamera());
  filter->SetViewportSize(view.Renderer->GetSize());
  filter->Update();
  vtkDataArray* array = filter->GetOutput()->GetCellData()->GetArray("EdgeLevels");
  std::array<int, 3> levels;
  for (int e = 0; e < 3; ++e)
  {
    levels[e] = static_cast<int>(array->GetComponent(face, e));
  }
  return levels;
}

// Compares colours of faces with the levels of their edges.
void CheckFaces(RelevoCheck& check, View& view,
  const std::function<double(const std::array<int, 3>&)>& getValue, size_t atLeast)
{
  view.Render();
  std::set<double> values;
  int faces = 0;
  for (vtkIdType f = 0; f < view.Plane->GetNumberOfCells(); ++f)
  {
    Color color{};
    if (view.GetColorAt(f, { { 0.3, 0.3, 0.4 } }, color))
    {
      const double value = getValue(GetLevels(view, f));
      CHECK(IsNear(color, GetColor(view.Mapper->GetLevelLookupTable(), value), 1));
      values.insert(value);
      ++faces;
    }
  }
  CHECK_GREATER(faces, 20);
  CHECK_GREATER_EQUAL(values.size(), atLeast);
}

void TestLevels(RelevoCheck& check)
{
  View view;
  view.Mapper->SetColorModeToLevel();
  const auto highest = [](const std::array<int, 3>& levels) {
    return std::max({ levels[0], levels[1], levels[2] });
  };
  CheckFaces(check, view, highest, 3);
  CHECK_EQUAL(view.Mapper->GetLevelLookupTable()->GetNumberOfAnnotatedValues(), MaximumLevel + 1);
  view.Recipe->GeomorphingOn();
  CheckFaces(check, view, highest, 3);
  view.Recipe->SetLevelRuleToPerEdge();
  CheckFaces(check, view, highest, 3);
  view.Recipe->GeomorphingOff();
  CheckFaces(check, view, highest, 3);

  // Point or cell scalars and another camera do not change this.
  vtkNew<vtkFloatArray> values;
  for (vtkIdType i = 0; i < view.Plane->GetNumberOfCells(); ++i)
  {
    values->InsertNextValue(static_cast<float>(i % 7));
  }
  view.Plane->GetCellData()->SetScalars(values);
  CheckFaces(check, view, highest, 3);
  view.Renderer->GetActiveCamera()->Azimuth(40.0);
  CheckFaces(check, view, highest, 3);
  view.Plane->GetCellData()->SetScalars(nullptr);
  values->SetNumberOfTuples(view.Plane->GetNumberOfPoints());
  view.Plane->GetPointData()->SetScalars(values);
  CheckFaces(check, view, highest, 3);
  view.Mapper->SetInterpolateScalarsBeforeMapping(true);
  CheckFaces(check, view, highest, 3);

  // A custom lookup table works, too.
  vtkNew<vtkColorTransferFunction> table;
  table->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  table->AddRGBPoint(MaximumLevel, 0.0, 1.0, 0.5);
  view.Mapper->SetLevelLookupTable(table);
  CHECK_EQUAL(view.Mapper->GetLevelLookupTable(), table);
  CheckFaces(check, view, highest, 3);
  table->AddRGBPoint(2.0, 0.0, 0.0, 1.0);
  CheckFaces(check, view, highest, 3);
}

void TestPatterns(RelevoCheck& check)
{
  View view;
  view.Mapper->SetColorModeToPattern();
  const auto index = [](std::array<int, 3> levels)
  {
    vtkRefinementPatternTable::Canonicalize(levels.data());
    return vtkRefinementPatternTable::GetPatternIndex(levels[0], levels[1], levels[2]);
  };
  for (int geomorphing : { 0, 1 })
  {
    CHECK_CASE(geomorphing);
    view.Recipe->SetGeomorphing(geomorphing);
    CheckFaces(check, view, index, 6);
  }
  vtkScalarsToColors* table = view.Mapper->GetLevelLookupTable();
  const int count = (MaximumLevel + 1) * (MaximumLevel + 2) * (MaximumLevel + 3) / 6;
  CHECK_EQUAL(table->GetNumberOfAnnotatedValues(), count);
  CHECK_EQUAL(
    table->GetAnnotation(vtkRefinementPatternTable::GetPatternIndex(3, 2, 0)), "[3, 2, 0]");
  std::set<Color> colors;
  for (int i = 0; i < count; ++i)
  {
    colors.insert(GetColor(table, i));
  }
  CHECK_EQUAL(static_cast<int>(colors.size()), count);
}

// Edges with round(2^tag) segments: both 12 and 16 segments have level 4.
void TestWholeNumbers(RelevoCheck& check)
{
  for (float tag : { 0.0f, 1.0f, 1.6f, 2.3f, 3.0f, 3.6f, 4.0f })
  {
    CHECK_CASE(tag);
    View view;
    vtkNew<vtkFloatArray> tags;
    tags->SetName("DepthTag");
    tags->SetNumberOfTuples(view.Plane->GetNumberOfPoints());
    tags->FillValue(tag);
    view.Plane->GetPointData()->AddArray(tags);
    view.Recipe->SetSegmentPolicyToWholeNumbers();
    const int segments = static_cast<int>(std::floor(std::exp2(tag) + 0.5));
    const int level = static_cast<int>(std::ceil(std::log2(segments)));
    view.Mapper->SetColorModeToLevel();
    CheckFaces(
      check, view, [&](const std::array<int, 3>&) { return level; }, 1);
    view.Mapper->SetColorModeToPattern();
    const int step = segments - 1;
    const int index = vtkRefinementPatternTable::GetPatternIndex(step, step, step);
    CheckFaces(
      check, view, [&](const std::array<int, 3>&) { return index; }, 1);
    const std::string number = std::to_string(segments);
    CHECK_EQUAL(view.Mapper->GetLevelLookupTable()->GetAnnotation(index),
      "[" + number + ", " + number + ", " + number + "]");
  }
}

constexpr int Tolerance = 4; // because a pixel's centre is not exactly the point

relevo::RefinementView GetEye(View& view)
{
  relevo::RefinementView eye;
  eye.Camera = view.Renderer->GetActiveCamera();
  std::copy_n(view.Renderer->GetSize(), 2, eye.ViewportSize);
  return eye;
}

Color GetColorForTag(View& view, double tag)
{
  const double moved = tag + view.Recipe->GetLevelOffset();
  return GetColor(view.Mapper->GetLevelLookupTable(),
    std::min(std::max(moved, 0.0), static_cast<double>(MaximumLevel)));
}

// Tags are interpolated linearly between the points of a face.
void CheckTagsOfPoints(RelevoCheck& check, View& view)
{
  view.Recipe->SetLevelRuleToPerVertex();
  view.Render();
  vtkScalarsToColors* table = view.Mapper->GetLevelLookupTable();
  CHECK(table->GetRange()[0] == 0.0 && table->GetRange()[1] == MaximumLevel);
  vtkNew<vtkFloatArray> tags;
  view.Metric->ComputeTags(view.Plane, GetEye(view), MaximumLevel, tags);
  int points = 0;
  for (vtkIdType f = 0; f < view.Plane->GetNumberOfCells(); ++f)
  {
    for (const Weights& w : { Weights{ { 0.6, 0.2, 0.2 } }, Weights{ { 0.1, 0.3, 0.6 } } })
    {
      double tag = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        tag += w[i] * tags->GetValue(view.Plane->GetCell(f)->GetPointId(i));
      }
      Color color{};
      if (view.GetColorAt(f, w, color))
      {
        CHECK(IsNear(color, GetColorForTag(view, tag), Tolerance));
        ++points;
      }
    }
  }
  CHECK_GREATER(points, 40);
}

// Half of the pixels on a border edge show the background.
bool IsOpen(const relevo::SurfaceEdges& edges, int edge)
{
  bool open = false;
  edges.ForEachSides(
    edge, [&](int i) { open = edges.GetSides()[i].Type == relevo::SurfaceEdgeSides::OPEN; });
  return open;
}

// Tags of edges are constant along the edge.
void CheckTagsOfEdges(RelevoCheck& check, View& view)
{
  view.Recipe->SetLevelRuleToPerEdge();
  view.Render();
  const relevo::SurfaceEdges edges(view.Plane);
  vtkNew<vtkFloatArray> tags;
  view.Metric->ComputeEdgeTags(view.Plane, GetEye(view), MaximumLevel, edges, tags);
  int points = 0;
  for (vtkIdType f = 0; f < view.Plane->GetNumberOfCells(); ++f)
  {
    for (int e = 0; e < 3; ++e)
    {
      for (double t : { 0.3, 0.5, 0.7 })
      {
        Weights w{ { 0.005, 0.005, 0.005 } }; // just inside the face
        w[e] = 0.995 * t;
        w[(e + 1) % 3] = 0.995 * (1.0 - t);
        vtkCell* cell = view.Plane->GetCell(f);
        const int edge = edges.FindEdge(cell->GetPointId(e), cell->GetPointId((e + 1) % 3));
        Color color{};
        if (!IsOpen(edges, edge) && view.GetColorAt(f, w, color))
        {
          CHECK(IsNear(color, GetColorForTag(view, tags->GetValue(edge)), 3 * Tolerance));
          ++points;
        }
      }
    }
  }
  CHECK_GREATER(points, 100);
}

// The offset of a budget takes effect.
void CheckTagsOfBudget(RelevoCheck& check, View& view)
{
  view.Recipe->SetLevelRuleToPerVertex();
  view.Recipe->SetLevelOffset(0.0);
  view.Mapper->SetTargetNumberOfTriangles(2000);
  view.Render();
  const double budgeted = view.Mapper->GetLevelOffset();
  CHECK_GREATER(std::abs(budgeted), 0.1);
  const std::vector<unsigned char> colors = view.Picture->Colors;
  view.Mapper->SetTargetNumberOfTriangles(0);
  view.Recipe->SetLevelOffset(budgeted);
  view.Render();
  CHECK_EQUAL(view.Picture->Colors, colors);
}

// Without metric and array, the level is the highest.
void CheckTagsWithoutMetric(RelevoCheck& check, View& view)
{
  view.Recipe->SetMetric(nullptr);
  view.Recipe->SetLevelOffset(-1.0);
  view.Render();
  const Color expected = GetColor(view.Mapper->GetLevelLookupTable(), MaximumLevel - 1);
  for (vtkIdType f = 0; f < view.Plane->GetNumberOfCells(); ++f)
  {
    Color color{};
    CHECK(!view.GetColorAt(f, { { 0.3, 0.3, 0.4 } }, color) || IsNear(color, expected, Tolerance));
  }
}

void TestTags(RelevoCheck& check)
{
  View view;
  view.Mapper->SetColorModeToMetric();
  for (double offset : { 0.0, 0.75 })
  {
    CHECK_CASE(offset);
    for (int geomorphing : { 0, 1 })
    {
      CHECK_CASE(geomorphing);
      view.Recipe->SetLevelOffset(offset);
      view.Recipe->SetGeomorphing(geomorphing);
      CheckTagsOfPoints(check, view);
      CheckTagsOfEdges(check, view);
    }
  }
  CheckTagsOfBudget(check, view);
  CheckTagsWithoutMetric(check, view);
}

// VTK's colour modes, and VTK's colours again.
void TestModes(RelevoCheck& check)
{
  View view;
  vtkNew<vtkFloatArray> values;
  for (vtkIdType i = 0; i < view.Plane->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(static_cast<float>(i % 5));
  }
  view.Plane->GetPointData()->SetScalars(values);
  view.Actor->GetProperty()->LightingOn();
  view.Render();
  const std::vector<unsigned char> scalars = view.Picture->Colors;
  CHECK_EQUAL(view.Mapper->GetRefinementColorMode(), vtkAdaptiveRefinementMapper::COLOR_BY_SCALARS);
  const auto isBack = [&]
  {
    view.Render();
    return view.Picture->Colors == scalars;
  };
  view.Mapper->SetColorModeToLevel();
  CHECK(!isBack());
  view.Mapper->SetColorModeToScalars();
  CHECK(isBack());
  view.Mapper->SetColorModeToPattern();
  CHECK(!isBack());
  static_cast<vtkMapper*>(view.Mapper)->SetColorModeToMapScalars();
  CHECK_EQUAL(view.Mapper->GetColorMode(), VTK_COLOR_MODE_MAP_SCALARS);
  CHECK(isBack());
  view.Mapper->SetColorModeToMetric();
  CHECK(!isBack());
  static_cast<vtkMapper*>(view.Mapper)->SetColorModeToDefault();
  CHECK(isBack());

  // ShallowCopy() copies the mode.
  view.Mapper->SetColorModeToLevel();
  vtkNew<vtkAdaptiveRefinementMapper> copy;
  copy->ShallowCopy(view.Mapper);
  CHECK_EQUAL(copy->GetRefinementColorMode(), vtkAdaptiveRefinementMapper::COLOR_BY_LEVEL);
  CHECK(!isBack());
  const std::vector<unsigned char> levels = view.Picture->Colors;
  view.Actor->SetMapper(copy);
  view.Render();
  CHECK_EQUAL(view.Picture->Colors, levels);

  // The colours are lit and translucent like VTK's.
  vtkNew<vtkLookupTable> grey;
  grey->SetNumberOfTableValues(1);
  grey->SetTableValue(0, 0.6, 0.6, 0.6);
  copy->SetLevelLookupTable(grey);
  for (double opacity : { 1.0, 0.4 })
  {
    CHECK_CASE(opacity);
    view.Actor->GetProperty()->SetOpacity(opacity);
    view.Render();
    const std::vector<unsigned char> tinted = view.Picture->Colors;
    copy->ScalarVisibilityOff();
    copy->SetColorModeToScalars();
    view.Actor->GetProperty()->SetColor(0.6, 0.6, 0.6);
    view.Render();
    CHECK_EQUAL(view.Picture->Colors, tinted);
    copy->ScalarVisibilityOn();
    copy->SetColorModeToLevel();
  }
}

// Only colours of the table and the legend are drawn: wireframe, edges, vertices and blocks.
void TestPictures(RelevoCheck& check)
{
  View view;
  view.Mapper->SetColorModeToLevel();
  std::set<Color> allowed = { { { 64, 64, 64 } } };
  for (int level = 0; level <= MaximumLevel; ++level)
  {
    allowed.insert(GetColor(view.Mapper->GetLevelLookupTable(), level));
  }
  const auto hasOnly = [&](const std::set<Color>& colors)
  {
    view.Render();
    const std::set<Color> drawn = view.GetColors();
    return drawn.size() > 3 &&
      std::all_of(drawn.begin(), drawn.end(),
        [&](const Color& color)
        {
          return std::any_of(colors.begin(), colors.end(),
            [&](const Color& other) { return IsNear(color, other, 1); });
        });
  };
  CHECK(hasOnly(allowed));
  view.Actor->GetProperty()->SetRepresentationToWireframe();
  CHECK(hasOnly(allowed));
  view.Recipe->GeomorphingOn();
  CHECK(hasOnly(allowed));
  view.Actor->GetProperty()->SetRepresentationToPoints();
  CHECK(hasOnly(allowed));
  view.Actor->GetProperty()->SetRepresentationToSurface();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, view.Plane);
  view.Mapper->SetInputDataObject(blocks);
  CHECK(hasOnly(allowed));
  view.Mapper->SetColorModeToScalars();
  CHECK(!hasOnly(allowed));
  view.Mapper->SetColorModeToLevel();
  CHECK(hasOnly(allowed));
  const size_t numberOfColors = view.GetColors().size();

  // The legend alone has all colours of the picture.
  vtkNew<vtkScalarBarActor> legend;
  legend->SetLookupTable(view.Mapper->GetLevelLookupTable());
  view.Renderer->AddViewProp(legend);
  const std::set<Color> picture = view.GetColors();
  view.Actor->VisibilityOff();
  view.Render();
  const std::set<Color> shown = view.GetColors();
  CHECK_EQUAL(picture.size(), numberOfColors);
  CHECK(std::includes(shown.begin(), shown.end(), picture.begin(), picture.end()));
}

// Colours by level follow the camera without a new shader.
void TestCamera(RelevoCheck& check)
{
  for (int mode : { 1, 2, 3 })
  {
    CHECK_CASE(mode);
    View view;
    mode == 1       ? view.Mapper->SetColorModeToLevel()
      : (mode == 2) ? view.Mapper->SetColorModeToPattern()
                    : view.Mapper->SetColorModeToMetric();
    std::set<void*> programs;
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&programs);
    command->SetCallback([](vtkObject*, unsigned long, void* client, void* program)
      { static_cast<std::set<void*>*>(client)->insert(program); });
    view.Mapper->AddObserver(vtkCommand::UpdateShaderEvent, command);
    for (int i = 0; i < 4; ++i)
    {
      view.Render();
      view.Renderer->GetActiveCamera()->Azimuth(20.0);
      view.Renderer->GetActiveCamera()->Zoom(1.1);
    }
    CHECK_EQUAL(view.Mapper->GetNumberOfSelections(), 4);
    CHECK_EQUAL(programs.size(), 1);
  }
}
}

int TestAdaptiveRefinementMapperColors(int, char*[])
{
  RelevoCheck check;
  TestLevels(check);
  TestPatterns(check);
  TestWholeNumbers(check);
  TestTags(check);
  TestModes(check);
  TestPictures(check);
  TestCamera(check);
  return check.GetResult();
}
