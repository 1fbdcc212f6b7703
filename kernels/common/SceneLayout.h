//===- SceneLayout.h - A scene as one block of memory -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A flattened scene is one block of bytes that means the same wherever it lies:
// a SceneHeader, and arrays that the header finds by their distance in bytes
// from the block's start. Host and TP share these structures. Records are 64
// bytes (a shift finds one), aligned to 64 bytes.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_SCENELAYOUT_H
#define TP_KERNELS_COMMON_SCENELAYOUT_H

#include "kernels/common/Vector3.h"

#include <stdint.h>

namespace tp {

/// What a child of a BVH node is: another node, or a range of triangles.
///   node:  0 | where the node is, in a way that the kind of node defines : 31
///   leaf:  1 | first triangle : 27 | number of triangles, 1 to 15 : 4
using BvhReference = uint32_t;

inline constexpr uint32_t kMaxLeafTriangles = 15;
/// So that a scene with its tree and, if all triangles shine, its lights fits
/// in a 32-bit address space.
inline constexpr uint32_t kMaxBvhTriangles = 15u << 20;
/// So that a scene with the BvhWorkspace of its kernel fits there, too.
inline constexpr uint32_t kMaxWorkspaceTriangles = 1u << 23;
/// No vertex has a coordinate of a larger magnitude: BoundingBox::Far is
/// beyond.
inline constexpr float kMaxCoordinate = 1e18f;
/// Inner nodes on the way from the root to any leaf, at most.
inline constexpr uint32_t kMaxBvhDepth = 40;

constexpr bool isLeaf(BvhReference Reference) {
  return static_cast<int32_t>(Reference) < 0;
}
constexpr BvhReference leafReference(uint32_t First, uint32_t Count) {
  return 0x80000000u | First << 4 | Count;
}
constexpr uint32_t leafFirst(BvhReference Leaf) {
  return (Leaf & 0x7FFFFFFFu) >> 4;
}
constexpr uint32_t leafCount(BvhReference Leaf) { return Leaf & 15u; }

/// The root of a tree that nobody has built: a leaf without triangles.
inline constexpr BvhReference kNoBvh = leafReference(0, 0);

inline constexpr uint32_t kWideBvhWidth = 4;

/// An inner node of the tree that rays traverse: the boxes of up to four
/// children, so that one wait for memory decides on all of them. References to
/// it hold its byte offset from the start of the node array.
struct WideBvhNode {
  /// [axis][0 = lower, 1 = upper side][child]: once the ray's sign has chosen
  /// the side, the near planes of all children lie side by side. A slot without
  /// a child has a box that is upside down, which no ray hits.
  float Bounds[3][2][kWideBvhWidth];
  BvhReference Child[kWideBvhWidth];
  uint32_t Reserved[4];
};

/// The byte offset in a WideBvhNode of the lower bounds of \p Axis, and the
/// distance from there to the upper bounds.
constexpr uint32_t boundsOffset(uint32_t Axis) {
  return Axis * 2 * kWideBvhWidth * static_cast<uint32_t>(sizeof(float));
}
inline constexpr uint32_t kBoundsSideBytes =
    kWideBvhWidth * static_cast<uint32_t>(sizeof(float));

/// A WideBvhNode in half of its bytes: the boxes are rounded outwards to a grid
/// of the node's own. After H. Ylitie, T. Karras and S. Laine, "Efficient
/// Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", HPG 2017.
/// QuantizedPlanes.h decodes it. References are byte offsets from the start of
/// the array of quantized nodes.
struct QuantizedBvhNode {
  /// A plane is at Origin + number * scale, for each axis.
  float Origin[3];
  /// The scales of the three axes: floats cut to their highest bits.
  uint32_t Scales;
  /// [axis][0 = lower, 1 = upper side]: the byte of a child's plane is that of
  /// the child's number, the lowest first. A child that is missing has a box
  /// that is upside down, which no ray hits, and is a leaf without triangles.
  uint32_t Planes[3][2];
  BvhReference Child[kWideBvhWidth];
  /// Not part of the node: a shift finds it.
  uint32_t Reserved[2];
};

/// Of a triangle that emits no light.
inline constexpr uint32_t kNoEmitter = 0xFFFFFFFFu;

struct TriangleRecord {
  /// All that the test of a ray reads.
  Vector3 Corners[3];
  Vector3 UnitNormal;
  /// A copy of the material's, to save a dependent load.
  Vector3 BaseColor;
  /// The number of its material if that emits light, else kNoEmitter.
  uint32_t Emitter;
};

struct MaterialRecord {
  Vector3 Emission;
  uint32_t Reserved;
};

/// A triangle that emits light.
struct LightRecord {
  Vector3 Vertex;
  /// From Vertex to the other two.
  Vector3 Edges[2];
  Vector3 UnitNormal;
  Vector3 Emission;
  uint32_t Reserved;
};

/// One cell of the table that picks lights in proportion to their area: the
/// light of the cell's own number with probability Keep / 2^32, else Alias.
/// After M. Vose, "A Linear Algorithm for Generating Random Numbers with a
/// Given Distribution", IEEE TSE 17(9), 1991.
struct LightChoice {
  uint32_t Keep;
  uint32_t Alias;
};

/// A pinhole camera: the ray through the point (X, Y) of the picture, both from
/// -1 (left, bottom) to 1, has the direction Forward + X * aspect * Right +
/// Y * Up.
struct CameraRecord {
  Vector3 Position;
  /// Right and Up have the length of half the picture's height at distance 1.
  Vector3 Right;
  Vector3 Up;
  Vector3 Forward;
};

struct SceneHeader {
  /// kSceneVersion of the writer.
  uint32_t Version;
  /// Of the whole block.
  uint32_t ByteCount;

