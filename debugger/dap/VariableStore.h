//===- VariableStore.h - Numbers of lists and frames ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_VARIABLESTORE_H
#define TP_DEBUGGER_DAP_VARIABLESTORE_H

#include "debugger/dap/VariableList.h"
#include "debugger/source/Frames.h"

#include "llvm/Support/JSON.h"

#include <map>
#include <memory>
#include <vector>

namespace tp::dap {

/// Frame \p Level of a thread.
struct FramePlace {
  uint32_t Thread = 0;
  uint32_t Level = 0;

  auto operator<=>(const FramePlace &) const = default;
};

/// The numbers by which a client names frames and lists of variables; they
/// mean nothing after the program has moved.
class VariableStore {
public:
  /// Forgets all numbers.
  void clear();

  int64_t frame(FramePlace Place);
  llvm::Expected<FramePlace> frame(int64_t Number) const;

  /// 0 for no list.
  int64_t list(std::shared_ptr<VariableList> List);
  llvm::Expected<std::shared_ptr<VariableList>> list(int64_t Number) const;

  /// A row as the protocol has it: what evaluate answers has `result` where
  /// variables have `value`. \p Memory turns an address into a reference.
  llvm::json::Object describe(const VariableRow &Row,
                              llvm::StringLiteral ValueName,
                              llvm::StringRef MemoryReference);

private:
  std::vector<FramePlace> Frames;
  std::map<FramePlace, int64_t> FrameNumbers;
  std::vector<std::shared_ptr<VariableList>> Lists;
  /// Numbers go on over stops, so that an old one is found out.
  int64_t FirstFrame = 1;
  int64_t FirstList = 1;
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_VARIABLESTORE_H
