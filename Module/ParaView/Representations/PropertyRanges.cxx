// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PropertyRanges.h"

#include "vtkSMDomain.h"
#include "vtkSMDomainIterator.h"
#include "vtkSMDoubleRangeDomain.h"
#include "vtkSMEnumerationDomain.h"
#include "vtkSMIntRangeDomain.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMVectorProperty.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstring>
#include <iomanip>
#include <limits>
#include <sstream>

namespace relevo
{
namespace
{
constexpr int Digits = 10;

// Return the domain of exactly this class. Derived classes depend on data, and suggest values.
template <typename Domain>
Domain* FindFixedDomain(vtkSMProperty* property, const char* className)
{
  auto domains = vtkSmartPointer<vtkSMDomainIterator>::Take(property->NewDomainIterator());
  for (domains->Begin(); !domains->IsAtEnd(); domains->Next())
  {
    if (std::strcmp(domains->GetDomain()->GetClassName(), className) == 0)
    {
      return Domain::SafeDownCast(domains->GetDomain());
    }
  }
  return nullptr;
}

// Return "must be in [0, 1]" or "must be at least 0" if a value is out of range. The last range
// applies to the remaining components.
template <typename Domain>
std::string DescribeRangeError(Domain* domain, const std::vector<double>& values)
{
  const int ranges = domain ? static_cast<int>(domain->GetNumberOfEntries()) : 0;
  for (int i = 0; i < static_cast<int>(values.size()) && ranges > 0; ++i)
  {
    const int range = std::min(i, ranges - 1);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const bool hasMinimum = domain->GetMinimumExists(range);
    const bool hasMaximum = domain->GetMaximumExists(range);
    const double minimum = hasMinimum ? double(domain->GetMinimum(range)) : -infinity;
    const double maximum = hasMaximum ? double(domain->GetMaximum(range)) : infinity;
    if (values[i] >= minimum && values[i] <= maximum) // not for NaN
    {
      continue;
    }
    std::ostringstream text;
    text << std::setprecision(Digits);
    if (hasMinimum && hasMaximum)
    {
      text << "must be in [" << minimum << ", " << maximum << "]";
    }
    else if (hasMinimum || hasMaximum)
    {
      text << "must be at " << (hasMinimum ? "least " : "most ")
           << (hasMinimum ? minimum : maximum);
    }
    else
    {
      text << "must be a number";
    }
    return text.str();
  }
  return "";
}

std::string DescribeChoiceError(vtkSMEnumerationDomain* domain, const std::vector<double>& values)
{
  if (!domain || domain->GetNumberOfEntries() == 0 || values.size() != 1)
  {
    return "";
  }
  std::ostringstream text;
  for (unsigned int i = 0; i < domain->GetNumberOfEntries(); ++i)
  {
    if (domain->GetEntryValue(i) == values[0])
    {
      return "";
    }
    text << (i == 0 ? "must be one of " : ", ") << domain->GetEntryText(i) << " ("
         << domain->GetEntryValue(i) << ")";
  }
  return text.str();
}

std::string DescribeError(vtkSMProperty* property, const std::vector<double>& values)
{
  const std::string choice = DescribeChoiceError(
    FindFixedDomain<vtkSMEnumerationDomain>(property, "vtkSMEnumerationDomain"), values);
  if (!choice.empty())
  {
    return choice;
  }
  const std::string whole = DescribeRangeError(
    FindFixedDomain<vtkSMIntRangeDomain>(property, "vtkSMIntRangeDomain"), values);
  return !whole.empty()
    ? whole
    : DescribeRangeError(
        FindFixedDomain<vtkSMDoubleRangeDomain>(property, "vtkSMDoubleRangeDomain"), values);
}

// Whether ParaView's own representations have the property, with their own range. Surface LIC is
// not one of them, because it limits its settings without a message.
bool IsOfParaView(vtkSMProxy* proxy, const char* name)
{
  for (const char* each : { "SurfaceRepresentation", "UniformGridVolumeRepresentation",
         "UnstructuredGridVolumeRepresentation" })
  {
    vtkSMProxy* representation =
      proxy->GetSessionProxyManager()->GetPrototypeProxy("representations", each);
    if (proxy->IsA("vtkSMRepresentationProxy") && representation &&
      representation->GetProperty(name))
    {
      return true;
    }
  }
  return false;
}

// The label of the representation in which the panel shows the property. Otherwise, that of the
// filter, or of the proxy that the user has selected in a list.
std::string GetOwnerLabel(vtkSMProxy* proxy)
{
  vtkSMProxy* owner = proxy;
  for (vtkSMProxy* parent = owner->GetParentProxy(); parent; parent = owner->GetParentProxy())
  {
    const bool isShown = parent->GetParentProxy() ||
      !(parent->IsA("vtkSMRepresentationProxy") || parent->IsA("vtkSMViewProxy"));
    if (!isShown)
    {
      break;
    }
    owner = parent;
  }
  return owner->GetXMLLabel();
}

std::string Join(const std::vector<double>& values)
{
  std::ostringstream text;
  text << std::setprecision(Digits);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    text << (i == 0 ? "" : ", ") << values[i];
  }
  return values.size() == 1 ? text.str() : "(" + text.str() + ")";
}
}

std::string PropertyRanges::Restore(vtkSMProxy* proxy, const char* name, bool isInitialized)
{
  vtkSMProperty* property = proxy->GetProperty(name, 1);
  if (!vtkSMVectorProperty::SafeDownCast(property) || property->GetInformationOnly() ||
    property->IsA("vtkSMStringVectorProperty"))
  {
    return "";
  }
  vtkSMPropertyHelper helper(property);
  const std::vector<double> values = helper.GetDoubleArray();
  const std::string error = DescribeError(property, values);
  if (error.empty())
  {
    this->Valid[name] = values;
    return "";
  }
  if (!isInitialized || IsOfParaView(proxy, name))
  {
    return "";
  }
  const auto valid = this->Valid.find(name);
  if (valid != this->Valid.end() && valid->second.size() == values.size())
  {
    const std::vector<double> restored = valid->second; // this method is called again
    helper.Set(restored.data(), static_cast<unsigned int>(restored.size()));
  }
  else
  {
    property->ResetToXMLDefaults();
  }
  const char* shown = proxy->GetTrueParentProxy()->GetPropertyName(property);
  return (shown ? std::string(shown) : name) + " of " + GetOwnerLabel(proxy) + " " + error +
    ", got " + Join(values) + ". The value is not used.";
}
}
