// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Connection/WebServer.h"

#include "Connection/AccessToken.h"
#include "Connection/ClientConnection.h"
#include "Messages/ClientMessage.h"
#include "Messages/Inbox.h"
#include "relevoRemotePage.h"

#include <arpa/inet.h>
#include <civetweb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <future>
#include <optional>

namespace relevo
{
namespace
{
const std::size_t LargestNumberOfClients = 16;
const char* const SocketPath = "/window";

std::string GetHeader(const mg_connection* connection, const char* name)
{
  const char* value = mg_get_header(connection, name);
  return value ? value : "";
}

std::string GetToken(const mg_connection* connection)
{
  const char* query = mg_get_request_info(connection)->query_string;
  char token[256] = {};
  const int size =
    query ? mg_get_var(query, std::strlen(query), "token", token, sizeof(token)) : -1;
  return size > 0 ? token : "";
}

void SendText(mg_connection* connection, const std::string& status, const std::string& text)
{
  mg_printf(connection,
    "HTTP/1.1 %s\r\nContent-Type: text/plain; charset=utf-8\r\nContent-Length: %zu\r\n"
    "Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\nConnection: close\r\n\r\n%s",
    status.c_str(), text.size(), text.c_str());
}

std::string Replace(std::string text, const std::string& old, const std::string& with)
{
  for (std::size_t at = text.find(old); at != std::string::npos;
       at = text.find(old, at + with.size()))
  {
    text.replace(at, old.size(), with);
  }
  return text;
}

// Civetweb reports a port in use only as text, so this tries to listen first.
std::string FindProblem(const std::string& address, int port)
{
  sockaddr_in place = {};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  if (inet_pton(AF_INET, address.c_str(), &place.sin_addr) != 1)
  {
    return ""; // civetweb may support other addresses
  }
  const int handle = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (handle < 0)
  {
    return std::strerror(errno);
  }
  const int on = 1;
  setsockopt(handle, SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on));
  std::string problem;
  if (bind(handle, reinterpret_cast<const sockaddr*>(&place), sizeof(place)) != 0 ||
    listen(handle, 1) != 0)
  {
    problem = errno == EADDRINUSE ? "another program uses it" : std::strerror(errno);
  }
  close(handle);
  return problem;
}

// Connects and disconnects.
void Knock(const sockaddr_in& place)
{
  const int handle = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (handle >= 0)
  {
    // Nobody has to answer.
    const int result = connect(handle, reinterpret_cast<const sockaddr*>(&place), sizeof(place));
    static_cast<void>(result);
    close(handle);
  }
}

// Civetweb notices after up to 2 seconds that it has to stop, or when somebody connects.
void StopServer(mg_context* context, const std::string& address, int port)
{
  sockaddr_in place = {};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  const std::string reachable = address == "0.0.0.0" ? "127.0.0.1" : address;
  const bool canKnock = inet_pton(AF_INET, reachable.c_str(), &place.sin_addr) == 1;
  std::future<void> end = std::async(std::launch::async, [context] { mg_stop(context); });
  while (end.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready)
  {
    if (canKnock)
    {
      Knock(place);
    }
  }
}
}

struct WebServer::Handlers
{
  static int OnRequest(mg_connection* connection)
  {
    auto* server = static_cast<WebServer*>(mg_get_user_data(mg_get_context(connection)));
    return server->Answer(connection) ? 1 : 0;
  }

  static int OnMessage(const mg_connection* connection, const char* message)
  {
    auto* server = static_cast<WebServer*>(mg_get_user_data(mg_get_context(connection)));
    const std::lock_guard<std::mutex> lock(server->Mutex);
    server->Problem = message;
    return 1; // civetweb prints nothing
  }

  static int OnConnect(const mg_connection*, void* data)
  {
    return static_cast<WebServer*>(data)->HasSpace() ? 0 : 1;
  }

  static void OnReady(mg_connection* connection, void* data)
  {
    static_cast<WebServer*>(data)->Add(connection);
  }

  static int OnData(mg_connection* connection, int bits, char* text, size_t size, void* data)
  {
    auto* client = static_cast<ClientConnection*>(mg_get_user_connection_data(connection));
    return client && static_cast<WebServer*>(data)->Receive(*client, bits, text, size) ? 1 : 0;
  }

