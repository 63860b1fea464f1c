// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeCompositing.h"

#include "Checks/MemoryGuard.h"
#include "Checks/ShouldReport.h"
#include "Mesh/MeshExtent.h"
#include "OpaqueScenePass.h"
#include "PeeledPicture.h"
#include "Segments/RaySegments.h"
#include "Segments/SegmentMerger.h"
#include "Stages/SegmentRequest.h"
#include "TranslucentLayers.h"
#include "vtkCameraPass.h"
#include "vtkCommand.h"
#include "vtkFloatArray.h"
#include "vtkGPUUnstructuredGridVolumeMapper.h"
#include "vtkIceTCompositePass.h"
#include "vtkImageProcessingPass.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProcessModule.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSynchronizedRenderers.h"
#include "vtkTimerLog.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

// The nearest fragments and segments of a pixel that are kept.
template <typename Volumes>
int GetMaximumSegments(const Volumes& volumes)
{
  int most = 1;
  for (const auto& volume : volumes)
  {
    most = std::max(most, GetMapper(*volume)->GetMaximumSegments());
  }
  return most;
}

// Send segments to the root, which gets those of all ranks.
std::vector<Bytes> Send(const Bytes& own, const RankExchange& ranks)
{
  const std::string event =
    "Adaptive Volume: send " + std::to_string(own.size()) + " bytes of segments";
  const vtkTimerLogScope timer(event.c_str());
  return ranks.Gather(own);
}

// Blend premultiplied colours over others.
void BlendOver(const ColorPicture& colors, ColorPicture& pixels)
{
  for (size_t i = 0; i < std::min(colors.size(), pixels.size()); ++i)
  {
    const float clear = 1.0f - colors[4 * (i / 4) + 3];
    pixels[i] = colors[i] + clear * pixels[i];
  }
}

// Unpack the messages of the ranks. Those of ranks without segments are left out.
std::vector<RaySegments> Unpack(const std::vector<Bytes>& messages)
{
  std::vector<RaySegments> pieces;
  for (const Bytes& message : messages)
  {
    RaySegments piece;
    if (piece.Unpack(message) && piece.GetNumberOfSegments() > 0)
    {
      pieces.push_back(std::move(piece));
    }
  }
  return pieces;
}
}

/// The picture of a frame, whose pixels only the root has.
struct VolumeCompositing::Picture
{
  vtkSynchronizedRenderers::vtkRawImage Tile;
  PictureSize Size = { { 0, 0 } };
  bool HasLayers = false;           // translucent objects, which ParaView would order
  std::vector<float> OpaqueDepths;  // of the tile
  SegmentRequest Request;           // of a slab
  std::vector<ColorPicture> Colors; // to blend over the tile

  // The volumes of a slab have a single picture.
  void Add(ColorPicture colors)
  {
    if (this->HasLayers)
    {
      BlendOver(colors, this->Colors.front());
    }
    else
    {
      this->Colors.push_back(std::move(colors));
    }
  }

  void BlendOverTile()
  {
    constexpr float White = 255.0f;
    unsigned char* const bytes = this->Tile.GetRawPtr()->GetPointer(0);
    ColorPicture pixels(bytes, bytes + this->Tile.GetRawPtr()->GetNumberOfValues());
    for (float& pixel : pixels)
    {
      pixel /= White;
    }
    for (const ColorPicture& colors : this->Colors)
    {
      BlendOver(colors, pixels);
    }
    std::transform(pixels.begin(), pixels.end(), bytes,
      [](float value)
      { return static_cast<unsigned char>(std::lround(White * std::clamp(value, 0.0f, 1.0f))); });
  }
};

/// The piece of a volume on this rank, and the extent of all pieces.
struct VolumeCompositing::PieceView
{
  MeshExtent Whole;
  bool IsDrawn = false;
};

vtkStandardNewMacro(VolumeCompositing);

VolumeCompositing::VolumeCompositing()
  : Opaque(vtkSmartPointer<OpaqueScenePass>::New())
  , Translucent(vtkSmartPointer<TranslucentLayers>::New())
{
}

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
  // ParaView's own observers, of priority 0, composite between these.
  own->Renderer = renderer;
  own->BeginTag =
    renderer->AddObserver(vtkCommand::StartEvent, own.Get(), &VolumeCompositing::BeginFrame, 1.0f);
  own->EndTag =
    renderer->AddObserver(vtkCommand::EndEvent, own.Get(), &VolumeCompositing::EndFrame, -1.0f);
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
  if (!this->All.empty())
  {
    return;
  }
  renderer->RemoveObserver(this->BeginTag);
  renderer->RemoveObserver(this->EndTag);
  this->Translucent->ReleaseGraphicsResources(renderer->GetRenderWindow());
  this->Overlay.ReleaseGraphicsResources();
  vtkCameraPass* camera = FindCameraPass(renderer);
  if (camera && camera->GetDelegatePass() == this)
  {
    camera->SetDelegatePass(this->IceT);
  }
}

