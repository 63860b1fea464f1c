// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VolumeCompositing
 * @brief   a render pass that composites the volumes of a view's ranks
 *
 * It is between the camera pass of ParaView's view and the pass of IceT, which composites the other
 * props. Then each rank casts rays through its own cells up to the depths of IceT's picture, and
 * the root merges the segments of all ranks and blends them over the picture. So pieces may have
 * any shape, and no data are moved.
 *
 * If a view has translucent objects, IceT composites the opaque ones. The ranks exchange the
 * translucent fragments of each pixel, cast rays between them, and the root blends slabs of volumes
 * and layers of fragments in turn.
 *
 * If this process shows the picture in its window, the root blends over the window instead, so that
 * colours are rounded and edges are smoothed as on one rank.
 *
 * All ranks of a view need the same volumes in the same order.
 *
 * Private to the module.
 */
#ifndef VolumeCompositing_h
#define VolumeCompositing_h

#include "FragmentLayers.h"
#include "RankReports.h"
#include "VolumeProp.h"
#include "WindowOverlay.h"
#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkRenderer;
class vtkIceTCompositePass;

namespace relevo
{
class OpaqueScenePass;
class TranslucentLayers;
struct MeshExtent;

/// A volume of a view. A rank has a piece of it.
struct CompositedVolume
{
  vtkSmartPointer<VolumeProp> Prop;              // with a vtkGPUUnstructuredGridVolumeMapper
  int NumberOfComponents = 0;                    // of the array of this rank, or 0
  RankReports Reports;                           // of this rank
  std::function<void(const RankReport&)> Report; // for the root
  bool HasLost = false;                          // segments, as reported
  std::vector<bool> LostPixels;                  // of a frame, at the root
  std::string MismatchError;                     // of this rank, as reported
};

class VolumeCompositing : public vtkRenderPass
{
public:
  static VolumeCompositing* New();
  vtkTypeMacro(VolumeCompositing, vtkRenderPass);

  /// Return the pass of the renderer of a ParaView view, which is installed if needed, or nullptr
  /// if this process does not composite with IceT.
  static vtkSmartPointer<VolumeCompositing> Install(vtkRenderer* renderer);

  void Add(const std::shared_ptr<CompositedVolume>& volume);
  /// Remove a volume. Without volumes, the view's passes are as they were.
  void Remove(const std::shared_ptr<CompositedVolume>& volume, vtkRenderer* renderer);

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  VolumeCompositing();
  ~VolumeCompositing() override;

private:
  VolumeCompositing(const VolumeCompositing&) = delete;
  void operator=(const VolumeCompositing&) = delete;

  struct Picture;
  struct PieceView;
  using Volumes = std::vector<std::shared_ptr<CompositedVolume>>;
  Volumes FindVisible() const;
  bool HasTiles(const Volumes& volumes);
  bool IsShownHere() const;
  void BeginFrame();
  void EndFrame();
  void DrawOthers(const vtkRenderState* state, Picture& picture);
  static bool Share(const RankExchange& ranks, Picture& picture);
  FragmentLayers FindLayers(const vtkRenderState* state, const Volumes& volumes,
    const RankExchange& ranks, const Picture& picture);
  void ReportLostFragments(CompositedVolume& volume, vtkIdType lost, int most);
  static PieceView AddUp(
    vtkRenderer* renderer, CompositedVolume& volume, const RankExchange& ranks);
  static void CompositeAll(vtkRenderer* renderer, const Volumes& volumes, const RankExchange& ranks,
    const FragmentLayers& layers, Picture& picture);
  static void CompositeSlabs(const std::function<void()>& composite, bool isRoot,
    const FragmentLayers& layers, Picture& picture);
  static void Composite(vtkRenderer* renderer, CompositedVolume& volume, const PieceView& piece,
    const RankExchange& ranks, Picture& picture);
  static void Blend(CompositedVolume& volume, const std::vector<Bytes>& messages, Picture& picture);
  static void ReportLostSegments(CompositedVolume& volume);

  vtkSmartPointer<vtkIceTCompositePass> IceT;
  vtkSmartPointer<OpaqueScenePass> Opaque;
  vtkSmartPointer<TranslucentLayers> Translucent;
  vtkWeakPointer<vtkRenderer> Renderer; // with the observers
  unsigned long BeginTag = 0;
  unsigned long EndTag = 0;
  WindowOverlay Overlay;
  Volumes All;
  bool IsReported = false;       // that there are tiles
  bool HasLostFragments = false; // as reported
};
}

#endif
