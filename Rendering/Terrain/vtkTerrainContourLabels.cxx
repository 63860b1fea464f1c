// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainContourLabels.h"

#include "Bisection/AdaptiveTerrain.h"
#include "Changes/Dependencies.h"
#include "Checks/SettingChecks.h"
#include "Labels/ContourAnchors.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkStdString.h" // for a conversion of texts
#include "vtkTerrainMapper.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <vector>

namespace
{
using Anchor = relevo::ContourAnchors::Anchor;

constexpr std::size_t LargestNumberOfLabels = 256;
constexpr double Gap = 4.0; // between labels, in pixels
// Labels that were drawn before stay until others are nearer than this share of the spacing.
constexpr double SpacingShare = 0.7;
// The triangles are within the error of the terrain, so places are tested this far in front.
constexpr double PixelsInFront = 4.0;

// Where a place is in the picture, in pixels of the viewport.
struct LabelPlace
{
  double X = 0.0;
  double Y = 0.0;
  double Depth = 0.0; // of a point in front of it
  std::array<double, 3> World = { { 0.0, 0.0, 0.0 } };
};

// A camera and the depths of the opaque props.
class LabelView
{
public:
  LabelView(vtkRenderer* renderer, vtkActor* actor)
    : IsParallel(renderer->GetActiveCamera()->GetParallelProjection() != 0)
  {
    vtkCamera* camera = renderer->GetActiveCamera();
    int corner[2];
    renderer->GetTiledSizeAndOrigin(&this->Size[0], &this->Size[1], &corner[0], &corner[1]);
    this->ToWorld->DeepCopy(actor->GetMatrix());
    this->ToScreen->DeepCopy(
      camera->GetCompositeProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0));
    camera->GetPosition(this->Eye.data());
    camera->GetDirectionOfProjection(this->Direction.data());
    const double half = vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle());
    this->UnitsPerPixel =
      (this->IsParallel ? camera->GetParallelScale() : std::tan(half)) * 2.0 / this->Size[1];
    this->Depths.resize(static_cast<std::size_t>(this->Size[0]) * this->Size[1]);
    renderer->GetRenderWindow()->GetZbufferData(corner[0], corner[1], corner[0] + this->Size[0] - 1,
      corner[1] + this->Size[1] - 1, this->Depths.data());
  }

  // Returns whether the place is in front of the camera.
  bool Project(const std::array<double, 3>& position, LabelPlace& place) const
  {
    double point[4] = { position[0], position[1], position[2], 1.0 };
    this->ToWorld->MultiplyPoint(point, point);
    std::array<double, 3> toEye;
    double distance = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      place.World[i] = point[i] / point[3];
      toEye[i] = this->IsParallel ? -this->Direction[i] : this->Eye[i] - place.World[i];
      distance += toEye[i] * toEye[i];
    }
    // Both have the scale of `toEye`.
    const double inFront = PixelsInFront * this->UnitsPerPixel;
    double screen[4];
    double front[4];
    double moved[4] = { 0.0, 0.0, 0.0, 1.0 };
    for (int i = 0; i < 3; ++i)
    {
      point[i] = place.World[i];
      moved[i] = place.World[i] + inFront * toEye[i];
    }
    point[3] = 1.0;
    this->ToScreen->MultiplyPoint(point, screen);
    this->ToScreen->MultiplyPoint(moved, front);
    if (!(distance > 0.0 && screen[3] > 0.0 && front[3] > 0.0))
    {
      return false;
    }
    place.X = 0.5 * (screen[0] / screen[3] + 1.0) * this->Size[0];
    place.Y = 0.5 * (screen[1] / screen[3] + 1.0) * this->Size[1];
    place.Depth = 0.5 * (front[2] / front[3] + 1.0);
    return screen[2] >= -screen[3] && screen[2] <= screen[3];
  }

  bool IsInside(const LabelPlace& place, const std::array<double, 2>& half) const
  {
    return place.X - half[0] >= Gap && place.X + half[0] <= this->Size[0] - Gap &&
      place.Y - half[1] >= Gap && place.Y + half[1] <= this->Size[1] - Gap;
  }

  // Returns whether no opaque prop hides a place that is inside.
  bool IsVisible(const LabelPlace& place) const
  {
    float farthest = 0.0f;
    for (int k = 0; k < 9; ++k)
    {
      const int x = std::clamp(static_cast<int>(place.X) + k % 3 - 1, 0, this->Size[0] - 1);
      const int y = std::clamp(static_cast<int>(place.Y) + k / 3 - 1, 0, this->Size[1] - 1);
      farthest = std::max(farthest, this->Depths[static_cast<std::size_t>(y) * this->Size[0] + x]);
    }
    return place.Depth <= farthest;
  }

