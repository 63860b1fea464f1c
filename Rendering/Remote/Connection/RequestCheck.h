// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RequestCheck
 * @brief   whether a request may reach the window
 *
 * Pages of other sites can make a browser send requests to this computer. Such a request has the
 * Origin of the other site, or, if that site's name resolves to this computer (DNS rebinding), the
 * name of the other site as Host.
 */
#ifndef RequestCheck_h
#define RequestCheck_h

#include <string>

namespace relevo
{
class RequestCheck
{
public:
  /// The address that the server listens at.
  RequestCheck(const std::string& address, const std::string& token);

  /// The name that users of other computers reach the server by.
  const std::string& GetHostName() const { return this->HostName; }

  bool IsToken(const std::string& token) const;
  /// Whether the header Host names this server. The port may be that of a tunnel.
  bool IsHost(const std::string& host) const;
  /// Whether the header Origin names the page of this server. Programs without pages send none.
  bool IsOrigin(const std::string& origin, const std::string& host) const;

private:
  std::string Address;
  std::string Token;
  std::string HostName;
  bool IsLocal = true; // whether only this computer reaches the server
};
}

#endif
