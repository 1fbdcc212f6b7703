//===- TPSelectionDAGInfo.cpp - The TP's selection DAG nodes --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TPSelectionDAGInfo.h"

#define GET_SDNODE_DESC
#include "TPGenSDNodeInfo.inc"

using namespace llvm;

TPSelectionDAGInfo::TPSelectionDAGInfo()
    : SelectionDAGGenTargetInfo(TPGenSDNodeInfo) {}