private:
  bool IsParallel;
  std::array<int, 2> Size = { { 0, 0 } };
  vtkNew<vtkMatrix4x4> ToWorld;
  vtkNew<vtkMatrix4x4> ToScreen;
  std::array<double, 3> Eye;
  std::array<double, 3> Direction;
  double UnitsPerPixel = 1.0; // with perspective, at the distance 1
  std::vector<float> Depths;
};

struct Label
{
  Anchor Place;
  std::string Text;
  LabelPlace OnScreen;
  std::array<double, 2> Half = { { 0.0, 0.0 } }; // size in pixels
};

bool AreApart(const Label& a, const Label& b, double spacing)
{
  const double x = std::abs(a.OnScreen.X - b.OnScreen.X);
  const double y = std::abs(a.OnScreen.Y - b.OnScreen.Y);
  return std::hypot(x, y) >= spacing &&
    (x >= a.Half[0] + b.Half[0] + Gap || y >= a.Half[1] + b.Half[1] + Gap);
}

// Multiples of five intervals come first. The order of others is arbitrary, but constant.
std::array<double, 3> GetOrder(const Anchor& anchor, double interval)
{
  const bool isMajor = std::fmod(std::round(anchor.Value / interval), 5.0) == 0.0;
  return { { isMajor ? 0.0 : 1.0, std::fmod(anchor.Sample[0] * 0.618034 + anchor.Sample[1], 1.0),
    anchor.Sample[0] } };
}
}

struct vtkTerrainContourLabels::vtkInternals
{
  relevo::ContourAnchors Anchors;
  relevo::Dependencies Source; // of the anchors
  std::vector<Label> Labels;   // of the last frame
  std::vector<vtkSmartPointer<vtkTextActor>> Texts;
  std::map<std::string, std::array<double, 2>> Sizes; // half, of texts
  relevo::Dependencies Font;

  const std::array<double, 2>& GetHalf(
    const std::string& text, vtkTextProperty* property, int resolution);
};

const std::array<double, 2>& vtkTerrainContourLabels::vtkInternals::GetHalf(
  const std::string& text, vtkTextProperty* property, int resolution)
{
  const auto known = this->Sizes.find(text);
  if (known != this->Sizes.end())
  {
    return known->second;
  }
  int box[4] = { 0, 0, 0, 0 };
  if (vtkTextRenderer* renderer = vtkTextRenderer::GetInstance())
  {
    renderer->GetBoundingBox(property, text, box, resolution);
  }
  return this->Sizes[text] = { { 0.5 * (box[1] - box[0] + 1), 0.5 * (box[3] - box[2] + 1) } };
}

vtkStandardNewMacro(vtkTerrainContourLabels);

vtkTerrainContourLabels::vtkTerrainContourLabels()
  : TextProperty(vtkSmartPointer<vtkTextProperty>::New())
  , Internals(new vtkInternals)
{
  this->TextProperty->SetColor(0.0, 0.0, 0.0);
  this->TextProperty->SetBackgroundColor(1.0, 1.0, 1.0);
  this->TextProperty->SetBackgroundOpacity(0.6);
  this->TextProperty->SetFontSize(12);
  this->TextProperty->SetJustificationToCentered();
  this->TextProperty->SetVerticalJustificationToCentered();
}

vtkTerrainContourLabels::~vtkTerrainContourLabels() = default;

vtkCxxSetSmartPointerMacro(vtkTerrainContourLabels, Actor, vtkActor);

vtkActor* vtkTerrainContourLabels::GetActor()
{
  return this->Actor;
}

void vtkTerrainContourLabels::SetSpacing(double pixels)
{
  relevo::SetInRange(this, "Spacing", this->Spacing, pixels, 10.0, relevo::LargestDouble);
}

void vtkTerrainContourLabels::SetTextProperty(vtkTextProperty* property)
{
  if (property && property != this->TextProperty)
  {
    this->TextProperty = property;
    this->Modified();
  }
}

vtkTextProperty* vtkTerrainContourLabels::GetTextProperty()
{
  return this->TextProperty;
}

int vtkTerrainContourLabels::GetNumberOfLabels()
{
  return static_cast<int>(this->Internals->Labels.size());
}

double vtkTerrainContourLabels::GetLabelValue(int label)
{
  return label >= 0 && label < this->GetNumberOfLabels()
    ? this->Internals->Labels[label].Place.Value
    : std::numeric_limits<double>::quiet_NaN();
}

void vtkTerrainContourLabels::GetLabelPosition(int label, double position[3])
{
  const bool isThere = label >= 0 && label < this->GetNumberOfLabels();
  for (int i = 0; i < 3; ++i)
  {
    position[i] = isThere ? this->Internals->Labels[label].OnScreen.World[i]
                          : std::numeric_limits<double>::quiet_NaN();
  }
}

