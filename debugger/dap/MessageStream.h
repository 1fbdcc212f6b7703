//===- MessageStream.h - Framing of the protocol's messages -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_MESSAGESTREAM_H
#define TP_DEBUGGER_DAP_MESSAGESTREAM_H

#include "llvm/Support/Error.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/JSON.h"

#include <optional>
#include <string>

namespace tp::dap {

/// A message larger than this is a broken header.
inline constexpr size_t MaxMessageBytes = 64 << 20;

/// Takes the messages of the protocol from a file: a header with
/// `Content-Length`, an empty line, and that many bytes of JSON.
class MessageReader {
public:
  explicit MessageReader(llvm::sys::fs::file_t File) : File(File) {}

  /// Waits for the next message; nothing at the end of the file. After an
  /// error in a header the stream has lost its place.
  llvm::Expected<std::optional<llvm::json::Value>> read();

private:
  llvm::sys::fs::file_t File;
  /// What has been read and belongs to no message yet.
  std::string Buffer;

  /// False at the end of the file.
  llvm::Expected<bool> fill();
};

/// The text of \p Message as it stands in the stream, with its header.
std::string frame(const llvm::json::Value &Message);

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_MESSAGESTREAM_H
