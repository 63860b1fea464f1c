// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoLICScene.h"

#include "Mathematics/PictureSimilarity.h"

#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkProperty.h"

RelevoLICPicture::RelevoLICPicture(vtkRenderWindow* window)
  : RelevoLICPicture(RelevoPicture(window))
{
}

RelevoLICPicture::RelevoLICPicture(const RelevoPicture& picture)
  : Grey(picture.Size[0], picture.Size[1])
  , Depths(picture.Depths)
{
  for (std::size_t i = 0; i < picture.GetNumberOfPixels(); ++i)
  {
    const unsigned char* color = &picture.Colors[3 * i];
    const bool isGrey = color[0] == color[1] && color[1] == color[2];
    this->Grey.Values[i] = isGrey && picture.Depths[i] < 1.0f ? color[0] / 255.0 : VTK_DOUBLE_MAX;
  }
}

bool RelevoLICPicture::HasLIC(int column, int row, int reach) const
{
  bool has = column >= reach && row >= reach && column + reach < this->Grey.Columns &&
    row + reach < this->Grey.Rows;
  for (int y = row - reach; has && y <= row + reach; ++y)
  {
    for (int x = column - reach; has && x <= column + reach; ++x)
    {
      has = this->HasLIC(x, y);
    }
  }
  return has;
}

double RelevoLICPicture::GetDepth(int column, int row) const
{
  return this->Depths[static_cast<std::size_t>(row) * this->Grey.Columns + column];
}

RelevoGrey RelevoLICPicture::GetFilled() const
{
  RelevoGrey filled = this->Grey;
  std::replace_if(
    filled.Values.begin(), filled.Values.end(), [](double value) { return value > 1.0; }, 0.33);
  return filled;
}

std::size_t RelevoLICPicture::CountLIC() const
{
  return std::count_if(
    this->Grey.Values.begin(), this->Grey.Values.end(), [](double value) { return value <= 1.0; });
}

std::ostream& operator<<(std::ostream& os, const RelevoLikeness& likeness)
{
  return os << "SSIM " << likeness.SSIM << ", mean difference " << likeness.MeanDifference << ", "
            << likeness.Different << " of " << likeness.Count << " pixels differ, "
            << likeness.OneSided << " have LIC in one picture only";
}

RelevoLikeness CompareLIC(const RelevoGrey& a, const RelevoGrey& b)
{
  constexpr int Window = 8;
  RelevoLikeness likeness;
  if (a.Columns != b.Columns || a.Rows != b.Rows)
  {
    return likeness;
  }
  likeness.MeanDifference = 0.0;
  for (std::size_t i = 0; i < a.Values.size(); ++i)
  {
    const bool inA = a.Values[i] <= 1.0;
    const bool inB = b.Values[i] <= 1.0;
    const double difference = std::abs(a.Values[i] - b.Values[i]);
    likeness.OneSided += inA != inB ? 1 : 0;
    likeness.Count += inA && inB ? 1 : 0;
    likeness.MeanDifference += inA && inB ? difference : 0.0;
    likeness.Different += inA && inB && difference > 2.5 / 255.0 ? 1 : 0;
  }
  likeness.MeanDifference /= std::max<std::size_t>(likeness.Count, 1);
  std::size_t windows = 0;
  for (int row = 0; row + Window <= a.Rows; row += Window / 2)
  {
    for (int column = 0; column + Window <= a.Columns; column += Window / 2)
    {
      relevo::WindowSimilarity similarity;
      bool isLIC = true;
      for (int i = 0; isLIC && i < Window * Window; ++i)
      {
        const double inA = a.At(column + i % Window, row + i / Window);
        const double inB = b.At(column + i % Window, row + i / Window);
        isLIC = inA <= 1.0 && inB <= 1.0;
        similarity.Add(inA, inB);
      }
      if (isLIC)
      {
        likeness.SSIM += similarity.Get();
        ++windows;
      }
    }
  }
  likeness.SSIM /= std::max<std::size_t>(windows, 1);
  return likeness;
}

RelevoLikeness CompareLIC(const RelevoLICPicture& a, const RelevoLICPicture& b)
{
  return CompareLIC(a.Grey, b.Grey);
}

RelevoLICScene::RelevoLICScene(int width, int height)
{
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Renderer->SetBackground(0.1, 0.2, 0.3);
  this->Window->AddRenderer(this->Renderer);
}

vtkAdaptiveLICMapper* RelevoLICScene::Add(vtkDataObject* mesh, vtkAdaptiveRefinement* recipe)
{
  vtkNew<vtkAdaptiveLICMapper> mapper;
  vtkSmartPointer<vtkAdaptiveRefinement> used = recipe;
  if (!used)
  {
    used = vtkSmartPointer<vtkAdaptiveRefinement>::New();
    used->SetMaximumLevel(0);
  }
  mapper->SetRefinement(used);
  mapper->SetInputDataObject(mesh);
  mapper->ScalarVisibilityOff();
  mapper->SetLICIntensity(1.0);
  mapper->SetMaskColor(1.0, 0.0, 0.0);
  mapper->SetMaskIntensity(1.0);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetInterpolationToPhong();
  this->Renderer->AddActor(actor);
  this->Actor = actor;
  return mapper;
}

void RelevoLICScene::LookAtPixels()
{
  const int* size = this->Window->GetSize();
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * size[1]);
  camera->SetFocalPoint(0.5 * size[0], 0.5 * size[1], 0.0);
  camera->SetPosition(0.5 * size[0], 0.5 * size[1], 1000.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetClippingRange(500.0, 1500.0);
}

RelevoLICPicture RelevoLICScene::Render()
{
  this->Window->Render();
  return RelevoLICPicture(this->Window);
}

vtkSmartPointer<vtkPolyData> MakePixelMesh(
  int columns, int rows, int spacing, const RelevoField& field)
{
  const int across = (columns + spacing - 1) / spacing + 1;
  const int up = (rows + spacing - 1) / spacing + 1;
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-0.5, -0.5, 0.0);
  plane->SetPoint1(-0.5 + across * spacing, -0.5, 0.0);
  plane->SetPoint2(-0.5, -0.5 + up * spacing, 0.0);
  plane->SetResolution(across, up);
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  plane->Update();
  vtkSmartPointer<vtkPolyData> mesh = plane->GetOutput();
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("Flow");
  RelevoMeshes::FillVectors(
    mesh,
    [&field](const std::array<double, 3>& p)
    {
      std::array<double, 3> vector{ { 0.0, 0.0, 0.0 } };
      field(p[0], p[1], vector.data());
      return vector;
    },
    vectors);
  mesh->GetPointData()->SetVectors(vectors);
  return mesh;
}
