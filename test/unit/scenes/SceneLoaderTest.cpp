//===- SceneLoaderTest.cpp - What the loader accepts and refuses ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "scenes/loader/SceneLoader.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>

using namespace tp;

namespace {

/// A glTF text with one triangle, a camera and all that they need. Tests change
/// a part of it and look at what the loader says.
class SceneLoaderTest : public testing::Test {
protected:
  SceneLoaderTest() {
    Positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    Indices = {0, 1, 2, 2, 1, 0};
  }
  ~SceneLoaderTest() override { std::remove(Path.c_str()); }

  ErrorOr<Scene> load() {
    std::ofstream(Path, std::ios::binary) << text();
    return loadScene(Path);
  }

  /// Loads, and returns the message behind the path.
  std::string failure() {
    const ErrorOr<Scene> Loaded = load();
    if (Loaded)
      return "no failure";
    const std::string Prefix = Path + ": ";
    EXPECT_EQ(Loaded.message().substr(0, Prefix.size()), Prefix);
    EXPECT_EQ(Loaded.message().find('\n'), std::string::npos);
    return Loaded.message().substr(
        std::min(Prefix.size(), Loaded.message().size()));
  }

  std::string text() const {
    return R"({"asset": {"version": "2.0"}, )" + Extra +
           R"("scenes": [{"nodes": [)" + Roots + R"(]}], "nodes": [)" + Nodes +
           R"(], "meshes": [{"name": "shape", "primitives": [)" + Primitive +
           R"(]}], "cameras": [)" + Camera + R"(], "materials": [)" + Material +
           R"(], "accessors": [)" + PositionAccessor + ", " + IndexAccessor +
           R"(], "bufferViews": [{"buffer": 0, "byteLength": 36},
              {"buffer": 0, "byteOffset": 36, "byteLength": 12}],
              "buffers": [{"byteLength": 48, "uri": ")" +
           (BufferUri.empty() ? dataUri() : BufferUri) + R"("}]})";
  }

  std::string Roots = "0, 1";
  std::string Nodes = R"({"name": "thing", "mesh": 0}, {"camera": 0})";
  std::string Primitive =
      R"({"attributes": {"POSITION": 0}, "indices": 1, "material": 0})";
  std::string Camera =
      R"({"type": "perspective", "perspective": {"yfov": 1, "znear": 1}})";
  std::string Material = R"({"name": "paint"})";
  std::string PositionAccessor =
      R"({"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"})";
  std::string IndexAccessor =
      R"({"bufferView": 1, "componentType": 5123, "count": 6,
          "type": "SCALAR"})";
  std::string Extra;
  std::string BufferUri;
  std::vector<Vector3> Positions;
  std::vector<uint16_t> Indices;
  std::string Path = testing::TempDir() + "tp-scene-loader-test.gltf";

private:
  std::string dataUri() const {
    std::string Bytes(48, '\0');
    std::memcpy(Bytes.data(), Positions.data(), 36);
    std::memcpy(Bytes.data() + 36, Indices.data(), 12);
    const char *Digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                         "0123456789+/";
    std::string Text = "data:application/octet-stream;base64,";
    for (size_t At = 0; At != Bytes.size(); At += 3) {
      const uint32_t Three = uint32_t(uint8_t(Bytes[At])) << 16 |
                             uint32_t(uint8_t(Bytes[At + 1])) << 8 |
                             uint8_t(Bytes[At + 2]);
      for (int Shift = 18; Shift >= 0; Shift -= 6)
        Text += Digits[Three >> Shift & 63];
    }
    return Text;
  }
};

} // namespace

TEST_F(SceneLoaderTest, ReadsTheSimplestScene) {
  const ErrorOr<Scene> Loaded = load();
  ASSERT_TRUE(Loaded) << Loaded.message();
  ASSERT_EQ(Loaded->Triangles.size(), 2u);
  EXPECT_EQ(Loaded->Triangles[0].Vertices[1].X, 1);
  EXPECT_EQ(Loaded->Triangles[1].Vertices[0].Y, 1);
  EXPECT_EQ(Loaded->Materials[Loaded->Triangles[0].Material].Name, "paint");
  EXPECT_EQ(Loaded->Camera.VerticalFieldOfView, 1);
}

