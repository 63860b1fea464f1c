// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkReliefPictures.h"

#include "BenchmarkPixelMesh.h"
#include "BenchmarkPixelPoints.h"
#include "BenchmarkReliefScene.h"
#include "BenchmarkReliefWay.h"
#include "BenchmarkReport.h"
#include "BenchmarkView.h"
#include "Data/Relief.h"
#include "Mathematics/PictureSimilarity.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"

#include <cmath>

namespace
{
struct ViewAngles
{
  double Azimuth;
  double Elevation;
  double FromCapture; // angle from the nearest one
};
const ViewAngles Views[] = { { 0.0, 0.0, 0.0 }, { 5.0, 0.0, 5.0 }, { 10.0, 0.0, 10.0 },
  { 27.0, 7.0, 9.9 }, { -14.0, -8.0, 10.0 }, { 0.0, 10.0, 10.0 } };

struct Picture
{
  std::vector<unsigned char> Colors;
  std::vector<float> Depths;
};

Picture Draw(BenchmarkView& view, vtkProp* prop)
{
  view.GetRenderer()->AddViewProp(prop);
  view.TimeFrame();
  view.TimeFrame();
  Picture picture{ view.GetPicture(), view.GetDepths() };
  view.GetRenderer()->RemoveViewProp(prop);
  return picture;
}

// Whether a point of the world was captured: it lies within two texels of a relief.
bool IsSeen(const std::vector<relevo::Relief>& reliefs, const relevo::dvec4& world)
{
  for (const relevo::Relief& relief : reliefs)
  {
    const relevo::dvec4 place = relief.GetWorldToTexel() * world;
    const relevo::dvec3 texel = relevo::dvec3(place) / place.w;
    const int column = static_cast<int>(std::lround(texel.x));
    const int row = static_cast<int>(std::lround(texel.y));
    if (column < 0 || row < 0 || column >= relief.GetWidth() || row >= relief.GetHeight())
    {
      continue;
    }
    const double height = relief.GetTexelHeight(column, row);
    const relevo::dvec3 seen = relief.GetWorldPoint(column, row, height);
    const double width = distance(seen, relief.GetWorldPoint(column + 1, row, height));
    if (distance(seen, relevo::dvec3(world)) < 2.0 * width)
    {
      return true;
    }
  }
  return false;
}

// Share of the object's captured pixels that the picture does not show.
double GetHoles(BenchmarkView& view, const std::vector<relevo::Relief>& reliefs,
  const Picture& object, const Picture& picture)
{
  const BenchmarkPixelPoints points(view);
  double holes = 0.0;
  double pixels = 0.0;
  for (int i = 0; i < points.GetNumberOfPixels(); ++i)
  {
    if (object.Depths[i] < 1.0f)
    {
      const auto point = points.Get(i, object.Depths[i]);
      const bool isHole = picture.Depths[i] == 1.0f &&
        IsSeen(reliefs, relevo::dvec4(point[0], point[1], point[2], 1.0));
      holes += isHole ? 1.0 : 0.0;
      ++pixels;
    }
  }
  return holes / pixels;
}
}

void AddReliefPictures(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("relief-pictures",
    "Pictures of four captures against those of the mesh that they show",
    { { "degrees", "degrees from a capture", 1 }, { "way", "drawn by", 0 }, { "ssim", "SSIM", 4 },
      { "ssim_pixel_mesh", "mesh of pixels", 4 }, { "holes_percent", "holes, %", 3 },
      { "holes_pixel_mesh_percent", "mesh of pixels, %", 3 } });
  const int size = options.Quick ? 128 : 1024;
  const BenchmarkReliefScene scene(options.Quick ? 5e3 : 1e6);
  BenchmarkView view(options.Quick ? 128 : 1024, options.Quick ? 96 : 768);
  scene.SetUp(view);
  const auto blocks = scene.Capture(view, size);
  const auto images = GetReliefs(blocks);
  std::vector<relevo::Relief> reliefs(images.size());
  for (size_t i = 0; i < images.size(); ++i)
  {
    reliefs[i].Read(images[i]);
  }
  vtkNew<vtkActor> object;
  object->SetMapper(scene.MakeMapper());
  const auto pixels = MakePixelMeshActor(MakePixelMesh(images));
  std::vector<vtkSmartPointer<vtkActor>> ways;
  for (const ReliefWay way : GetReliefWays())
  {
    ways.push_back(MakeReliefActor(way, blocks));
  }
  vtkCamera* camera = view.GetRenderer()->GetActiveCamera();
  vtkNew<vtkCamera> start;
  start->DeepCopy(camera);
  for (const ViewAngles& angles : Views)
  {
    camera->DeepCopy(start);
    camera->Azimuth(angles.Azimuth);
    camera->Elevation(angles.Elevation);
    const Picture truth = Draw(view, object);
    const Picture rival = Draw(view, pixels);
    const auto similarity = [&](const Picture& picture)
    {
      return relevo::GetPictureSimilarity(
        truth.Colors, picture.Colors, view.GetWidth(), view.GetHeight());
    };
    const double rivalSimilarity = similarity(rival);
    const double rivalHoles = GetHoles(view, reliefs, truth, rival);
    for (size_t i = 0; i < ways.size(); ++i)
    {
      const Picture picture = Draw(view, ways[i]);
      table.AddRow({ angles.FromCapture, GetName(GetReliefWays()[i]), similarity(picture),
        rivalSimilarity, 100.0 * GetHoles(view, reliefs, truth, picture), 100.0 * rivalHoles });
    }
  }
  table.AddNote("SSIM: greys, windows of 7 x 7, the whole picture. Asked: at least 0.98, no less "
                "than the mesh of pixels has, and 0.5 % holes.");
  addTable(table);
}
