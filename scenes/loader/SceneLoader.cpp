//===- SceneLoader.cpp - glTF and GLB files -------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "scenes/loader/SceneLoader.h"

#include "kernels/common/SceneLayout.h"
#include "scenes/loader/GltfAccessor.h"
#include "scenes/loader/GltfFile.h"
#include "scenes/loader/Transform.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace tp {

namespace {

/// Walks the nodes of one file and collects the scene.
class SceneBuilder {
public:
  explicit SceneBuilder(const tinygltf::Model &Model) : Model(Model) {}

  /// The scene; messages do not name the file.
  ErrorOr<Scene> build();

private:
  Status readMaterials();
  ErrorOr<Material> readMaterial(const tinygltf::Material &Source,
                                 const std::string &Element);
  ErrorOr<std::vector<int>> findRoots();
  Status visit(const std::vector<int> &Roots);
  ErrorOr<Transform> readTransform(const tinygltf::Node &Node);
  Status addMesh(int Index, const Transform &ToWorld);
  Status addPrimitive(const tinygltf::Primitive &Primitive,
                      const Transform &ToWorld);
  Status addCamera(int Index, const Transform &ToWorld);
  ErrorOr<uint32_t> materialIndex(int Index);
  void warn(std::string Message);

  const tinygltf::Model &Model;
  Scene Result;
  std::optional<Camera> FoundCamera;
  std::optional<uint32_t> DefaultMaterial;
  size_t DegenerateTriangles = 0;
};

} // namespace

static Error inside(const std::string &Element, const std::string &Message) {
  return Error{Element + ": " + Message};
}

void SceneBuilder::warn(std::string Message) {
  if (std::find(Result.Warnings.begin(), Result.Warnings.end(), Message) ==
      Result.Warnings.end())
    Result.Warnings.push_back(std::move(Message));
}

static bool isFinite(Vector3 V) {
  return std::isfinite(V.X) && std::isfinite(V.Y) && std::isfinite(V.Z);
}

/// Whether a finite point is one that boxes can hold.
static bool isInReach(Vector3 V) {
  return std::abs(V.X) <= kMaxCoordinate && std::abs(V.Y) <= kMaxCoordinate &&
         std::abs(V.Z) <= kMaxCoordinate;
}

static ErrorOr<Vector3> readColor(const std::vector<double> &Components,
                                  const char *What, double Scale = 1) {
  if (Components.size() < 3)
    return Error{std::string(What) + " has fewer than three components"};
  for (double Component : Components)
    if (!(Component >= 0 && Component <= 1))
      return Error{std::string(What) + " is not between 0 and 1"};
  return Vector3{float(Components[0] * Scale), float(Components[1] * Scale),
                 float(Components[2] * Scale)};
}

ErrorOr<Material> SceneBuilder::readMaterial(const tinygltf::Material &Source,
                                             const std::string &Element) {
  Material Target;
  Target.Name = Source.name;
  const tinygltf::PbrMetallicRoughness &Pbr = Source.pbrMetallicRoughness;
  const ErrorOr<Vector3> BaseColor =
      readColor(Pbr.baseColorFactor, "baseColorFactor");
  if (!BaseColor)
    return Error{BaseColor.message()};
  Target.BaseColor = *BaseColor;
  if (Pbr.baseColorTexture.index >= 0 || Source.emissiveTexture.index >= 0)
    warn(Element + ": textures are left out");

  double Strength = 1;
  const auto Extension =
      Source.extensions.find("KHR_materials_emissive_strength");
  if (Extension != Source.extensions.end() &&
      Extension->second.Has("emissiveStrength")) {
    const tinygltf::Value &Value = Extension->second.Get("emissiveStrength");
    Strength = Value.IsNumber() ? Value.GetNumberAsDouble() : -1;
    if (!(Strength >= 0 && std::isfinite(float(Strength))))
      return Error{"emissiveStrength is not a number of at least 0"};
  }
  const ErrorOr<Vector3> Emission =
      readColor(Source.emissiveFactor, "emissiveFactor", Strength);
  if (!Emission)
    return Error{Emission.message()};
  Target.Emission = *Emission;
  return Target;
}

Status SceneBuilder::readMaterials() {
  for (size_t Index = 0; Index != Model.materials.size(); ++Index) {
    const tinygltf::Material &Source = Model.materials[Index];
    const std::string Element = describe("material", Index, Source.name);
    ErrorOr<Material> Target = readMaterial(Source, Element);
    if (!Target)
      return inside(Element, Target.message());
    Result.Materials.push_back(std::move(*Target));
  }
  return success();
}

