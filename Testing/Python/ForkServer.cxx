// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Loading libraries takes most of the time of a short run of relevo-view. When this library is
// preloaded (LD_PRELOAD), it waits for requests at the point where main() would start, and forks a
// process that runs main() for each.
//
// The environment variable RELEVO_FORK_SERVER contains the descriptor of the socket. After one
// byte, "ready", each request is a message with the descriptors for standard output and error. Its
// text has the folder, the number of arguments, the arguments and the environment, each terminated
// by NUL. The answers are the process id and, when the process has ended, its status, each an int.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <string>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace
{
using Main = int (*)(int, char**, char**);
Main ProgramMain = nullptr;

struct Request
{
  std::vector<char> Text = std::vector<char>(1 << 17);
  int Outputs[2] = { -1, -1 };

  bool Receive(int socket)
  {
    iovec part = { this->Text.data(), this->Text.size() - 1 };
    alignas(cmsghdr) char control[CMSG_SPACE(sizeof(this->Outputs))];
    msghdr message = {};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = control;
    message.msg_controllen = sizeof(control);
    const ssize_t size = recvmsg(socket, &message, MSG_CMSG_CLOEXEC);
    const cmsghdr* header = size > 0 ? CMSG_FIRSTHDR(&message) : nullptr;
    if (!header)
    {
      return false;
    }
    std::memcpy(this->Outputs, CMSG_DATA(header), sizeof(this->Outputs));
    this->Text.resize(static_cast<std::size_t>(size));
    return true;
  }

  // Takes this many strings, starting at a position.
  std::vector<char*> Take(std::size_t& place, std::size_t number)
  {
    std::vector<char*> strings;
    for (; strings.size() < number && place < this->Text.size();
         place += std::strlen(&this->Text[place]) + 1)
    {
      strings.push_back(&this->Text[place]);
    }
    strings.push_back(nullptr);
    return strings;
  }
};

[[noreturn]] void RunProgram(Request& request)
{
  dup2(request.Outputs[0], STDOUT_FILENO);
  dup2(request.Outputs[1], STDERR_FILENO);
  std::size_t place = 0;
  const std::vector<char*> head = request.Take(place, 2);
  std::vector<char*> arguments = request.Take(place, std::strtoul(head[1], nullptr, 10));
  std::vector<char*> environment = request.Take(place, request.Text.size());
  environ = environment.data();
  const int code = chdir(head[0]) == 0
    ? ProgramMain(static_cast<int>(arguments.size()) - 1, arguments.data(), environ)
    : 126;
  // Not exit(): libraries may wait for threads that do not exist after the fork.
  std::fflush(nullptr);
  _exit(code);
}

int Serve(int argc, char** argv, char** environment)
{
  const char* name = std::getenv("RELEVO_FORK_SERVER");
  if (!name)
  {
    return ProgramMain(argc, argv, environment);
  }
  const int socket = std::atoi(name);
  bool isOpen = send(socket, "", 1, MSG_NOSIGNAL) == 1;
  for (Request request; isOpen && request.Receive(socket); request = Request())
  {
    const pid_t process = fork();
    if (process == 0)
    {
      close(socket);
      RunProgram(request);
    }
    close(request.Outputs[0]);
    close(request.Outputs[1]);
    int status = 0;
    isOpen = process > 0 && send(socket, &process, sizeof(process), MSG_NOSIGNAL) > 0 &&
      waitpid(process, &status, 0) == process &&
      send(socket, &status, sizeof(status), MSG_NOSIGNAL) > 0;
  }
  _exit(0);
}
}

// The C library calls this to start main().
extern "C" int __libc_start_main(
  Main main, int argc, char** argv, void (*begin)(), void (*end)(), void (*finish)(), void* stack)
{
  ProgramMain = main;
  using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
  const auto start = reinterpret_cast<Start>(dlsym(RTLD_NEXT, "__libc_start_main"));
  return start(Serve, argc, argv, begin, end, finish, stack);
}
