//===- GltfAccessor.cpp - Checked reading of glTF accessors ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "scenes/loader/GltfAccessor.h"

#include <cmath>
#include <cstring>

namespace tp {

namespace {

/// Count elements, Stride bytes apart, that all lie inside a buffer.
struct ElementRange {
  const unsigned char *First;
  size_t Count;
  size_t Stride;
  int ComponentType;
  int Type;
};

} // namespace

static Error accessorError(int Index, const std::string &Reason) {
  return Error{"accessor " + std::to_string(Index) + ": " + Reason};
}

static ErrorOr<ElementRange> findElements(const tinygltf::Model &Model,
                                          int Index) {
  if (Index < 0 || size_t(Index) >= Model.accessors.size())
    return accessorError(Index, "there are only " +
                                    std::to_string(Model.accessors.size()) +
                                    " accessors");
  const tinygltf::Accessor &Accessor = Model.accessors[Index];
  if (Accessor.sparse.isSparse)
    return accessorError(Index, "sparse accessors are not supported");
  if (Accessor.bufferView < 0 ||
      size_t(Accessor.bufferView) >= Model.bufferViews.size())
    return accessorError(Index, "has no buffer view " +
                                    std::to_string(Accessor.bufferView));
  const tinygltf::BufferView &View = Model.bufferViews[Accessor.bufferView];
  if (View.buffer < 0 || size_t(View.buffer) >= Model.buffers.size())
    return accessorError(Index,
                         "buffer view " + std::to_string(Accessor.bufferView) +
                             " has no buffer " + std::to_string(View.buffer));
  const int ElementBytes =
      tinygltf::GetComponentSizeInBytes(Accessor.componentType) *
      tinygltf::GetNumComponentsInType(Accessor.type);
  const int Stride = Accessor.ByteStride(View);
  if (ElementBytes <= 0 || Stride < ElementBytes)
    return accessorError(Index, "bad component type, type or stride");

  const std::vector<unsigned char> &Buffer = Model.buffers[View.buffer].data;
  if (View.byteOffset > Buffer.size() ||
      View.byteLength > Buffer.size() - View.byteOffset)
    return accessorError(
        Index, "buffer view " + std::to_string(Accessor.bufferView) +
                   " ends beyond buffer " + std::to_string(View.buffer) +
                   ", which has " + std::to_string(Buffer.size()) + " bytes");
  // Written so that no sum can overflow.
  const size_t ViewBytes = View.byteLength;
  const bool Fits =
      Accessor.count == 0 ||
      (Accessor.byteOffset <= ViewBytes &&
       size_t(ElementBytes) <= ViewBytes - Accessor.byteOffset &&
       Accessor.count - 1 <=
           (ViewBytes - Accessor.byteOffset - ElementBytes) / size_t(Stride));
  if (!Fits)
    return accessorError(Index, std::to_string(Accessor.count) +
                                    " elements end beyond buffer view " +
                                    std::to_string(Accessor.bufferView) +
                                    ", which has " + std::to_string(ViewBytes) +
                                    " bytes");
  return ElementRange{Buffer.data() + View.byteOffset + Accessor.byteOffset,
                      Accessor.count, size_t(Stride), Accessor.componentType,
                      Accessor.type};
}

ErrorOr<std::vector<Vector3>> readPositions(const tinygltf::Model &Model,
                                            int Index) {
  const ErrorOr<ElementRange> Range = findElements(Model, Index);
  if (!Range)
    return Error{Range.message()};
  if (Range->ComponentType != TINYGLTF_COMPONENT_TYPE_FLOAT ||
      Range->Type != TINYGLTF_TYPE_VEC3)
    return accessorError(Index, "positions must be VEC3 of FLOAT");
  std::vector<Vector3> Positions(Range->Count);
  for (size_t Element = 0; Element != Range->Count; ++Element) {
    Vector3 &Position = Positions[Element];
    std::memcpy(&Position, Range->First + Element * Range->Stride,
                sizeof(Position));
    if (!std::isfinite(Position.X) || !std::isfinite(Position.Y) ||
        !std::isfinite(Position.Z))
      return accessorError(Index, "position " + std::to_string(Element) +
                                      " is not finite");
  }
  return Positions;
}

template <typename Component>
static uint32_t readComponent(const unsigned char *Bytes) {
  Component Value;
  std::memcpy(&Value, Bytes, sizeof(Value));
  return Value;
}

ErrorOr<std::vector<uint32_t>> readIndices(const tinygltf::Model &Model,
                                           int Index, size_t VertexCount) {
  const ErrorOr<ElementRange> Range = findElements(Model, Index);
  if (!Range)
    return Error{Range.message()};
  uint32_t (*Read)(const unsigned char *) = nullptr;
  switch (Range->ComponentType) {
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
    Read = readComponent<uint8_t>;
    break;
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
    Read = readComponent<uint16_t>;
    break;
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    Read = readComponent<uint32_t>;
    break;
  }
  if (!Read || Range->Type != TINYGLTF_TYPE_SCALAR)
    return accessorError(Index, "indices must be SCALAR of an unsigned type");
  std::vector<uint32_t> Indices(Range->Count);
  for (size_t Element = 0; Element != Range->Count; ++Element) {
    Indices[Element] = Read(Range->First + Element * Range->Stride);
    if (Indices[Element] >= VertexCount)
      return accessorError(Index,
                           "element " + std::to_string(Element) + " is index " +
                               std::to_string(Indices[Element]) +
                               ", but there are only " +
                               std::to_string(VertexCount) + " vertices");
  }
  return Indices;
}

} // namespace tp