  static void OnClose(const mg_connection* connection, void* data)
  {
    static_cast<WebServer*>(data)->Remove(
      static_cast<const ClientConnection*>(mg_get_user_connection_data(connection)));
  }
};

//------------------------------------------------------------------------------
WebServer::WebServer(Inbox& inbox, const RequestCheck& check)
  : Messages(inbox)
  , Check(check)
{
}

//------------------------------------------------------------------------------
WebServer::~WebServer()
{
  this->Messages.Close(); // threads that wait for space go on
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    for (const auto& client : this->Clients)
    {
      client->Leave();
    }
  }
  if (this->Context)
  {
    StopServer(this->Context, this->Address, this->Port);
  }
}

//------------------------------------------------------------------------------
std::string WebServer::Start(const std::string& address, int port)
{
  const std::string place = address + ":" + std::to_string(port);
  const std::string problem = FindProblem(address, port);
  if (!problem.empty())
  {
    return "The port " + std::to_string(port) + " of " + address + " cannot be opened: " + problem +
      ".";
  }
  const std::string threads = std::to_string(LargestNumberOfClients + 4);
  const char* options[] = { "listening_ports", place.c_str(), "num_threads", threads.c_str(),
    "tcp_nodelay", "1", "request_timeout_ms", "10000", "websocket_timeout_ms", "10000",
    "enable_websocket_ping_pong", "yes", "enable_directory_listing", "no",
    "access_control_allow_origin", "", "access_control_allow_methods", "",
    "access_control_allow_headers", "", "enable_auth_domain_check", "no", nullptr };
  mg_callbacks callbacks = {};
  callbacks.begin_request = Handlers::OnRequest;
  callbacks.log_message = Handlers::OnMessage;
  this->Address = address;
  mg_init_library(0);
  this->Messages.Open();
  this->Context = mg_start(&callbacks, this, options);
  if (!this->Context)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return "The port " + std::to_string(port) + " of " + address +
      " cannot be opened: " + (this->Problem.empty() ? "civetweb does not start" : this->Problem) +
      ".";
  }
  mg_set_websocket_handler(this->Context, SocketPath, Handlers::OnConnect, Handlers::OnReady,
    Handlers::OnData, Handlers::OnClose, this);
  mg_server_port ports[1] = {};
  if (mg_get_server_ports(this->Context, 1, ports) == 1)
  {
    this->Port = ports[0].port;
  }
  return "";
}

//------------------------------------------------------------------------------
int WebServer::GetNumberOfClients() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return static_cast<int>(this->Clients.size());
}

//------------------------------------------------------------------------------
bool WebServer::IsWanted(std::uint64_t frame, bool isLossless) const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return std::any_of(this->Clients.begin(), this->Clients.end(),
    [&](const auto& client) { return client->Wants(frame, isLossless); });
}

//------------------------------------------------------------------------------
bool WebServer::IsLacking(std::uint64_t frame) const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return std::any_of(this->Clients.begin(), this->Clients.end(),
    [&](const auto& client) { return client->Lacks(frame); });
}

//------------------------------------------------------------------------------
int WebServer::Send(const std::shared_ptr<const EncodedPicture>& picture)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return static_cast<int>(std::count_if(this->Clients.begin(), this->Clients.end(),
    [&](const auto& client) { return client->Send(picture); }));
}

