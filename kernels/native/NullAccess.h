//===- NullAccess.h - Kernels that use a null pointer -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_NATIVE_NULLACCESS_H
#define TP_KERNELS_NATIVE_NULLACCESS_H

namespace tp {

/// From now on an access of the first 64 KiB, which traps on the chip, ends the
/// process with status 1 and an error of \p Program that names the usual
/// reason: a kernel that renders without a scene. \p Program must live as long
/// as the process.
void reportNullAccess(const char *Program);

} // namespace tp

#endif // TP_KERNELS_NATIVE_NULLACCESS_H
