// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementBlocks
 * @brief   the leaves of a composite input, each drawn by a mapper of its own
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
    /// The mapper whose blocks these are: they copy its settings, and their errors are its own.
    vtkBlockAttributesPolyDataMapper* Parent;
    vtkCompositeDataSet* Input;
    /// When a setting that VTK's buffers depend on last changed.
    std::function<vtkMTimeType()> GetBuildTime;
    std::function<void(vtkBlockAttributesPolyDataMapper*, const BlockAttributes&)> SetAttributes;
  };
  /**
   * Have one mapper per polydata leaf, with the parent's settings.
   */
  void Update(const Source& source);

  /**
   * Draw the leaves of the pass, opaque or translucent ones, or all of them. In a selection each
   * reports its flat index as composite index.
   */
  void Render(vtkRenderer* ren, vtkActor* act, bool drawsAll);

  /// Whether Render() is at work: the blocks are to stay as they are.
  bool IsRendering() const { return this->Rendering; }

  /**
   * Turn drawn ids into cell ids, leaf by leaf.
   */
  void ProcessSelectorPixelBuffers(
    vtkHardwareSelector* selector, const std::vector<unsigned int>& pixels, vtkProp* prop);

  /// The mapper of the leaf with a flat index; nullptr where there is none.
  vtkBlockAttributesPolyDataMapper* Find(unsigned int flatIndex) const;

  /// Of the leaves that are drawn.
  std::vector<unsigned int> GetFlatIndices() const;
  void ForEach(const std::function<void(vtkBlockAttributesPolyDataMapper*)>& work) const;
  void Clear();
  bool IsEmpty() const { return this->Mappers.empty(); }

  /// Whether the last render has drawn blocks.
  bool AreDrawn = false;
  /// When the settings changed that the blocks have been given.
  vtkMTimeType SettingsTime = 0;
  /// Of blocks that are gone.
  vtkIdType NumberOfBufferBuilds = 0;
  vtkIdType NumberOfShaderBuilds = 0;

  /// Called with the mapper of a leaf that is gone, before it is deleted.
  std::function<void(vtkBlockAttributesPolyDataMapper*)> OnRemove;

private:
  /// Report what a block says as the parent's, unless another block has said the same.
  void Forward(vtkBlockAttributesPolyDataMapper* block, unsigned long event);
  void UpdateAttributes(const Source& source);

  std::map<unsigned int, vtkSmartPointer<vtkBlockAttributesPolyDataMapper>>
    Mappers;                   // by flat index
  vtkMTimeType ParentTime = 0; // that the mappers were copied at
  bool Rendering = false;
  vtkBlockAttributesPolyDataMapper* Parent = nullptr;
  std::set<std::string> Messages; // of blocks since the last update
};
}

#endif
