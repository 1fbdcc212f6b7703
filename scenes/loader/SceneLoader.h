//===- SceneLoader.h - glTF and GLB files -----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SCENES_LOADER_SCENELOADER_H
#define TP_SCENES_LOADER_SCENELOADER_H

#include "scenes/ErrorOr.h"
#include "scenes/loader/Scene.h"

#include <string>

namespace tp {

/// Reads a glTF 2.0 file, text or binary by its content. Takes the default
/// scene (else the first, else all root nodes): every mesh instance with its
/// node's transform, and the first perspective camera that the scene's nodes
/// hold, depth first. Meshes may be indexed or not, as triangle lists, strips
/// or fans. Textures, normals, points, lines, skins and morph targets are left
/// out, with a warning where that changes the picture.
///
/// Fails with a message that names the file and the element: unreadable or
/// damaged file, missing buffer, index or accessor out of range, position
/// that is not finite, no triangle, no camera, unsupported required extension.
ErrorOr<Scene> loadScene(const std::string &Path);

} // namespace tp

#endif // TP_SCENES_LOADER_SCENELOADER_H
