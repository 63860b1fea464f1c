// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementBlocks
 * @brief   the leaves of a composite input, each drawn by a mapper of its own
 */
#ifndef RefinementBlocks_h
#define RefinementBlocks_h

#include "vtkSmartPointer.h" // for members
#include "vtkTimeStamp.h"    // for SyncTime

#include <functional> // for ForEach
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
   * Draw all leaves. In a selection each reports its flat index as composite index.
   */
  void Render(vtkRenderer* ren, vtkActor* act);

  /**
   * Turn drawn ids into cell ids, leaf by leaf.
   */
  void ProcessSelectorPixelBuffers(
    vtkHardwareSelector* selector, const std::vector<unsigned int>& pixels, vtkProp* prop);

  /// The mapper of the leaf with a flat index; nullptr where there is none.
  vtkBlockAttributesPolyDataMapper* Find(unsigned int flatIndex) const;

  void ForEach(const std::function<void(vtkBlockAttributesPolyDataMapper*)>& work) const;
  void Clear() { this->Mappers.clear(); }
  bool IsEmpty() const { return this->Mappers.empty(); }

private:
  /// Have the parent say what a block says, unless another one has said the same.
  void Forward(vtkBlockAttributesPolyDataMapper* block, unsigned long event);
  void UpdateLooks(vtkCompositeDataDisplayAttributes* attributes, vtkCompositeDataSet* input);

  std::map<unsigned int, vtkSmartPointer<vtkBlockAttributesPolyDataMapper>>
    Mappers; // by flat index
  vtkTimeStamp SyncTime;
  vtkBlockAttributesPolyDataMapper* Parent = nullptr;
  std::set<std::string> Said; // what blocks have said since the last update
};
}

#endif