//------------------------------------------------------------------------------
bool WebServer::Answer(mg_connection* connection)
{
  const mg_request_info* request = mg_get_request_info(connection);
  const std::string path = request->local_uri ? request->local_uri : "";
  const std::string host = GetHeader(connection, "Host");
  if (!this->Check.IsHost(host) || !this->Check.IsOrigin(GetHeader(connection, "Origin"), host))
  {
    SendText(connection, "403 Forbidden", "This address does not belong to the server.\n");
    return true;
  }
  if (!this->Check.IsToken(GetToken(connection)))
  {
    SendText(connection, "401 Unauthorized",
      "The token is missing or wrong. Open the URL that the program has printed.\n");
    return true;
  }
  if (std::string(request->request_method) != "GET")
  {
    SendText(connection, "405 Method Not Allowed", "Only GET is supported.\n");
  }
  else if (path == "/")
  {
    this->SendPage(connection);
  }
  else if (path != SocketPath)
  {
    SendText(connection, "404 Not Found", "There is no such page.\n");
  }
  else if (GetHeader(connection, "Sec-WebSocket-Key").empty())
  {
    SendText(connection, "400 Bad Request", "This address is for WebSockets.\n");
  }
  else
  {
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void WebServer::SendPage(mg_connection* connection)
{
  // Only the script and the style with this number run.
  const std::string nonce = MakeToken();
  const std::string page = Replace(relevoRemotePage, "NONCE", nonce);
  const std::string host = GetHeader(connection, "Host");
  mg_printf(connection,
    "HTTP/1.1 200 OK\r\nContent-Type: text/html; charset=utf-8\r\nContent-Length: %zu\r\n"
    "Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\nReferrer-Policy: no-referrer\r\n"
    "Content-Security-Policy: default-src 'none'; script-src 'nonce-%s'; style-src 'nonce-%s'; "
    "connect-src 'self' ws://%s wss://%s; img-src data:; base-uri 'none'; form-action 'none'\r\n"
    "Connection: close\r\n\r\n",
    page.size(), nonce.c_str(), nonce.c_str(), host.c_str(), host.c_str());
  mg_write(connection, page.data(), page.size());
}

//------------------------------------------------------------------------------
bool WebServer::HasSpace()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Clients.size() >= LargestNumberOfClients)
  {
    this->Messages.Warn("A client was refused, because " + std::to_string(LargestNumberOfClients) +
      " are connected.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void WebServer::Add(mg_connection* connection)
{
  const auto send = [connection](const unsigned char* data, std::size_t size)
  {
    const int opcode = data ? MG_WEBSOCKET_OPCODE_BINARY : MG_WEBSOCKET_OPCODE_CONNECTION_CLOSE;
    const char goingAway[] = { '\x03', '\xe9' }; // 1001
    return data
      ? mg_websocket_write(connection, opcode, reinterpret_cast<const char*>(data), size) > 0
      : mg_websocket_write(connection, opcode, goingAway, sizeof(goingAway)) > 0;
  };
  const std::lock_guard<std::mutex> lock(this->Mutex);
  const auto client = std::make_shared<ClientConnection>(++this->LastNumber, send);
  this->Clients.push_back(client);
  mg_set_user_connection_data(connection, client.get());
  this->Messages.Wake();
}

//------------------------------------------------------------------------------
bool WebServer::Receive(ClientConnection& client, int bits, const char* data, std::size_t size)
{
  const int opcode = bits & 0xf;
  if (opcode == MG_WEBSOCKET_OPCODE_CONNECTION_CLOSE)
  {
    return true; // civetweb ends the connection
  }
  if (client.IsBroken())
  {
    return false;
  }
  if (size > ClientMessage::LargestSize)
  {
    this->Messages.Warn("A client sent a message of " + std::to_string(size) +
      " bytes and was disconnected. Messages have at most " +
      std::to_string(ClientMessage::LargestSize) + " bytes.");
    return false;
  }
  const bool isWhole = (bits & 0x80) != 0;
  const std::optional<ClientMessage> message =
    isWhole && opcode == MG_WEBSOCKET_OPCODE_TEXT ? ParseMessage(data, size) : std::nullopt;
  if (!message)
  {
    this->ReportMalformed(client, size);
  }
  else if (message->What == ClientMessage::Type::Shown)
  {
    client.Confirm();
    this->Messages.Wake();
  }
  else
  {
    this->Messages.Put(client.GetNumber(), *message);
  }
  return true;
}

//------------------------------------------------------------------------------
void WebServer::Remove(const ClientConnection* client)
{
  std::shared_ptr<ClientConnection> removed; // its thread ends without the lock
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    const auto found = std::find_if(this->Clients.begin(), this->Clients.end(),
      [&](const auto& other) { return other.get() == client; });
    if (found == this->Clients.end())
    {
      return;
    }
    removed = *found;
    this->Clients.erase(found);
  }
  const int count = removed->GetNumberOfMalformed();
  if (count > 1)
  {
    this->Messages.Warn(
      "A client has left that sent " + std::to_string(count) + " malformed messages.");
  }
  ClientMessage gone;
  gone.What = ClientMessage::Type::Gone;
  this->Messages.Put(removed->GetNumber(), gone);
}

//------------------------------------------------------------------------------
void WebServer::ReportMalformed(ClientConnection& client, std::size_t size)
{
  if (client.CountMalformed() == 1)
  {
    this->Messages.Warn("A client sent a malformed message of " + std::to_string(size) +
      " bytes. It and later ones are ignored.");
  }
}
}
