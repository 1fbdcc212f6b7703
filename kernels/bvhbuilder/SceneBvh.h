//===- SceneBvh.h - Building a scene's tree in place ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_BVHBUILDER_SCENEBVH_H
#define TP_KERNELS_BVHBUILDER_SCENEBVH_H

namespace tp {

/// Builds the tree of the scene at \p SceneBlock in its BvhWorkspace and makes
/// the scene ready to render. All threads call it and leave it together. False,
/// having said why on stderr, if the scene has its tree already.
bool buildSceneBvh(void *SceneBlock);

} // namespace tp

#endif // TP_KERNELS_BVHBUILDER_SCENEBVH_H
