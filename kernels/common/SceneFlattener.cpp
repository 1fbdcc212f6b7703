//===- SceneFlattener.cpp - From a scene to its memory block --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/common/SceneFlattener.h"

#include "kernels/bvh/BvhBuilder.h"
#include "kernels/bvh/QuantizedBvh.h"
#include "kernels/bvh/WideBvh.h"
#include "kernels/common/LightTable.h"
#include "kernels/common/SceneLayout.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>

namespace tp {

namespace {

/// Room for the small arrays of a block, bytes.
constexpr size_t kExpectedRest = 1 << 16;

/// Collects arrays behind a header, each at an aligned offset.
class BlockWriter {
public:
  /// \p PaddingBytes follow each array.
  explicit BlockWriter(uint32_t PaddingBytes)
      : PaddingBytes(PaddingBytes), Bytes(sizeof(SceneHeader)) {}

  /// Avoids copies until so many bytes are appended.
  void expect(size_t ByteCount) { Bytes.reserve(Bytes.size() + ByteCount); }

  template <typename T> uint32_t append(const std::vector<T> &Records) {
    const uint32_t Offset = appendZeros<T>(Records.size());
    if (!Records.empty())
      std::memcpy(Bytes.data() + Offset, Records.data(),
                  Records.size() * sizeof(T));
    return Offset;
  }

  /// Appends Make(0), Make(1) and so on.
  template <typename Maker> uint32_t append(size_t Count, Maker Make) {
    using Record = decltype(Make(size_t(0)));
    const uint32_t Offset = appendZeros<Record>(Count);
    uint8_t *Target = Bytes.data() + Offset;
    for (size_t Number = 0; Number != Count; ++Number) {
      const Record Made = Make(Number);
      std::memcpy(Target + Number * sizeof(Record), &Made, sizeof(Record));
    }
    return Offset;
  }

  /// Appends \p Count records whose bytes are all 0.
  template <typename T> uint32_t appendZeros(size_t Count) {
    const size_t Offset = (Bytes.size() + kSceneAlignment - 1) /
                          kSceneAlignment * kSceneAlignment;
    const size_t Size = Count * sizeof(T) + PaddingBytes;
    assert(Offset + Size <= UINT32_MAX && "the loader bounds scenes");
    Bytes.resize(Offset + Size);
    return uint32_t(Offset);
  }

