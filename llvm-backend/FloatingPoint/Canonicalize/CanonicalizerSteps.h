//===- CanonicalizerSteps.h - Rewrites of one function -------- -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_CANONICALIZE_CANONICALIZERSTEPS_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_CANONICALIZE_CANONICALIZERSTEPS_H

namespace llvm {

class FloatingPointTarget;
class Function;

// The rewrites, in the order in which they run. Each acts on the instructions
// whose own fast-math flags allow it, on float and double, and on vectors of
// them. A rewritten instruction has neither `nnan` nor `ninf`, except for the
// checked mode: an intermediate value may overflow where the original did not.

/// Replaces calls of functions that only hand their arguments to a math
/// function, as std::sqrt does, by calls of that function.
void forwardMathWrappers(Function &F);

/// Replaces llvm.fmuladd by a product and a sum that may be contracted.
void splitMultiplyAdds(Function &F);

/// Replaces powers with a literal exponent by products and square roots.
void expandPowers(Function &F);

/// Replaces x / y by x * (1 / y), and 1 / sqrt(x) in single precision by one
/// function: (float)(1.0 / sqrt((double)x)), which is the TP's rsqrt_s.
void replaceDivisions(Function &F, const FloatingPointTarget &Target);

/// Rebuilds products of several factors: equal factors become powers, constants
/// are merged, and so are reciprocals.
void rebuildProducts(Function &F);

/// Replaces a * k + b * k by (a + b) * k.
void factorSums(Function &F);

/// Fuses products with sums where the target has the instruction. A sum whose
/// products have both signs, as a * b - c * d, is never fused: it would not be
/// zero for equal products, and comparators rely on that.
void contractSums(Function &F, const FloatingPointTarget &Target);

/// Makes what later passes and the code generator could evaluate in more than
/// one way a call that they do not know.
void fixMathFunctions(Function &F);

/// Removes the fast-math flags that allow other bits, and the attributes and
/// metadata that say the same. `nnan` and `ninf` stay.
void stripFastMathFlags(Function &F);

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_CANONICALIZE_CANONICALIZERSTEPS_H
