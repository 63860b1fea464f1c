// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeCompositing.h"

#include "Checks/MemoryGuard.h"
#include "Checks/ShouldReport.h"
#include "Mesh/MeshExtent.h"
#include "Segments/RaySegments.h"
#include "Segments/SegmentMerger.h"
#include "Stages/SegmentRequest.h"
#include "vtkCameraPass.h"
#include "vtkFloatArray.h"
#include "vtkGPUUnstructuredGridVolumeMapper.h"
#include "vtkIceTCompositePass.h"
#include "vtkImageProcessingPass.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSynchronizedRenderers.h"
#include "vtkTimerLog.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace relevo
{
namespace
{
// Return the camera pass of a view's renderer, behind the passes for images.
vtkCameraPass* FindCameraPass(vtkRenderer* renderer)
{
  vtkRenderPass* pass = renderer->GetPass();
  while (auto* image = vtkImageProcessingPass::SafeDownCast(pass))
  {
    pass = image->GetDelegatePass();
  }
  return vtkCameraPass::SafeDownCast(pass);
}

vtkGPUUnstructuredGridVolumeMapper* GetMapper(const CompositedVolume& volume)
{
  return vtkGPUUnstructuredGridVolumeMapper::SafeDownCast(volume.Prop->GetMapper());
}

struct PieceInfo
{
  MeshExtent Extent;
  int NumberOfComponents;
};

using PictureSize = std::array<int, 2>;

constexpr float White = 255.0f;

// Send segments to the root, which gets those of all ranks.
std::vector<Bytes> Send(const Bytes& own, const RankExchange& ranks)
{
  const std::string event =
    "Adaptive Volume: send " + std::to_string(own.size()) + " bytes of segments";
  const vtkTimerLogScope timer(event.c_str());
  return ranks.Gather(own);
}

// Blend premultiplied colours over pixels from 0 to White.
void BlendOver(const std::vector<float>& colors, std::vector<float>& pixels)
{
  for (size_t i = 0; i < std::min(colors.size(), pixels.size()); ++i)
  {
    const float clear = 1.0f - colors[4 * (i / 4) + 3];
    pixels[i] = White * colors[i] + clear * pixels[i];
  }
}
}

/// The picture of a frame, whose pixels only the root has.
struct VolumeCompositing::Picture
{
  vtkSynchronizedRenderers::vtkRawImage Tile;
  PictureSize Size = { { 0, 0 } };
  SegmentRequest Request;    // with the depths of the opaque scene
  std::vector<float> Pixels; // of the tile; they are rounded once, after all volumes

  void TakePixels()
  {
    if (this->Pixels.empty())
    {
      const unsigned char* const from = this->Tile.GetRawPtr()->GetPointer(0);
      this->Pixels.assign(from, from + this->Tile.GetRawPtr()->GetNumberOfValues());
    }
  }
  void StorePixels()
  {
    std::transform(this->Pixels.begin(), this->Pixels.end(), this->Tile.GetRawPtr()->GetPointer(0),
      [](float value)
      { return static_cast<unsigned char>(std::lround(std::clamp(value, 0.0f, White))); });
  }
};

vtkStandardNewMacro(VolumeCompositing);

VolumeCompositing::VolumeCompositing() = default;
VolumeCompositing::~VolumeCompositing() = default;

vtkSmartPointer<VolumeCompositing> VolumeCompositing::Install(vtkRenderer* renderer)
{
  vtkCameraPass* camera = FindCameraPass(renderer);
  vtkRenderPass* pass = camera ? camera->GetDelegatePass() : nullptr;
  if (auto* own = VolumeCompositing::SafeDownCast(pass))
  {
    return own;
  }
  auto* composite = vtkIceTCompositePass::SafeDownCast(pass);
  if (!composite)
  {
    return nullptr;
  }
  auto own = vtkSmartPointer<VolumeCompositing>::New();
  own->IceT = composite;
  camera->SetDelegatePass(own);
  return own;
}

void VolumeCompositing::Add(const std::shared_ptr<CompositedVolume>& volume)
{
  if (std::find(this->All.begin(), this->All.end(), volume) == this->All.end())
  {
    this->All.push_back(volume);
  }
}

void VolumeCompositing::Remove(
  const std::shared_ptr<CompositedVolume>& volume, vtkRenderer* renderer)
{
  this->All.erase(std::remove(this->All.begin(), this->All.end(), volume), this->All.end());
  vtkCameraPass* camera = FindCameraPass(renderer);
  if (this->All.empty() && camera && camera->GetDelegatePass() == this)
  {
    camera->SetDelegatePass(this->IceT);
  }
}

VolumeCompositing::Volumes VolumeCompositing::FindVisible() const
{
  Volumes visible;
  std::copy_if(this->All.begin(), this->All.end(), std::back_inserter(visible),
    [](const std::shared_ptr<CompositedVolume>& volume)
    { return volume->Prop->GetVisibility() && volume->Prop->IsComposited(); });
  return visible;
}

void VolumeCompositing::Render(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  const Volumes volumes = this->FindVisible();
  if (volumes.empty() || renderer->GetSelector() || this->HasTiles(volumes))
  {
    this->IceT->Render(state);
    this->NumberOfRenderedProps = this->IceT->GetNumberOfRenderedProps();
    return;
  }
  // Passes that process images need the picture with the volumes.
  const bool isDisplayed = this->IceT->GetDisplayRGBAResults();
  this->IceT->SetDisplayRGBAResults(false);
  Picture picture;
  this->DrawOthers(state, picture);
  this->IceT->SetDisplayRGBAResults(isDisplayed);
  const RankExchange ranks(this->IceT->GetController());
  if (Share(ranks, picture))
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    vtkOpenGLState::ScopedglViewport viewport(window->GetState());
    vtkOpenGLState::ScopedglScissor scissor(window->GetState());
    window->GetState()->vtkglViewport(0, 0, picture.Size[0], picture.Size[1]);
    window->GetState()->vtkglScissor(0, 0, picture.Size[0], picture.Size[1]);
    for (const auto& volume : volumes)
    {
      Composite(renderer, *volume, ranks, picture);
    }
    picture.StorePixels();
  }
  if (isDisplayed && picture.Tile.IsValid())
  {
    picture.Tile.PushToViewport(renderer);
  }
}

