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
class vtkCompositeDataDisplayAttributes;
class vtkCompositeDataSet;
class vtkHardwareSelector;
class vtkProp;
class vtkRenderer;

namespace relevo
{
class RefinementBlocks
{
public:
  RefinementBlocks();
  ~RefinementBlocks();

  /**
   * Have one mapper per polydata leaf, with the parent's settings.
   */
  void Update(vtkBlockAttributesPolyDataMapper* parent, vtkCompositeDataSet* input);

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

  /// Called with the mapper of a leaf that is gone, before it is deleted.
  std::function<void(vtkBlockAttributesPolyDataMapper*)> OnRemove;

private:
  /// Report what a block says as the parent's, unless another block has said the same.
  void Forward(vtkBlockAttributesPolyDataMapper* block, unsigned long event);
  void UpdateAttributes(vtkCompositeDataDisplayAttributes* attributes, vtkCompositeDataSet* input);

  std::map<unsigned int, vtkSmartPointer<vtkBlockAttributesPolyDataMapper>>
    Mappers;                   // by flat index
  vtkMTimeType ParentTime = 0; // GetBuildMTime() that the mappers were copied at
  bool Rendering = false;
  vtkBlockAttributesPolyDataMapper* Parent = nullptr;
  std::set<std::string> Messages; // of blocks since the last update
};
}

#endif