  uint32_t NodesOffset;
  uint32_t NodeCount;
  uint32_t TrianglesOffset;
  uint32_t TriangleCount;
  uint32_t MaterialsOffset;
  uint32_t MaterialCount;
  uint32_t LightsOffset;
  uint32_t LightChoicesOffset;
  /// Of both arrays. 0 in a scene without light; then both hold one light that
  /// emits nothing, so that a kernel may read it before it looks here.
  uint32_t LightCount;
  /// The root of the BVH; a leaf if the scene has few triangles.
  BvhReference Root;

  CameraRecord Camera;
  /// Distance from a surface at which rays start that leave it: more than the
  /// rounding errors of a hit point.
  float SurfaceOffset;
  /// Area of all lights / pi: the factor between the integrand at a uniformly
  /// chosen light point and the light reflected by a white surface.
  float LightScale;
  /// The BvhWorkspace of a scene whose tree the kernel builds; 0 if the host
  /// has built it.
  uint32_t WorkspaceOffset;
  /// The same tree as NodeCount QuantizedBvhNodes; 0 if the kernel builds it,
  /// which makes none.
  uint32_t QuantizedNodesOffset;
  /// Inner nodes on the longest way from the root to a leaf.
  uint32_t BvhDepth;
  uint32_t Reserved[3];
};

/// What a kernel that builds the tree finds, and where it leaves the result.
/// The arrays at NodesOffset and TrianglesOffset of the header are zero then,
/// with room for TriangleCount - 1 nodes and all triangles; the kernel fills
/// them and sets NodeCount, BvhDepth and Root, which until then is kNoBvh.
struct BvhWorkspace {
  /// The triangles in the order of the file, and their boxes (BoundingBox).
  uint32_t SourcesOffset;
  uint32_t BoxesOffset;
  /// One uint32_t per triangle: which source each triangle of the scene is.
  uint32_t OrderOffset;
  /// Room for TriangleCount - 1 nodes of the binary tree (BvhNode).
  uint32_t BinaryNodesOffset;
  /// Results, as BinaryNodesOffset's nodes are.
  uint32_t BinaryNodeCount;
  BvhReference BinaryRoot;
  uint32_t Reserved[2];
};

inline constexpr uint32_t kSceneVersion = 1;
inline constexpr uint32_t kSceneAlignment = 128;

static_assert(sizeof(WideBvhNode) == 128 && sizeof(QuantizedBvhNode) == 64 &&
                  sizeof(TriangleRecord) == 64 && sizeof(LightRecord) == 64 &&
                  sizeof(MaterialRecord) == 16 && sizeof(LightChoice) == 8 &&
                  sizeof(SceneHeader) == 128 && sizeof(BvhWorkspace) == 32,
              "host and TP share one layout");
static_assert(__builtin_offsetof(WideBvhNode, Child) == 96 &&
                  __builtin_offsetof(QuantizedBvhNode, Child) == 40 &&
                  __builtin_offsetof(SceneHeader, Camera) == 48 &&
                  __builtin_offsetof(TriangleRecord, UnitNormal) == 36,
              "host and TP share one layout");

/// The arrays of a flattened scene as pointers.
struct SceneView {
  const SceneHeader *Header;
  const char *Nodes;
  /// Null if there are none.
  const char *QuantizedNodes;
  const TriangleRecord *Triangles;
  const MaterialRecord *Materials;
  const LightRecord *Lights;
  const LightChoice *LightChoices;

  explicit SceneView(const void *Block)
      : SceneView(Block, *static_cast<const SceneHeader *>(Block)) {}

  /// The scene at \p Block, of whose header \p Header is a copy that outlives
  /// the view.
  SceneView(const void *Block, const SceneHeader &Header)
      : Header(&Header), Nodes(at<char>(Block, Header.NodesOffset)),
        QuantizedNodes(Header.QuantizedNodesOffset != 0
                           ? at<char>(Block, Header.QuantizedNodesOffset)
                           : nullptr),
        Triangles(at<TriangleRecord>(Block, Header.TrianglesOffset)),
        Materials(at<MaterialRecord>(Block, Header.MaterialsOffset)),
        Lights(at<LightRecord>(Block, Header.LightsOffset)),
        LightChoices(at<LightChoice>(Block, Header.LightChoicesOffset)) {}

private:
  template <typename T> static const T *at(const void *Block, uint32_t Offset) {
    return reinterpret_cast<const T *>(static_cast<const char *>(Block) +
                                       Offset);
  }
};

} // namespace tp

#endif // TP_KERNELS_COMMON_SCENELAYOUT_H