TEST_F(SceneLoaderTest, ReadsBaseColorAndEmissionStrength) {
  Material = R"({"emissiveFactor": [1, 0.5, 0.25],
    "pbrMetallicRoughness": {"baseColorFactor": [0.25, 0.5, 0.75, 1]},
    "extensions": {"KHR_materials_emissive_strength":
                   {"emissiveStrength": 8}}})";
  const ErrorOr<Scene> Loaded = load();
  ASSERT_TRUE(Loaded) << Loaded.message();
  const tp::Material &Surface = Loaded->Materials[0];
  EXPECT_EQ(Surface.BaseColor.Z, 0.75f);
  EXPECT_EQ(Surface.Emission.X, 8);
  EXPECT_EQ(Surface.Emission.Z, 2);
  EXPECT_TRUE(Surface.isEmissive());
}

TEST_F(SceneLoaderTest, PrimitiveWithoutMaterialIsWhite) {
  Primitive = R"({"attributes": {"POSITION": 0}})";
  const ErrorOr<Scene> Loaded = load();
  ASSERT_TRUE(Loaded) << Loaded.message();
  const tp::Material &Surface =
      Loaded->Materials[Loaded->Triangles[0].Material];
  EXPECT_EQ(Surface.Name, "default");
  EXPECT_EQ(Surface.BaseColor.X, 1);
  EXPECT_FALSE(Surface.isEmissive());
}

TEST_F(SceneLoaderTest, ReadsEveryWidthOfIndex) {
  Indices = {0x0100, 0x0002, 0, 0, 0, 0};
  IndexAccessor = R"({"bufferView": 1, "componentType": 5121, "count": 3,
                      "type": "SCALAR"})";
  ErrorOr<Scene> Loaded = load();
  ASSERT_TRUE(Loaded) << Loaded.message();
  EXPECT_EQ(Loaded->Triangles[0].Vertices[1].X, 1);
  Indices = {0, 0, 1, 0, 2, 0};
  IndexAccessor = R"({"bufferView": 1, "componentType": 5125, "count": 3,
                      "type": "SCALAR"})";
  Loaded = load();
  ASSERT_TRUE(Loaded) << Loaded.message();
  EXPECT_EQ(Loaded->Triangles[0].Vertices[2].Y, 1);
}

TEST_F(SceneLoaderTest, ComposesTransformsFromTheRootDown) {
  Roots = "1, 2";
  Nodes = R"({"mesh": 0, "translation": [1, 0, 0]}, {"camera": 0},
             {"children": [0], "scale": [2, 2, 2], "translation": [0, 0, 5]})";
  const ErrorOr<Scene> Loaded = load();
  ASSERT_TRUE(Loaded) << Loaded.message();
  EXPECT_EQ(Loaded->Triangles[0].Vertices[0].X, 2);
  EXPECT_EQ(Loaded->Triangles[0].Vertices[0].Z, 5);
  EXPECT_EQ(Loaded->Triangles[0].Vertices[1].X, 4);
}

TEST_F(SceneLoaderTest, SkipsWhatHasNoAreaAndSaysSo) {
  Indices = {0, 1, 2, 0, 1, 1};
  const ErrorOr<Scene> Loaded = load();
  ASSERT_TRUE(Loaded) << Loaded.message();
  EXPECT_EQ(Loaded->Triangles.size(), 1u);
  ASSERT_EQ(Loaded->Warnings.size(), 1u);
  EXPECT_EQ(Loaded->Warnings[0], "1 triangles without area are left out");
}