ErrorOr<uint32_t> SceneBuilder::materialIndex(int Index) {
  if (Index >= 0) {
    if (size_t(Index) < Model.materials.size())
      return uint32_t(Index);
    return Error{"has no material " + std::to_string(Index)};
  }
  if (!DefaultMaterial) {
    DefaultMaterial = uint32_t(Result.Materials.size());
    Result.Materials.push_back({"default", {1, 1, 1}, {0, 0, 0}});
  }
  return *DefaultMaterial;
}

/// Every corner triple of a primitive of \p Count vertices.
template <typename Visitor>
static void forEachTriangle(int Mode, size_t Count, Visitor Visit) {
  if (Mode == TINYGLTF_MODE_TRIANGLES) {
    for (size_t First = 0; First + 2 < Count; First += 3)
      Visit(First, First + 1, First + 2);
    return;
  }
  for (size_t Last = 2; Last < Count; ++Last) {
    if (Mode == TINYGLTF_MODE_TRIANGLE_FAN)
      Visit(size_t(0), Last - 1, Last);
    else if (Last % 2 == 0)
      Visit(Last - 2, Last - 1, Last);
    else
      Visit(Last - 1, Last - 2, Last);
  }
}

static bool isDegenerate(const Triangle &Shape) {
  const Vector3 Normal = cross(Shape.Vertices[1] - Shape.Vertices[0],
                               Shape.Vertices[2] - Shape.Vertices[0]);
  const float LengthSquared = dot(Normal, Normal);
  return !(LengthSquared > 0 && std::isfinite(LengthSquared));
}

Status SceneBuilder::addPrimitive(const tinygltf::Primitive &Primitive,
                                  const Transform &ToWorld) {
  const int Mode =
      Primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : Primitive.mode;
  if (Mode != TINYGLTF_MODE_TRIANGLES && Mode != TINYGLTF_MODE_TRIANGLE_STRIP &&
      Mode != TINYGLTF_MODE_TRIANGLE_FAN) {
    warn("primitives that are points or lines are left out");
    return success();
  }
  const auto Attribute = Primitive.attributes.find("POSITION");
  if (Attribute == Primitive.attributes.end())
    return Error{"has no POSITION attribute"};
  const ErrorOr<std::vector<Vector3>> Positions =
      readPositions(Model, Attribute->second);
  if (!Positions)
    return inside("POSITION", Positions.message());
  std::vector<uint32_t> Indices;
  if (Primitive.indices >= 0) {
    ErrorOr<std::vector<uint32_t>> Read =
        readIndices(Model, Primitive.indices, Positions->size());
    if (!Read)
      return inside("indices", Read.message());
    Indices = std::move(*Read);
  }
  const ErrorOr<uint32_t> MaterialIndex = materialIndex(Primitive.material);
  if (!MaterialIndex)
    return Error{MaterialIndex.message()};

  const bool Indexed = Primitive.indices >= 0;
  const size_t Count = Indexed ? Indices.size() : Positions->size();
  if (Mode == TINYGLTF_MODE_TRIANGLES && Count % 3 != 0)
    return Error{std::to_string(Count) +
                 " vertices do not make whole triangles"};
  const bool Mirrored = ToWorld.determinant() < 0;
  bool Finite = true;
  bool InReach = true;
  forEachTriangle(Mode, Count, [&](size_t A, size_t B, size_t C) {
    const size_t Corners[3] = {A, Mirrored ? C : B, Mirrored ? B : C};
    Triangle Shape;
    Shape.Material = *MaterialIndex;
    for (int Corner = 0; Corner != 3; ++Corner) {
      const size_t Vertex =
          Indexed ? Indices[Corners[Corner]] : Corners[Corner];
      Shape.Vertices[Corner] = ToWorld.point((*Positions)[Vertex]);
      Finite &= isFinite(Shape.Vertices[Corner]);
      InReach &= isInReach(Shape.Vertices[Corner]);
    }
    if (isDegenerate(Shape))
      ++DegenerateTriangles;
    else
      Result.Triangles.push_back(Shape);
  });
  if (!Finite)
    return Error{"a position is not finite after its node's transform"};
  if (!InReach)
    return Error{"a coordinate is beyond 1e18 after its node's transform; "
                 "choose a larger unit of length"};
  if (Result.Triangles.size() > kMaxBvhTriangles)
    return Error{"the scene has more than " + std::to_string(kMaxBvhTriangles) +
                 " triangles"};
  return success();
}

