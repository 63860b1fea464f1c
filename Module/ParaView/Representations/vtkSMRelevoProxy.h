// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMRelevoProxy
 * @brief   the proxy of the objects that the plugin's representations use
 *
 * If a value of a property is out of range, it reports one error with the names of the property and
 * of the representation. The property gets its last valid value again.
 *
 * In the XML the element is RelevoProxy.
 *
 * @sa vtkSMRelevoRepresentationProxy
 */
#ifndef vtkSMRelevoProxy_h
#define vtkSMRelevoProxy_h

#include "RelevoParaViewRepresentationsModule.h" // for export macro
#include "vtkSMProxy.h"

#include <memory> // for Ranges

namespace relevo
{
class PropertyRanges;
}

class RELEVOPARAVIEWREPRESENTATIONS_EXPORT vtkSMRelevoProxy : public vtkSMProxy
{
public:
  static vtkSMRelevoProxy* New();
  vtkTypeMacro(vtkSMRelevoProxy, vtkSMProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMRelevoProxy();
  ~vtkSMRelevoProxy() override;

  void SetPropertyModifiedFlag(const char* name, int flag) override;

private:
  vtkSMRelevoProxy(const vtkSMRelevoProxy&) = delete;
  void operator=(const vtkSMRelevoProxy&) = delete;

  std::unique_ptr<relevo::PropertyRanges> Ranges;
};

#endif