  std::vector<uint8_t> finish(SceneHeader Header) {
    Header.ByteCount = uint32_t(Bytes.size());
    std::memcpy(Bytes.data(), &Header, sizeof(Header));
    return std::move(Bytes);
  }

private:
  const uint32_t PaddingBytes;
  std::vector<uint8_t> Bytes;
};

} // namespace

/// The largest magnitude of any coordinate that rays start from or end at.
static float largestCoordinate(const Scene &Source) {
  float Largest = 0;
  auto Consider = [&](Vector3 Point) {
    Largest = std::max(
        {Largest, std::abs(Point.X), std::abs(Point.Y), std::abs(Point.Z)});
  };
  Consider(Source.Camera.Position);
  for (const Triangle &Shape : Source.Triangles)
    for (Vector3 Vertex : Shape.Vertices)
      Consider(Vertex);
  return Largest;
}

static std::vector<BoundingBox> boundTriangles(const Scene &Source,
                                               float Padding) {
  std::vector<BoundingBox> Boxes;
  Boxes.reserve(Source.Triangles.size());
  const Vector3 Margin = {Padding, Padding, Padding};
  for (const Triangle &Shape : Source.Triangles) {
    BoundingBox Box;
    for (Vector3 Vertex : Shape.Vertices)
      Box.extend(Vertex);
    Boxes.push_back({Box.Lower - Margin, Box.Upper + Margin});
  }
  return Boxes;
}

using Double3 = std::array<double, 3>;

static Double3 toDouble(Vector3 V) { return {V.X, V.Y, V.Z}; }
static Double3 subtract(Double3 A, Double3 B) {
  return {A[0] - B[0], A[1] - B[1], A[2] - B[2]};
}
static Double3 crossProduct(Double3 A, Double3 B) {
  return {A[1] * B[2] - A[2] * B[1], A[2] * B[0] - A[0] * B[2],
          A[0] * B[1] - A[1] * B[0]};
}
static double dotProduct(Double3 A, Double3 B) {
  return A[0] * B[0] + A[1] * B[1] + A[2] * B[2];
}
static TriangleRecord makeTriangle(const Triangle &Shape,
                                   const Material &Surface) {
  const Double3 Vertex = toDouble(Shape.Vertices[0]);
  const Double3 EdgeA = subtract(toDouble(Shape.Vertices[1]), Vertex);
  const Double3 EdgeB = subtract(toDouble(Shape.Vertices[2]), Vertex);
  const Double3 Normal = crossProduct(EdgeA, EdgeB);
  const double Length = std::sqrt(dotProduct(Normal, Normal));
  TriangleRecord Record;
  std::copy_n(Shape.Vertices, 3, Record.Corners);
  Record.UnitNormal = {float(Normal[0] / Length), float(Normal[1] / Length),
                       float(Normal[2] / Length)};
  Record.BaseColor = Surface.BaseColor;
  Record.Emitter = Surface.isEmissive() ? Shape.Material : kNoEmitter;
  return Record;
}

static CameraRecord makeCamera(const Camera &Source) {
  const float HalfHeight =
      float(std::tan(double(Source.VerticalFieldOfView) / 2));
  return {Source.Position, Source.Right * HalfHeight, Source.Up * HalfHeight,
          Source.Forward};
}

/// Triangle \p Number of the file.
static TriangleRecord makeTriangle(const Scene &Source, size_t Number) {
  const Triangle &Shape = Source.Triangles[Number];
  return makeTriangle(Shape, Source.Materials[Shape.Material]);
}

/// \p LargestCoordinate is that of all boxes and origins of rays.
static std::vector<QuantizedBvhNode>
quantizeNodes(const std::vector<WideBvhNode> &Nodes, float LargestCoordinate) {
  std::vector<QuantizedBvhNode> Quantized(Nodes.size());
  quantizeBvh({Nodes.data(), uint32_t(Nodes.size()), LargestCoordinate,
               Quantized.data()});
  return Quantized;
}

/// Appends the tree and the triangles in its order. \p LargestCoordinate is
/// that of all boxes and origins of rays.
static void appendTree(const Scene &Source,
                       const std::vector<BoundingBox> &Boxes,
                       float LargestCoordinate, SceneHeader &Header,
                       BlockWriter &Block) {
  const uint32_t Count = uint32_t(Boxes.size());
  std::vector<uint32_t> Order(Count);
  std::vector<BvhNode> Nodes(Count - 1);
  BvhStorage Storage{Boxes.data(), Count, Order.data(), Nodes.data(), 0};
  const BvhReference BinaryRoot = buildBvh(Storage);
  std::vector<WideBvhNode> WideNodes(Storage.NodeCount);
  WideBvhStorage WideStorage{Nodes.data(), WideNodes.data(), 0};
  Header.Root = widenBvh(WideStorage, BinaryRoot);
  WideNodes.resize(WideStorage.WideNodeCount);
  Block.expect(WideNodes.size() *
                   (sizeof(WideBvhNode) + sizeof(QuantizedBvhNode)) +
               Count * sizeof(TriangleRecord) + kExpectedRest);
  Header.NodesOffset = Block.append(WideNodes);
  Header.NodeCount = uint32_t(WideNodes.size());
  Header.BvhDepth = WideStorage.Depth;
  Header.QuantizedNodesOffset =
      Block.append(quantizeNodes(WideNodes, LargestCoordinate));
  Header.TrianglesOffset = Block.append(
      Count, [&](size_t At) { return makeTriangle(Source, Order[At]); });
}

/// Appends what a kernel needs to do the work of appendTree().
static void appendWorkspace(const Scene &Source,
                            const std::vector<BoundingBox> &Boxes,
                            SceneHeader &Header, BlockWriter &Block) {
  const uint32_t Count = uint32_t(Boxes.size());
  const uint32_t InnerCount = Count - 1;
  Block.expect(Count *
                   (2 * sizeof(TriangleRecord) + sizeof(BoundingBox) +
                    sizeof(uint32_t) + sizeof(WideBvhNode) + sizeof(BvhNode)) +
               kExpectedRest);
  Header.Root = kNoBvh;
  Header.NodesOffset = Block.appendZeros<WideBvhNode>(InnerCount);
  Header.TrianglesOffset = Block.appendZeros<TriangleRecord>(Count);
  BvhWorkspace Workspace{};
  Workspace.SourcesOffset = Block.append(
      Count, [&](size_t Number) { return makeTriangle(Source, Number); });
  Workspace.BoxesOffset = Block.append(Boxes);
  Workspace.OrderOffset = Block.appendZeros<uint32_t>(Count);
  Workspace.BinaryNodesOffset = Block.appendZeros<BvhNode>(InnerCount);
  Workspace.BinaryRoot = kNoBvh;
  Header.WorkspaceOffset = Block.append(std::vector<BvhWorkspace>{Workspace});
}

std::vector<uint8_t> flattenScene(const Scene &Source, BvhOrigin Origin,
                                  uint32_t PaddingBytes) {
  const float Largest = largestCoordinate(Source);
  // The slab test's subtraction and multiplication err by less than 2^-22 of
  // the largest coordinate; a few times that makes it miss nothing.
  const std::vector<BoundingBox> Boxes =
      boundTriangles(Source, Largest * 0x1p-20f);
  SceneHeader Header{};
  // A hit point errs by some 2^-22 of the largest coordinate.
  Header.SurfaceOffset = Largest * 0x1p-16f;
  BlockWriter Block(PaddingBytes);
  if (Origin == BvhOrigin::Kernel)
    appendWorkspace(Source, Boxes, Header, Block);
  else
    appendTree(Source, Boxes, Largest + Header.SurfaceOffset, Header, Block);

  std::vector<MaterialRecord> Materials;
  Materials.reserve(Source.Materials.size());
  for (const Material &Surface : Source.Materials)
    Materials.push_back({Surface.Emission, 0});
  LightTable Lights = makeLightTable(Source);
  Header.LightCount = uint32_t(Lights.Records.size());
  Lights.Records.resize(std::max<size_t>(Lights.Records.size(), 1));
  Lights.Choices.resize(Lights.Records.size());

  Header.Version = kSceneVersion;
  Header.TriangleCount = uint32_t(Source.Triangles.size());
  Header.MaterialsOffset = Block.append(Materials);
  Header.MaterialCount = uint32_t(Materials.size());
  Header.LightsOffset = Block.append(Lights.Records);
  Header.LightChoicesOffset = Block.append(Lights.Choices);
  Header.Camera = makeCamera(Source.Camera);
  Header.LightScale = float(Lights.TotalArea / M_PI);
  return Block.finish(Header);
}

} // namespace tp