TEST_F(SceneLoaderTest, WithoutScenesTakesTheRootNodes) {
  Roots = "";
  std::string Text = text();
  const std::string Scenes = R"("scenes": [{"nodes": []}], )";
  Text.erase(Text.find(Scenes), Scenes.size());
  std::ofstream(Path) << Text;
  const ErrorOr<Scene> Loaded = loadScene(Path);
  ASSERT_TRUE(Loaded) << Loaded.message();
  EXPECT_EQ(Loaded->Triangles.size(), 2u);
}

TEST_F(SceneLoaderTest, MissingFile) {
  const ErrorOr<Scene> Loaded = loadScene("/nonexistent-folder/a.gltf");
  ASSERT_FALSE(Loaded);
  EXPECT_EQ(Loaded.message(),
            "/nonexistent-folder/a.gltf: No such file or directory");
}

TEST_F(SceneLoaderTest, EmptyFileFolderAndText) {
  std::ofstream(Path) << "";
  EXPECT_FALSE(loadScene(Path));
  std::ofstream(Path) << "this is no JSON";
  EXPECT_FALSE(loadScene(Path));
  std::ofstream(Path) << "[1, 2, 3]";
  EXPECT_FALSE(loadScene(Path));
  EXPECT_FALSE(loadScene(testing::TempDir()));
}

TEST_F(SceneLoaderTest, MissingBufferFile) {
  BufferUri = "no-such-buffer.bin";
  EXPECT_NE(failure().find("no-such-buffer.bin"), std::string::npos);
}

TEST_F(SceneLoaderTest, ShortBuffer) {
  BufferUri = "data:application/octet-stream;base64,AAAA";
  EXPECT_NE(failure(), "no failure");
}

TEST_F(SceneLoaderTest, NoCamera) {
  Roots = "0";
  EXPECT_EQ(failure(),
            "the scene has no perspective camera; add a node with one");
}

TEST_F(SceneLoaderTest, OnlyAnOrthographicCamera) {
  Camera = R"({"type": "orthographic", "orthographic":
               {"xmag": 1, "ymag": 1, "zfar": 2, "znear": 1}})";
  EXPECT_EQ(failure(),
            "the scene has no perspective camera; add a node with one");
}

TEST_F(SceneLoaderTest, NoTriangles) {
  Roots = "1";
  EXPECT_EQ(failure(), "the scene has no triangles");
}

TEST_F(SceneLoaderTest, IndexBeyondTheVertices) {
  Indices[4] = 3;
  EXPECT_EQ(failure(), "node 0 \"thing\": mesh 0 \"shape\", primitive 0: "
                       "indices: accessor 1: element 4 is index 3, but there "
                       "are only 3 vertices");
}

TEST_F(SceneLoaderTest, SignedIndices) {
  IndexAccessor = R"({"bufferView": 1, "componentType": 5122, "count": 6,
                      "type": "SCALAR"})";
  EXPECT_NE(failure().find("indices must be SCALAR of an unsigned type"),
            std::string::npos);
}

TEST_F(SceneLoaderTest, IncompleteTriangle) {
  IndexAccessor = R"({"bufferView": 1, "componentType": 5123, "count": 5,
                      "type": "SCALAR"})";
  EXPECT_NE(failure().find("5 vertices do not make whole triangles"),
            std::string::npos);
}

TEST_F(SceneLoaderTest, AccessorBeyondItsView) {
  PositionAccessor =
      R"({"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"})";
  EXPECT_EQ(failure(), "node 0 \"thing\": mesh 0 \"shape\", primitive 0: "
                       "POSITION: accessor 0: 4 elements end beyond buffer "
                       "view 0, which has 36 bytes");
}

TEST_F(SceneLoaderTest, HugeAccessorDoesNotOverflow) {
  PositionAccessor = R"({"bufferView": 0, "componentType": 5126,
    "count": 1537228672809129302, "byteOffset": 12, "type": "VEC3"})";
  EXPECT_NE(failure(), "no failure");
}

TEST_F(SceneLoaderTest, AccessorThatDoesNotExist) {
  Primitive = R"({"attributes": {"POSITION": 7}, "indices": 1})";
  EXPECT_NE(failure().find("accessor 7: there are only 2 accessors"),
            std::string::npos);
}

