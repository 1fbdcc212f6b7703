//===- FloatingPointPasses.h - Their place in the pipeline ---- -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_FLOATINGPOINTPASSES_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_FLOATINGPOINTPASSES_H

namespace llvm {

class PassBuilder;

/// Puts the passes of FloatingPointPasses.def at the start of every pipeline,
/// those of -O0 and of link time among them, and makes their names known to
/// `-passes=`. At the end of pipelines that optimize, checks are merged.
void registerFloatingPointPasses(PassBuilder &PB);

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_FLOATINGPOINTPASSES_H
