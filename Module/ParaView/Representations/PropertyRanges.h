// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PropertyRanges
 * @brief   refuses values of properties that are out of range
 *
 * ParaView links properties of several representations, so each of their objects would report a
 * value that it refuses, on the client and on the servers. The proxy that the user changes checks
 * it before other proxies and objects get it.
 *
 * Private to the module.
 */
#ifndef PropertyRanges_h
#define PropertyRanges_h

#include <map>
#include <string>
#include <vector>

class vtkSMProperty;
class vtkSMProxy;

namespace relevo
{
class PropertyRanges
{
public:
  /// Check the value of this property against the range or the choices of its definition. If it is
  /// invalid, set the last valid one again and return an error. Otherwise, return an empty text. So
  /// it does while the proxy is initialized, because ParaView sets zeros first, and for properties
  /// of ParaView's representations.
  std::string Restore(vtkSMProxy* proxy, const char* name, bool isInitialized);

private:
  std::map<std::string, std::vector<double>> Valid; // by the name of the property
};
}

#endif
