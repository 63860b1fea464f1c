// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMRelevoRepresentationProxy
 * @brief   the proxy of the plugin's representations
 *
 * A client gets the definitions of proxies from the server. If the client lacks the plugin, it
 * cannot create an object of this class. ParaView reports that, with the name of the class, and
 * shows the data without the plugin's representations. With a proxy class of ParaView the client
 * would only find out when it creates the representation itself, where ParaView calls abort().
 *
 * Like vtkSMRelevoProxy, it reports values of properties that are out of range.
 *
 * In the XML the element is RelevoRepresentationProxy.
 */
#ifndef vtkSMRelevoRepresentationProxy_h
#define vtkSMRelevoRepresentationProxy_h

#include "RelevoParaViewRepresentationsModule.h" // for export macro
#include "vtkSMRepresentationProxy.h"

#include <memory> // for Ranges

namespace relevo
{
class PropertyRanges;
}

class RELEVOPARAVIEWREPRESENTATIONS_EXPORT vtkSMRelevoRepresentationProxy
  : public vtkSMRepresentationProxy
{
public:
  static vtkSMRelevoRepresentationProxy* New();
  vtkTypeMacro(vtkSMRelevoRepresentationProxy, vtkSMRepresentationProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMRelevoRepresentationProxy();
  ~vtkSMRelevoRepresentationProxy() override;

  void SetPropertyModifiedFlag(const char* name, int flag) override;

private:
  vtkSMRelevoRepresentationProxy(const vtkSMRelevoRepresentationProxy&) = delete;
  void operator=(const vtkSMRelevoRepresentationProxy&) = delete;

  std::unique_ptr<relevo::PropertyRanges> Ranges;
};

#endif