// The tiles of a display have pictures on several ranks.
bool VolumeCompositing::HasTiles(const Volumes& volumes)
{
  int tiles[2];
  this->IceT->GetTileDimensions(tiles);
  const bool hasTiles = tiles[0] * tiles[1] > 1;
  if (hasTiles && !this->IsReported && RankExchange(this->IceT->GetController()).IsRoot())
  {
    volumes.front()->Report({ false, "Volumes on several ranks are not drawn in tiled displays." });
  }
  this->IsReported = hasTiles;
  return hasTiles;
}

void VolumeCompositing::DrawOthers(const vtkRenderState* state, Picture& picture)
{
  this->IceT->Render(state);
  this->NumberOfRenderedProps = this->IceT->GetNumberOfRenderedProps();
  this->IceT->GetLastRenderedTile(picture.Tile);
  if (vtkFloatArray* depths = this->IceT->GetLastRenderedDepths())
  {
    picture.Request.Depths.assign(depths->Begin(), depths->End());
  }
}

// Give the size and the depths to all ranks. Return false if there is no picture.
bool VolumeCompositing::Share(const RankExchange& ranks, Picture& picture)
{
  const bool isValid = picture.Tile.IsValid();
  const PictureSize own = { { isValid ? picture.Tile.GetWidth() : 0,
    isValid ? picture.Tile.GetHeight() : 0 } };
  picture.Size = ranks.Share(own)[RankExchange::Root];
  std::vector<float>& depths = picture.Request.Depths;
  ranks.Broadcast(depths);
  return picture.Size[0] > 0 &&
    depths.size() == static_cast<size_t>(picture.Size[0]) * static_cast<size_t>(picture.Size[1]);
}

