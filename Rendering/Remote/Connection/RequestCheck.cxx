// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Connection/RequestCheck.h"

#include "Connection/AccessToken.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>

namespace relevo
{
namespace
{
std::string ToLowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char character) { return static_cast<char>(std::tolower(character)); });
  return text;
}

// Removes the port of NAME:PORT or [IPv6]:PORT. Returns nothing if the port is no number.
std::string GetName(const std::string& host)
{
  const std::size_t bracket = host.find(']');
  const std::size_t colon = host.find(':', bracket == std::string::npos ? 0 : bracket);
  const bool hasPort = colon != std::string::npos;
  const bool isValid =
    !hasPort || host.find_first_not_of("0123456789", colon + 1) == std::string::npos;
  return isValid ? ToLowerCase(host.substr(0, colon)) : "";
}

bool IsNumericAddress(const std::string& name)
{
  return !name.empty() &&
    (name[0] == '[' || name.find_first_not_of("0123456789.") == std::string::npos);
}

std::string FindHostName()
{
  char name[256] = {};
  return gethostname(name, sizeof(name) - 1) == 0 ? ToLowerCase(name) : "";
}
}

//------------------------------------------------------------------------------
RequestCheck::RequestCheck(const std::string& address, const std::string& token)
  : Address(ToLowerCase(address))
  , Token(token)
  , IsLocal(address.compare(0, 4, "127.") == 0 || address == "[::1]")
{
  const bool isOne = address != "0.0.0.0" && address != "[::]";
  this->HostName = isOne ? this->Address : FindHostName();
}

//------------------------------------------------------------------------------
bool RequestCheck::IsToken(const std::string& token) const
{
  return AreEqualTokens(token, this->Token);
}

//------------------------------------------------------------------------------
bool RequestCheck::IsHost(const std::string& host) const
{
  const std::string name = GetName(host);
  if (name == "localhost" || name == "127.0.0.1" || name == "[::1]" || name == this->Address)
  {
    return true;
  }
  return !this->IsLocal &&
    (IsNumericAddress(name) ||
      (!name.empty() && (name == this->HostName || name == FindHostName())));
}

//------------------------------------------------------------------------------
bool RequestCheck::IsOrigin(const std::string& origin, const std::string& host) const
{
  const std::string server = "://" + ToLowerCase(host);
  const std::string page = ToLowerCase(origin);
  return page.empty() || page == "http" + server || page == "https" + server;
}
}
