// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMRelevoExtentDomain
 * @brief   a vtkSMBoundsDomain that sets no default without bounds
 *
 * In the mode scaled_extent, vtkSMBoundsDomain suggests a negative length if its input has no
 * points, or has not been updated yet. This class then leaves the property as it is.
 *
 * In the XML the element is RelevoExtentDomain.
 */
#ifndef vtkSMRelevoExtentDomain_h
#define vtkSMRelevoExtentDomain_h

#include "RelevoParaViewRepresentationsModule.h" // for export macro
#include "vtkSMBoundsDomain.h"

class RELEVOPARAVIEWREPRESENTATIONS_EXPORT vtkSMRelevoExtentDomain : public vtkSMBoundsDomain
{
public:
  static vtkSMRelevoExtentDomain* New();
  vtkTypeMacro(vtkSMRelevoExtentDomain, vtkSMBoundsDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues) override;

protected:
  vtkSMRelevoExtentDomain() = default;
  ~vtkSMRelevoExtentDomain() override = default;

private:
  vtkSMRelevoExtentDomain(const vtkSMRelevoExtentDomain&) = delete;
  void operator=(const vtkSMRelevoExtentDomain&) = delete;
};

#endif
