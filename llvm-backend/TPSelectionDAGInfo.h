//===- TPSelectionDAGInfo.h - The TP's selection DAG nodes ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TPSELECTIONDAGINFO_H
#define TP_LLVM_BACKEND_TPSELECTIONDAGINFO_H

#include "llvm/CodeGen/SelectionDAGTargetInfo.h"

#define GET_SDNODE_ENUM
#include "TPGenSDNodeInfo.inc"

namespace llvm {

/// Describes the nodes of the TPISD name space.
class TPSelectionDAGInfo : public SelectionDAGGenTargetInfo {
public:
  TPSelectionDAGInfo();
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_TPSELECTIONDAGINFO_H