void vtkTerrainContourLabels::PlaceLabels(vtkRenderer* renderer)
{
  vtkInternals& data = *this->Internals;
  std::vector<Label> last;
  last.swap(data.Labels);
  vtkTerrainMapper* mapper =
    this->Actor ? vtkTerrainMapper::SafeDownCast(this->Actor->GetMapper()) : nullptr;
  const relevo::AdaptiveTerrain* terrain = mapper ? mapper->GetDrawnTerrain() : nullptr;
  const double interval = mapper ? mapper->GetContourInterval() : 0.0;
  const int* size = renderer->GetSize();
  if (size[0] < 1 || size[1] < 1 || !terrain || !this->Actor->GetVisibility() || !(interval > 0.0))
  {
    return;
  }
  const double exaggeration = mapper->GetExaggeration();
  if (data.Source.Update(relevo::Dependencies::On(reinterpret_cast<std::size_t>(terrain),
        reinterpret_cast<std::size_t>(&terrain->GetLattice()), exaggeration, interval)))
  {
    data.Anchors.Clear();
    last.clear();
  }
  if (data.Font.Update(relevo::Dependencies::On(this->TextProperty->GetMTime())))
  {
    data.Sizes.clear();
  }
  const LabelView view(renderer, this->Actor);
  std::vector<Anchor> anchors = data.Anchors.Find(*terrain, exaggeration, interval);
  std::sort(anchors.begin(), anchors.end(),
    [interval](const Anchor& a, const Anchor& b)
    { return GetOrder(a, interval) < GetOrder(b, interval); });
  const int resolution = renderer->GetRenderWindow()->GetDPI();
  const auto add = [&](const Anchor& anchor, double spacing)
  {
    Label label;
    label.Place = anchor;
    if (data.Labels.size() >= LargestNumberOfLabels ||
      !view.Project(anchor.Position, label.OnScreen))
    {
      return;
    }
    char text[64];
    std::snprintf(text, sizeof(text), this->LabelFormat.c_str(), anchor.Value);
    label.Text = text;
    label.Half = data.GetHalf(label.Text, this->TextProperty, resolution);
    const bool isFree = view.IsInside(label.OnScreen, label.Half) &&
      std::all_of(data.Labels.begin(), data.Labels.end(),
        [&](const Label& other) { return AreApart(label, other, spacing); });
    if (isFree && view.IsVisible(label.OnScreen))
    {
      data.Labels.push_back(label);
    }
  };
  const relevo::TerrainPlacement placement = terrain->GetPlacement(exaggeration);
  for (Label& label : last)
  {
    if (data.Anchors.Update(placement, interval, label.Place))
    {
      add(label.Place, SpacingShare * this->Spacing);
    }
  }
  for (const Anchor& anchor : anchors)
  {
    add(anchor, this->Spacing);
  }
}

int vtkTerrainContourLabels::RenderOverlay(vtkViewport* viewport)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  if (!renderer || renderer->GetSelector())
  {
    return 0;
  }
  vtkInternals& data = *this->Internals;
  this->PlaceLabels(renderer);
  while (data.Texts.size() < data.Labels.size())
  {
    data.Texts.push_back(vtkSmartPointer<vtkTextActor>::New());
  }
  int drawn = 0;
  for (std::size_t i = 0; i < data.Labels.size(); ++i)
  {
    vtkTextActor* text = data.Texts[i];
    const Label& label = data.Labels[i];
    text->SetTextProperty(this->TextProperty);
    text->SetInput(label.Text.c_str());
    text->SetPosition(std::round(label.OnScreen.X), std::round(label.OnScreen.Y));
    text->RenderOpaqueGeometry(viewport); // updates the texture
    drawn += text->RenderOverlay(viewport);
  }
  return drawn > 0 ? 1 : 0;
}

void vtkTerrainContourLabels::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkTextActor* text : this->Internals->Texts)
  {
    text->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

vtkMTimeType vtkTerrainContourLabels::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->TextProperty->GetMTime());
}

void vtkTerrainContourLabels::ShallowCopy(vtkProp* prop)
{
  if (auto* other = vtkTerrainContourLabels::SafeDownCast(prop))
  {
    this->SetActor(other->Actor);
    this->SetTextProperty(other->TextProperty);
    this->SetSpacing(other->Spacing);
    this->SetLabelFormat(other->LabelFormat);
  }
  this->Superclass::ShallowCopy(prop);
}

void vtkTerrainContourLabels::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Actor: " << this->Actor.Get() << "\n";
  os << indent << "TextProperty: " << this->TextProperty.Get() << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "LabelFormat: " << this->LabelFormat << "\n";
}