Status SceneBuilder::addMesh(int Index, const Transform &ToWorld) {
  if (size_t(Index) >= Model.meshes.size())
    return Error{"has no mesh " + std::to_string(Index)};
  const tinygltf::Mesh &Mesh = Model.meshes[Index];
  for (size_t Part = 0; Part != Mesh.primitives.size(); ++Part) {
    Status Added = addPrimitive(Mesh.primitives[Part], ToWorld);
    if (!Added)
      return inside(describe("mesh", Index, Mesh.name) + ", primitive " +
                        std::to_string(Part),
                    Added.message());
  }
  return success();
}

/// A unit vector, or nothing for a vector without a direction.
static std::optional<Transform::Column> normalized(Transform::Column V) {
  const double Length = std::sqrt(V[0] * V[0] + V[1] * V[1] + V[2] * V[2]);
  if (!(Length > 0 && std::isfinite(Length)))
    return std::nullopt;
  return Transform::Column{V[0] / Length, V[1] / Length, V[2] / Length};
}

static Vector3 toVector3(const Transform::Column &V) {
  return {float(V[0]), float(V[1]), float(V[2])};
}

static double dotProduct(const Transform::Column &A,
                         const Transform::Column &B) {
  return A[0] * B[0] + A[1] * B[1] + A[2] * B[2];
}

Status SceneBuilder::addCamera(int Index, const Transform &ToWorld) {
  if (FoundCamera)
    return success();
  if (size_t(Index) >= Model.cameras.size())
    return Error{"has no camera " + std::to_string(Index)};
  const tinygltf::Camera &Source = Model.cameras[Index];
  const std::string Element = describe("camera", Index, Source.name);
  if (Source.type != "perspective") {
    warn(Element + ": only perspective cameras are supported");
    return success();
  }
  if (!(Source.perspective.yfov > 0 && Source.perspective.yfov < M_PI))
    return inside(Element, "yfov is not between 0 and pi");

  // The camera looks along its node's -Z with +Y up; a scale of the node does
  // not matter.
  const auto Forward = normalized(ToWorld.direction({0, 0, -1}));
  Transform::Column Up = ToWorld.direction({0, 1, 0});
  if (!Forward)
    return inside(Element, "its node's transform has no direction");
  const double Along = dotProduct(Up, *Forward);
  for (int Axis = 0; Axis != 3; ++Axis)
    Up[Axis] -= Along * (*Forward)[Axis];
  const auto UnitUp = normalized(Up);
  if (!UnitUp)
    return inside(Element, "its node's transform has no up direction");

  Camera Target;
  Target.Position = ToWorld.point({0, 0, 0});
  Target.Forward = toVector3(*Forward);
  Target.Up = toVector3(*UnitUp);
  Target.Right =
      toVector3({(*Forward)[1] * (*UnitUp)[2] - (*Forward)[2] * (*UnitUp)[1],
                 (*Forward)[2] * (*UnitUp)[0] - (*Forward)[0] * (*UnitUp)[2],
                 (*Forward)[0] * (*UnitUp)[1] - (*Forward)[1] * (*UnitUp)[0]});
  Target.VerticalFieldOfView = float(Source.perspective.yfov);
  if (!isFinite(Target.Position))
    return inside(Element, "its position is not finite");
  FoundCamera = Target;
  return success();
}

static ErrorOr<Transform> readMatrix(const std::vector<double> &Matrix) {
  if (Matrix.size() != 16)
    return Error{"its matrix does not have 16 elements"};
  if (Matrix[3] != 0 || Matrix[7] != 0 || Matrix[11] != 0 || Matrix[15] != 1)
    return Error{"its matrix is not affine"};
  Transform Result;
  for (int Column = 0; Column != 4; ++Column)
    for (int Row = 0; Row != 3; ++Row)
      Result.Columns[Column][Row] = Matrix[Column * 4 + Row];
  return Result;
}

static ErrorOr<Transform>
readTranslationRotationScale(const tinygltf::Node &Node) {
  if ((!Node.translation.empty() && Node.translation.size() != 3) ||
      (!Node.rotation.empty() && Node.rotation.size() != 4) ||
      (!Node.scale.empty() && Node.scale.size() != 3))
    return Error{"its translation, rotation or scale has a wrong length"};
  Transform Result;
  if (!Node.rotation.empty()) {
    double Length = 0;
    for (double Component : Node.rotation)
      Length += Component * Component;
    Length = std::sqrt(Length);
    if (!(std::abs(Length - 1) < 1e-3))
      return Error{"its rotation is not a unit quaternion"};
    const double X = Node.rotation[0] / Length, Y = Node.rotation[1] / Length,
                 Z = Node.rotation[2] / Length, W = Node.rotation[3] / Length;
    Result.Columns[0] = {1 - 2 * (Y * Y + Z * Z), 2 * (X * Y + Z * W),
                         2 * (X * Z - Y * W)};
    Result.Columns[1] = {2 * (X * Y - Z * W), 1 - 2 * (X * X + Z * Z),
                         2 * (Y * Z + X * W)};
    Result.Columns[2] = {2 * (X * Z + Y * W), 2 * (Y * Z - X * W),
                         1 - 2 * (X * X + Y * Y)};
  }
  if (!Node.scale.empty())
    for (int Column = 0; Column != 3; ++Column)
      for (double &Component : Result.Columns[Column])
        Component *= Node.scale[Column];
  if (!Node.translation.empty())
    Result.Columns[3] = {Node.translation[0], Node.translation[1],
                         Node.translation[2]};
  return Result;
}

