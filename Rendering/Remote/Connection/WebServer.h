// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WebServer
 * @brief   the page, and the connections of clients, over HTTP and WebSockets
 *
 * The threads of civetweb handle requests. They put messages into the inbox.
 */
#ifndef WebServer_h
#define WebServer_h

#include "Connection/RequestCheck.h"
#include "Pictures/Picture.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

struct mg_connection;
struct mg_context;

namespace relevo
{
class ClientConnection;
class Inbox;

class WebServer
{
public:
  WebServer(Inbox& inbox, const RequestCheck& check);
  /// Ends all connections, and waits for the threads.
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  /// Listens at the address and port; 0 is any free port. Returns what is wrong, or nothing.
  std::string Start(const std::string& address, int port);
  int GetPort() const { return this->Port; }

  int GetNumberOfClients() const;
  /// Whether a client wants this frame (see ClientConnection::Wants()).
  bool IsWanted(std::uint64_t frame, bool isLossless) const;
  /// Whether a client has not got this frame without loss.
  bool IsLacking(std::uint64_t frame) const;
  /// Sends a picture to all clients that want it. Returns their number.
  int Send(const std::shared_ptr<const EncodedPicture>& picture);

private:
  struct Handlers; // functions that civetweb calls

  /// Answers a request. Returns false for the one that opens a WebSocket.
  bool Answer(mg_connection* connection);
  void SendPage(mg_connection* connection);
  /// Returns whether there is space for another client. Otherwise warns.
  bool HasSpace();
  void Add(mg_connection* connection);
  bool Receive(ClientConnection& client, int bits, const char* data, std::size_t size);
  void Remove(const ClientConnection* client);
  void ReportMalformed(ClientConnection& client, std::size_t size);

  Inbox& Messages;
  const RequestCheck Check;
  mg_context* Context = nullptr;
  std::string Address;
  int Port = 0;
  mutable std::mutex Mutex;
  std::string Problem; // the last message of civetweb
  std::vector<std::shared_ptr<ClientConnection>> Clients;
  int LastNumber = 0;
};
}

#endif
