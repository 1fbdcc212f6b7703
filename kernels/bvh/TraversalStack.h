//===- TraversalStack.h - What a ray has still to visit ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_BVH_TRAVERSALSTACK_H
#define TP_KERNELS_BVH_TRAVERSALSTACK_H

#include "kernels/bvh/RayBoxTester.h"
#include "kernels/common/Inline.h"
#include "kernels/common/SceneLayout.h"

namespace tp {

/// Entries of a TraversalStack that a tree with \p Depth inner nodes on its
/// longest way needs: each node on the way leaves all but one of its children
/// there.
constexpr uint32_t traversalEntries(uint32_t Depth) {
  return Depth * (kWideBvhWidth - 1) + 1;
}

/// Nodes and leaves that wait to be visited.
class TraversalStack {
public:
  struct Entry {
    BvhReference Reference;
    float Enter;
  };
  /// Enough for every tree.
  static constexpr uint32_t Capacity = traversalEntries(kMaxBvhDepth);

  /// \p Entries has room for what the tree needs. It is not a member, so that
  /// the compiler can keep the members in registers.
  explicit TraversalStack(Entry *Entries) : Bottom(Entries), Top(Entries) {}

  TP_KERNEL_INLINE void push(BvhReference Reference, float Enter) {
    *Top++ = {Reference, Enter};
  }
  /// Pushes without a branch that the load of \p Reference could sink behind.
  TP_KERNEL_INLINE void pushIf(bool Condition, BvhReference Reference) {
    Top->Reference = Reference;
    Top += Condition;
  }
  /// The youngest entry that begins before \p MaxDistance; false if there is
  /// none.
  TP_KERNEL_INLINE bool popNearer(float MaxDistance, BvhReference &Reference) {
    do {
      if (Top == Bottom)
        return false;
      --Top;
    } while (Top->Enter > MaxDistance);
    Reference = Top->Reference;
    return true;
  }
  /// The youngest entry; false if there is none.
  TP_KERNEL_INLINE bool pop(BvhReference &Reference) {
    if (Top == Bottom)
      return false;
    Reference = (--Top)->Reference;
    return true;
  }

  /// Where the next entry goes.
  Entry *top() const { return Top; }

private:
  Entry *const Bottom;
  Entry *Top;
};

/// Beyond every distance.
inline constexpr float kNoChild = 0x1p127f;

/// Pushes the children that the ray hits but for the nearest, which becomes
/// \p Reference; false if it hits none.
TP_KERNEL_INLINE bool descendToNearest(const BoxDistances &D,
                                       const BvhReference *Children,
                                       TraversalStack &Stack,
                                       BvhReference &Reference) {
  // Set even without a hit, lest its load waits for the decision.
  BvhReference Nearest = Children[0];
  float NearestEnter = D.isHit(0) ? D.Enter[0] : kNoChild;
  for (unsigned Child = 1; Child != kWideBvhWidth; ++Child) {
    if (!D.isHit(Child))
      continue;
    if (D.Enter[Child] < NearestEnter) {
      if (NearestEnter != kNoChild)
        Stack.push(Nearest, NearestEnter);
      Nearest = Children[Child];
      NearestEnter = D.Enter[Child];
    } else {
      Stack.push(Children[Child], D.Enter[Child]);
    }
  }
  Reference = Nearest;
  return NearestEnter != kNoChild;
}

} // namespace tp

#endif // TP_KERNELS_BVH_TRAVERSALSTACK_H
