//===- GltfFile.h - Parsing of glTF files through tinygltf ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SCENES_LOADER_GLTFFILE_H
#define TP_SCENES_LOADER_GLTFFILE_H

#include "scenes/ErrorOr.h"

#include <string>
#include <tiny_gltf.h>

namespace tp {

/// Reads a glTF or GLB file (told apart by the first four bytes) and its
/// buffers. Images are not decoded. Messages start with the path.
ErrorOr<tinygltf::Model> readGltf(const std::string &Path);

/// How messages name an element: `mesh 3 "chair"`, or `mesh 3` without a name.
std::string describe(const char *Kind, size_t Index, const std::string &Name);

} // namespace tp

#endif // TP_SCENES_LOADER_GLTFFILE_H