// Find the extent of all pieces. Return whether this rank has a piece that can be drawn.
bool VolumeCompositing::AddUp(
  vtkRenderer* renderer, CompositedVolume& volume, const RankExchange& ranks, MeshExtent& whole)
{
  vtkGPUUnstructuredGridVolumeMapper* mapper = GetMapper(volume);
  const PieceInfo own = { mapper->MeasurePiece(renderer, volume.Prop), volume.NumberOfComponents };
  const std::vector<PieceInfo> pieces = ranks.Share(own);
  const auto first = std::find_if(
    pieces.begin(), pieces.end(), [](const PieceInfo& piece) { return !piece.Extent.IsEmpty(); });
  for (auto piece = first; piece != pieces.end(); ++piece)
  {
    if (!piece->Extent.IsEmpty() && piece->NumberOfComponents == first->NumberOfComponents)
    {
      whole.Add(piece->Extent);
    }
  }
  const bool isOther = !own.Extent.IsEmpty() && own.NumberOfComponents != first->NumberOfComponents;
  const char* const name = mapper->GetArrayName();
  const std::string error = isOther ? std::string("Array \"") + (name ? name : "") + "\" has " +
      std::to_string(own.NumberOfComponents) + " components, but " +
      std::to_string(first->NumberOfComponents) + " on rank " +
      std::to_string(first - pieces.begin()) + ". The cells of this rank are not drawn."
                                    : "";
  if (ShouldReport(volume.MismatchError, error))
  {
    volume.Reports.Add(true, error);
  }
  return !own.Extent.IsEmpty() && !isOther;
}

void VolumeCompositing::Composite(
  vtkRenderer* renderer, CompositedVolume& volume, const RankExchange& ranks, Picture& picture)
{
  picture.Request.Whole = MeshExtent();
  const bool hasCells = AddUp(renderer, volume, ranks, picture.Request.Whole);
  Bytes own;
  const bool fits = FitsMemory(
    [&]
    {
      const vtkTimerLogScope timer("Adaptive Volume: cast rays");
      RaySegments segments;
      if (hasCells &&
        GetMapper(volume)->CastSegments(renderer, volume.Prop, picture.Request, segments))
      {
        own = segments.Pack();
      }
    });
  const std::vector<Bytes> messages = Send(own, ranks);
  if (!fits || (ranks.IsRoot() && !FitsMemory([&] { Blend(volume, messages, picture); })))
  {
    volume.Reports.Add(true, "Not enough memory for the picture.");
  }
  for (const RankReport& report : volume.Reports.Gather(ranks))
  {
    volume.Report(report);
  }
}

// Merge the segments of all ranks and blend them over the picture.
void VolumeCompositing::Blend(
  CompositedVolume& volume, const std::vector<Bytes>& messages, Picture& picture)
{
  const vtkTimerLogScope timer("Adaptive Volume: merge segments");
  std::vector<RaySegments> received(messages.size());
  std::vector<const RaySegments*> pieces;
  for (size_t rank = 0; rank < messages.size(); ++rank)
  {
    if (received[rank].Unpack(messages[rank]) && received[rank].GetNumberOfSegments() > 0)
    {
      pieces.push_back(&received[rank]);
    }
  }
  TransferFunctions functions;
  std::string error;
  std::string warning;
  const MeshExtent& whole = picture.Request.Whole;
  if (!pieces.empty() &&
    functions.Read(volume.Prop->GetProperty(), whole.NumberOfComponents, error, warning))
  {
    picture.TakePixels();
    BlendOver(MapSegments(MergeSegments(pieces), functions, whole), picture.Pixels);
  }
  const vtkIdType lost = CountLostPixels(pieces);
  if (lost > 0 && !volume.HasLost)
  {
    const int most = GetMapper(volume)->GetMaximumSegments();
    volume.Report({ false,
      "The rays of " + std::to_string(lost) + " pixels have more than " + std::to_string(most) +
        " segments on a rank. The nearest are drawn. Increase MaximumSegments." });
  }
  volume.HasLost = lost > 0;
}

void VolumeCompositing::ReleaseGraphicsResources(vtkWindow* window)
{
  this->IceT->ReleaseGraphicsResources(window);
}
}
