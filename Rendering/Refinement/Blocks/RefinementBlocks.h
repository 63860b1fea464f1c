// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementBlocks
 * @brief   the leaves of a composite input, with one mapper for each
 */
#ifndef RefinementBlocks_h
#define RefinementBlocks_h

#include "vtkSmartPointer.h" // for members
#include "vtkType.h"         // for vtkMTimeType

#include <functional> // for OnRemove, ForEach()
#include <map>        // for members
#include <set>        // for members
#include <string>     // for members
#include <vector>     // for pixel offsets

class vtkActor;
class vtkBlockAttributesPolyDataMapper;
class vtkCompositeDataSet;
class vtkHardwareSelector;
class vtkProp;
class vtkRenderer;

namespace relevo
{
struct BlockAttributes;

class RefinementBlocks
{
public:
  RefinementBlocks();
  ~RefinementBlocks();

  struct Source
  {
    /// The mapper of the composite input. The blocks copy its settings, and it reports their
    /// errors.
    vtkBlockAttributesPolyDataMapper* Parent;
    vtkCompositeDataSet* Input;
    /// Returns when a setting that VTK's buffers depend on last changed.
    std::function<vtkMTimeType()> GetBuildTime;
    std::function<void(vtkBlockAttributesPolyDataMapper*, const BlockAttributes&)> SetAttributes;
  };
  /**
   * Create one mapper per polydata leaf, with the parent's settings.
   */
  void Update(const Source& source);

  /**
   * Draw the leaves of the pass (opaque or translucent ones), or all leaves. In a selection, each
   * leaf has its flat index as composite index.
   */
  void Render(vtkRenderer* ren, vtkActor* act, bool drawsAll);

  /// Return whether Render() is running; the blocks must not change then.
  bool IsRendering() const { return this->Rendering; }

  /**
   * Convert drawn ids to cell ids, leaf by leaf.
   */
  void ProcessSelectorPixelBuffers(
    vtkHardwareSelector* selector, const std::vector<unsigned int>& pixels, vtkProp* prop);

  /// Return the mapper of the leaf with a flat index; nullptr if there is none.
  vtkBlockAttributesPolyDataMapper* Find(unsigned int flatIndex) const;

  /// Return the flat indices of the drawn leaves, or call a function for their mappers.
  std::vector<unsigned int> GetFlatIndices() const;
  void ForEach(const std::function<void(vtkBlockAttributesPolyDataMapper*)>& work) const;
  void Clear();
  bool IsEmpty() const { return this->Mappers.empty(); }

  /// Whether the last render has drawn blocks.
  bool AreDrawn = false;
  /// When the settings of the blocks changed.
  vtkMTimeType SettingsTime = 0;
  /// The counts of removed blocks.
  vtkIdType NumberOfBufferBuilds = 0;
  vtkIdType NumberOfShaderBuilds = 0;

  /// The function that is called with the mapper of a removed leaf, before the mapper is deleted.
  std::function<void(vtkBlockAttributesPolyDataMapper*)> OnRemove;

private:
  /// Report a block's message as the parent's, unless another block has reported the same.
  void Forward(vtkBlockAttributesPolyDataMapper* block, unsigned long event);
  void UpdateAttributes(const Source& source);

  std::map<unsigned int, vtkSmartPointer<vtkBlockAttributesPolyDataMapper>>
    Mappers;                   // by flat index
  vtkMTimeType ParentTime = 0; // when the parent's settings were copied
  bool Rendering = false;
  vtkBlockAttributesPolyDataMapper* Parent = nullptr;
  std::set<std::string> Messages; // of blocks since the last update
};
}

#endif
