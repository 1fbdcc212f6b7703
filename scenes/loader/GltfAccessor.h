//===- GltfAccessor.h - Checked reading of glTF accessors -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SCENES_LOADER_GLTFACCESSOR_H
#define TP_SCENES_LOADER_GLTFACCESSOR_H

#include "kernels/common/Vector3.h"
#include "scenes/loader/GltfFile.h"

#include <cstdint>
#include <vector>

namespace tp {

/// The elements of accessor \p Index as positions. Fails (without the file's
/// name) if the accessor does not hold three floats an element, leaves its
/// buffer, or holds a value that is not finite.
ErrorOr<std::vector<Vector3>> readPositions(const tinygltf::Model &Model,
                                            int Index);

/// The elements of accessor \p Index as vertex indices, each below
/// \p VertexCount. Fails (without the file's name) otherwise.
ErrorOr<std::vector<uint32_t>> readIndices(const tinygltf::Model &Model,
                                           int Index, size_t VertexCount);

} // namespace tp

#endif // TP_SCENES_LOADER_GLTFACCESSOR_H
