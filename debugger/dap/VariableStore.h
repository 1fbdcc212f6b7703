//===- VariableStore.h - Numbers of lists and frames ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_VARIABLESTORE_H
#define TP_DEBUGGER_DAP_VARIABLESTORE_H

#include "debugger/dap/VariableList.h"
#include "debugger/source/Frames.h"

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

/// A list of variables and the frame that they are of.
struct KeptList {
  std::shared_ptr<VariableList> List;
  FramePlace Place;
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
  int64_t list(std::shared_ptr<VariableList> List, FramePlace Place);
  llvm::Expected<KeptList> list(int64_t Number) const;

private:
  std::vector<FramePlace> Frames;
  std::map<FramePlace, int64_t> FrameNumbers;
  std::vector<KeptList> Lists;
  /// Numbers go on over stops, so that an old one is found out.
  int64_t FirstFrame = 1;
  int64_t FirstList = 1;
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_VARIABLESTORE_H
