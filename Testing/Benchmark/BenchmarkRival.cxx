// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkRival.h"

#include <spawn.h>
#include <sstream>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

BenchmarkRival::BenchmarkRival(const std::vector<std::string>& command)
{
  int sockets[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0)
  {
    return;
  }
  std::vector<char*> arguments;
  for (const std::string& argument : command)
  {
    arguments.push_back(const_cast<char*>(argument.c_str()));
  }
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, sockets[1], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, sockets[1], STDOUT_FILENO);
  if (posix_spawn(&this->Process, arguments[0], &actions, nullptr, arguments.data(), environ) != 0)
  {
    this->Process = -1;
  }
  posix_spawn_file_actions_destroy(&actions);
  close(sockets[1]);
  this->Socket = sockets[0];
}

BenchmarkRival::~BenchmarkRival()
{
  if (this->Socket >= 0)
  {
    close(this->Socket);
  }
  if (this->Process >= 0)
  {
    waitpid(this->Process, nullptr, 0);
  }
}

std::string BenchmarkRival::Ask(const std::string& line)
{
  const std::string question = line + '\n';
  // Avoids SIGPIPE if the program has ended.
  if (this->Process < 0 ||
    send(this->Socket, question.data(), question.size(), MSG_NOSIGNAL) !=
      static_cast<ssize_t>(question.size()))
  {
    return std::string();
  }
  std::string answer;
  for (char c; read(this->Socket, &c, 1) == 1 && c != '\n';)
  {
    answer += c;
  }
  return answer;
}

std::vector<double> BenchmarkRival::AskNumbers(const std::string& line)
{
  std::istringstream answer(this->Ask(line));
  std::vector<double> numbers;
  for (double number; answer >> number;)
  {
    numbers.push_back(number);
  }
  return numbers;
}