TEST_F(SceneLoaderTest, PositionsOfAWrongType) {
  PositionAccessor =
      R"({"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC2"})";
  EXPECT_NE(failure().find("positions must be VEC3 of FLOAT"),
            std::string::npos);
}

TEST_F(SceneLoaderTest, PositionThatIsNotANumber) {
  Positions[2].Y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(failure().find("accessor 0: position 2 is not finite"),
            std::string::npos);
}

TEST_F(SceneLoaderTest, TransformThatOverflows) {
  Positions[1].X = 3e38f;
  Nodes = R"({"mesh": 0, "scale": [100, 1, 1]}, {"camera": 0})";
  EXPECT_NE(failure().find("not finite after its node's transform"),
            std::string::npos);
}

TEST_F(SceneLoaderTest, CoordinateThatIsTooLarge) {
  Nodes = R"({"mesh": 0, "translation": [0, -2e18, 0]}, {"camera": 0})";
  EXPECT_NE(failure().find("a coordinate is beyond 1e18 after its node's "
                           "transform; choose a larger unit of length"),
            std::string::npos);
}

TEST_F(SceneLoaderTest, MaterialMeshCameraOrNodeThatDoesNotExist) {
  Primitive = R"({"attributes": {"POSITION": 0}, "material": 5})";
  EXPECT_NE(failure().find("has no material 5"), std::string::npos);
  Nodes = R"({"mesh": 9}, {"camera": 0})";
  EXPECT_EQ(failure(), "node 0: has no mesh 9");
  Nodes = R"({"mesh": 0}, {"camera": 3})";
  Primitive = R"({"attributes": {"POSITION": 0}})";
  EXPECT_EQ(failure(), "node 1: has no camera 3");
  Roots = "0, 1, 12";
  Nodes = R"({"mesh": 0}, {"camera": 0})";
  EXPECT_EQ(failure(), "has no node 12");
  Extra = R"("scene": 4, )";
  EXPECT_NE(failure(), "no failure");
}

TEST_F(SceneLoaderTest, NodesThatAreNoTree) {
  Roots = "0";
  Nodes = R"({"children": [1]}, {"children": [0]})";
  EXPECT_EQ(failure(), "node 0: is reached twice; nodes must form trees");
}

TEST_F(SceneLoaderTest, BadTransform) {
  Nodes = R"({"mesh": 0, "rotation": [1, 1, 0, 0]}, {"camera": 0})";
  EXPECT_EQ(failure(), "node 0: its rotation is not a unit quaternion");
  Nodes = R"({"mesh": 0, "matrix": [1, 0, 0, 1, 0, 1, 0, 0,
                                    0, 0, 1, 0, 0, 0, 0, 1]}, {"camera": 0})";
  EXPECT_EQ(failure(), "node 0: its matrix is not affine");
}

TEST_F(SceneLoaderTest, BadMaterial) {
  Material = R"({"name": "odd", "pbrMetallicRoughness":
                 {"baseColorFactor": [2, 0, 0, 1]}})";
  EXPECT_EQ(failure(), "material 0 \"odd\": baseColorFactor is not between 0 "
                       "and 1");
  Material = R"({"emissiveFactor": [1, 1, 1], "extensions":
    {"KHR_materials_emissive_strength": {"emissiveStrength": -3}}})";
  EXPECT_EQ(failure(),
            "material 0: emissiveStrength is not a number of at least 0");
}

TEST_F(SceneLoaderTest, BadCamera) {
  Camera = R"({"type": "perspective", "perspective":
               {"yfov": 4, "znear": 1}})";
  EXPECT_EQ(failure(), "node 1: camera 0: yfov is not between 0 and pi");
}

TEST_F(SceneLoaderTest, UnknownRequiredExtension) {
  Extra = R"("extensionsRequired": ["KHR_draco_mesh_compression"], )";
  EXPECT_EQ(failure(), "requires the extension KHR_draco_mesh_compression, "
                       "which is not supported");
}
