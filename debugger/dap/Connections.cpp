//===- Connections.cpp - How clients reach the adapter --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/Connections.h"

#include "llvm/ADT/ScopeExit.h"

#include <arpa/inet.h>
#include <cerrno>
#include <csignal>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

using namespace llvm;

namespace tp::dap {

static Error systemError(const Twine &What) {
  std::error_code Code(errno, std::generic_category());
  return createStringError(Code, What + ": " + Code.message());
}

Error talkOnStandardStreams(const Conversation &Talk) {
  int Output = dup(STDOUT_FILENO);
  if (Output < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
    return systemError("cannot keep standard output for the protocol");
  raw_fd_ostream OS(Output, /*shouldClose=*/true);
  Talk(STDIN_FILENO, OS);
  // A client that has gone reads nothing more; that is no failure.
  OS.clear_error();
  return Error::success();
}

/// A socket that listens on \p Port, or on a free port, which it then is.
static Expected<int> listenOn(uint16_t &Port) {
  int Socket = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (Socket < 0)
    return systemError("cannot open a socket");
  int Yes = 1;
  setsockopt(Socket, SOL_SOCKET, SO_REUSEADDR, &Yes, sizeof(Yes));
  sockaddr_in Address = {};
  Address.sin_family = AF_INET;
  Address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  Address.sin_port = htons(Port);
  auto *Generic = reinterpret_cast<sockaddr *>(&Address);
  socklen_t Length = sizeof(Address);
  if (bind(Socket, Generic, Length) < 0 || listen(Socket, 1) < 0 ||
      getsockname(Socket, Generic, &Length) < 0) {
    Error Problem = systemError("cannot listen on port " + Twine(Port));
    close(Socket);
    return std::move(Problem);
  }
  Port = ntohs(Address.sin_port);
  return Socket;
}

Error talkOnPort(uint16_t Port, const Conversation &Talk, raw_ostream &Log) {
  // A client that goes away is an error of its stream, not of the process.
  std::signal(SIGPIPE, SIG_IGN);
  Expected<int> Socket = listenOn(Port);
  if (!Socket)
    return Socket.takeError();
  scope_exit Close([&] { close(*Socket); });
  // In one piece: whoever waits for it may read before the next one.
  Log << ("tpdbg: listening on 127.0.0.1:" + Twine(Port) + "\n").str();
  Log.flush();
  while (true) {
    int Client = accept(*Socket, nullptr, nullptr);
    if (Client < 0)
      return systemError("cannot accept a client");
    raw_fd_ostream OS(Client, /*shouldClose=*/true);
    Talk(Client, OS);
    OS.clear_error();
  }
}

} // namespace tp::dap