ErrorOr<Transform> SceneBuilder::readTransform(const tinygltf::Node &Node) {
  return Node.matrix.empty() ? readTranslationRotationScale(Node)
                             : readMatrix(Node.matrix);
}

ErrorOr<std::vector<int>> SceneBuilder::findRoots() {
  if (!Model.scenes.empty()) {
    const int Chosen = std::max(Model.defaultScene, 0);
    if (size_t(Chosen) >= Model.scenes.size())
      return Error{"has no scene " + std::to_string(Chosen)};
    return Model.scenes[Chosen].nodes;
  }
  std::set<int> Children;
  for (const tinygltf::Node &Node : Model.nodes)
    Children.insert(Node.children.begin(), Node.children.end());
  std::vector<int> Roots;
  for (size_t Index = 0; Index != Model.nodes.size(); ++Index)
    if (!Children.count(int(Index)))
      Roots.push_back(int(Index));
  return Roots;
}

Status SceneBuilder::visit(const std::vector<int> &Roots) {
  struct PendingNode {
    int Index;
    Transform ParentToWorld;
  };
  std::vector<PendingNode> Pending;
  for (auto Root = Roots.rbegin(); Root != Roots.rend(); ++Root)
    Pending.push_back({*Root, Transform()});
  std::vector<bool> Visited(Model.nodes.size());
  while (!Pending.empty()) {
    const PendingNode Current = Pending.back();
    Pending.pop_back();
    if (Current.Index < 0 || size_t(Current.Index) >= Model.nodes.size())
      return Error{"has no node " + std::to_string(Current.Index)};
    const tinygltf::Node &Node = Model.nodes[Current.Index];
    const std::string Element = describe("node", Current.Index, Node.name);
    if (Visited[Current.Index])
      return inside(Element, "is reached twice; nodes must form trees");
    Visited[Current.Index] = true;

    const ErrorOr<Transform> Local = readTransform(Node);
    if (!Local)
      return inside(Element, Local.message());
    const Transform ToWorld = Current.ParentToWorld.after(*Local);
    if (Node.camera >= 0)
      if (Status Added = addCamera(Node.camera, ToWorld); !Added)
        return inside(Element, Added.message());
    if (Node.mesh >= 0)
      if (Status Added = addMesh(Node.mesh, ToWorld); !Added)
        return inside(Element, Added.message());
    if (Node.skin >= 0)
      warn(Element + ": skins are left out");
    for (auto Child = Node.children.rbegin(); Child != Node.children.rend();
         ++Child)
      Pending.push_back({*Child, ToWorld});
  }
  return success();
}

ErrorOr<Scene> SceneBuilder::build() {
  for (const std::string &Extension : Model.extensionsRequired)
    if (Extension != "KHR_materials_emissive_strength")
      return Error{"requires the extension " + Extension +
                   ", which is not supported"};
  if (Status Read = readMaterials(); !Read)
    return Read.takeError();
  const ErrorOr<std::vector<int>> Roots = findRoots();
  if (!Roots)
    return Error{Roots.message()};
  if (Status Visited = visit(*Roots); !Visited)
    return Visited.takeError();
  if (DegenerateTriangles != 0)
    warn(std::to_string(DegenerateTriangles) +
         " triangles without area are left out");
  if (Result.Triangles.empty())
    return Error{"the scene has no triangles"};
  if (!FoundCamera)
    return Error{"the scene has no perspective camera; add a node with one"};
  Result.Camera = *FoundCamera;
  return std::move(Result);
}

ErrorOr<Scene> loadScene(const std::string &Path) {
  const ErrorOr<tinygltf::Model> Model = readGltf(Path);
  if (!Model)
    return Error{Model.message()};
  ErrorOr<Scene> Result = SceneBuilder(*Model).build();
  if (!Result)
    return inside(Path, Result.message());
  return Result;
}

} // namespace tp