// Return whether ParaView puts the composited picture into the window of this process, without
// processing it before.
bool VolumeCompositing::IsShownHere() const
{
  return vtkProcessModule::GetProcessType() == vtkProcessModule::PROCESS_BATCH &&
    RankExchange(this->IceT->GetController()).IsRoot() && !this->IceT->GetDisplayRGBAResults();
}

void VolumeCompositing::BeginFrame()
{
  int tiles[2];
  this->IceT->GetTileDimensions(tiles);
  if (this->IsShownHere() && tiles[0] * tiles[1] == 1 && !this->FindVisible().empty() &&
    !this->Renderer->GetSelector())
  {
    this->Overlay.BeginFrame(this->Renderer);
  }
}

void VolumeCompositing::EndFrame()
{
  if (this->Overlay.IsInFrame())
  {
    this->Overlay.EndFrame(this->Renderer);
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
  picture.HasLayers = this->IceT->GetUseOrderedCompositing();
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
    const FragmentLayers layers =
      picture.HasLayers ? this->FindLayers(state, volumes, ranks, picture) : FragmentLayers();
    CompositeAll(renderer, volumes, ranks, layers, picture);
  }
  if (this->Overlay.IsInFrame())
  {
    this->Overlay.SetPictures(std::move(picture.Colors), picture.Size, picture.HasLayers);
  }
  else if (picture.Tile.IsValid())
  {
    picture.BlendOverTile();
    if (isDisplayed)
    {
      picture.Tile.PushToViewport(renderer);
    }
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

// With translucent objects, these are the opaque ones.
void VolumeCompositing::DrawOthers(const vtkRenderState* state, Picture& picture)
{
  const vtkSmartPointer<vtkRenderPass> own = this->IceT->GetRenderPass();
  if (picture.HasLayers)
  {
    this->IceT->SetUseOrderedCompositing(false);
    this->IceT->SetRenderPass(this->Opaque);
  }
  this->IceT->Render(state);
  if (picture.HasLayers)
  {
    this->IceT->SetUseOrderedCompositing(true);
    this->IceT->SetRenderPass(own);
  }
  this->NumberOfRenderedProps = this->IceT->GetNumberOfRenderedProps();
  this->IceT->GetLastRenderedTile(picture.Tile);
  if (vtkFloatArray* depths = this->IceT->GetLastRenderedDepths())
  {
    picture.OpaqueDepths.assign(depths->Begin(), depths->End());
  }
}

// Give the size and the depths to all ranks. Return false if there is no picture.
bool VolumeCompositing::Share(const RankExchange& ranks, Picture& picture)
{
  const bool isValid = picture.Tile.IsValid();
  const PictureSize own = { { isValid ? picture.Tile.GetWidth() : 0,
    isValid ? picture.Tile.GetHeight() : 0 } };
  picture.Size = ranks.Share(own)[RankExchange::Root];
  std::vector<float>& depths = picture.OpaqueDepths;
  ranks.Broadcast(depths);
  return picture.Size[0] > 0 &&
    depths.size() == static_cast<size_t>(picture.Size[0]) * static_cast<size_t>(picture.Size[1]);
}

// Exchange the translucent fragments of all ranks.
FragmentLayers VolumeCompositing::FindLayers(const vtkRenderState* state, const Volumes& volumes,
  const RankExchange& ranks, const Picture& picture)
{
  const int most = GetMaximumSegments(volumes);
  CompositedVolume& first = *volumes.front();
  FragmentLayers layers;
  Bytes own;
  bool fits = FitsMemory(
    [&]
    {
      RaySegments fragments;
      fragments.Reset(picture.Size[0], picture.Size[1], {});
      if (!this->Translucent->Read(state, picture.OpaqueDepths, most, fragments))
      {
        first.Reports.Add(
          true, "There is not enough graphics memory for the fragments of translucent objects.");
      }
      own = fragments.Pack();
    });
  const std::vector<Bytes> messages = ranks.Gather(own);
  if (ranks.IsRoot())
  {
    fits = FitsMemory([&] { layers.Merge(Unpack(messages), most); }) && fits;
  }
  if (!fits)
  {
    first.Reports.Add(true, "Not enough memory for the fragments of translucent objects.");
  }
  layers.Share(ranks);
  if (ranks.IsRoot())
  {
    this->ReportLostFragments(first, layers.CountLostPixels(), most);
  }
  return layers;
}

void VolumeCompositing::ReportLostFragments(CompositedVolume& volume, vtkIdType lost, int most)
{
  if (lost > 0 && !this->HasLostFragments)
  {
    volume.Report({ false,
      std::to_string(lost) + " pixels have more than " + std::to_string(most) +
        " fragments of translucent objects. The nearest are drawn. Increase MaximumSegments." });
  }
  this->HasLostFragments = lost > 0;
}

// Find the extent of all pieces, and whether this rank has a piece that can be drawn.
VolumeCompositing::PieceView VolumeCompositing::AddUp(
  vtkRenderer* renderer, CompositedVolume& volume, const RankExchange& ranks)
{
  PieceView view;
  vtkGPUUnstructuredGridVolumeMapper* mapper = GetMapper(volume);
  const PieceInfo own = { mapper->MeasurePiece(renderer, volume.Prop), volume.NumberOfComponents };
  const std::vector<PieceInfo> pieces = ranks.Share(own);
  const auto first = std::find_if(
    pieces.begin(), pieces.end(), [](const PieceInfo& piece) { return !piece.Extent.IsEmpty(); });
  for (auto piece = first; piece != pieces.end(); ++piece)
  {
    if (!piece->Extent.IsEmpty() && piece->NumberOfComponents == first->NumberOfComponents)
    {
      view.Whole.Add(piece->Extent);
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
  view.IsDrawn = !own.Extent.IsEmpty() && !isOther;
  return view;
}

void VolumeCompositing::CompositeAll(vtkRenderer* renderer, const Volumes& volumes,
  const RankExchange& ranks, const FragmentLayers& layers, Picture& picture)
{
  std::vector<PieceView> pieces;
  for (const auto& volume : volumes)
  {
    pieces.push_back(AddUp(renderer, *volume, ranks));
    volume->LostPixels.clear();
  }
  const auto composite = [&]
  {
    for (size_t i = 0; i < volumes.size(); ++i)
    {
      Composite(renderer, *volumes[i], pieces[i], ranks, picture);
    }
  };
  if (picture.HasLayers)
  {
    CompositeSlabs(composite, ranks.IsRoot(), layers, picture);
  }
  else
  {
    picture.Request.Depths = picture.OpaqueDepths;
    composite();
  }
  for (const auto& volume : volumes)
  {
    ReportLostSegments(*volume);
    for (const RankReport& report : volume->Reports.Gather(ranks))
    {
      volume->Report(report);
    }
  }
}

// Blend the slabs of the volumes and the layers of fragments between them.
void VolumeCompositing::CompositeSlabs(const std::function<void()>& composite, bool isRoot,
  const FragmentLayers& layers, Picture& picture)
{
  const size_t pixels = isRoot ? picture.OpaqueDepths.size() : 0;
  PeeledPicture peeled(pixels);
  const auto add = [&](int slab, FragmentLayers::Part part)
  {
    layers.SetSlab(slab, part, picture.OpaqueDepths, picture.Request);
    picture.Colors.assign(1, ColorPicture(4 * pixels, 0.0f));
    composite();
    if (isRoot)
    {
      layers.Add(slab, part, picture.Colors.front(), peeled);
    }
  };
  const int last = layers.GetNumberOfLayers();
  for (int slab = last; slab >= 0; --slab)
  {
    add(slab, FragmentLayers::Part::Back);
  }
  for (int slab = 0; last > 0 && slab <= last / 2; ++slab)
  {
    add(slab, FragmentLayers::Part::Front);
  }
  picture.Colors.assign(1, peeled.Merge());
}

void VolumeCompositing::Composite(vtkRenderer* renderer, CompositedVolume& volume,
  const PieceView& piece, const RankExchange& ranks, Picture& picture)
{
  picture.Request.Whole = piece.Whole;
  Bytes own;
  const bool fits = FitsMemory(
    [&]
    {
      const vtkTimerLogScope timer("Adaptive Volume: cast rays");
      RaySegments segments;
      if (piece.IsDrawn &&
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
}

// Merge the segments of all ranks and blend them over the picture.
void VolumeCompositing::Blend(
  CompositedVolume& volume, const std::vector<Bytes>& messages, Picture& picture)
{
  const vtkTimerLogScope timer("Adaptive Volume: merge segments");
  const std::vector<RaySegments> received = Unpack(messages);
  std::vector<const RaySegments*> pieces;
  for (const RaySegments& piece : received)
  {
    pieces.push_back(&piece);
  }
  MarkLostPixels(pieces, volume.LostPixels);
  TransferFunctions functions;
  std::string error;
  std::string warning;
  const MeshExtent& whole = picture.Request.Whole;
  if (!pieces.empty() &&
    functions.Read(volume.Prop->GetProperty(), whole.NumberOfComponents, error, warning))
  {
    picture.Add(MapSegments(MergeSegments(pieces), functions, whole));
  }
}

void VolumeCompositing::ReportLostSegments(CompositedVolume& volume)
{
  const auto lost = std::count(volume.LostPixels.begin(), volume.LostPixels.end(), true);
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
  this->Translucent->ReleaseGraphicsResources(window);
  this->Overlay.ReleaseGraphicsResources();
}
}
