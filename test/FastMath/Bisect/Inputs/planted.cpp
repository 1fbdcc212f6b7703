//===- planted.cpp - A small renderer with hazards to plant ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Builds a BVH over a tiled room, shades it, sorts a hull by angle and marches
// through a medium, then checks its own results: the exit status is the number
// of checks that failed. -DPLANT_H1 to -DPLANT_H4 put in one hazard each, which
// is harmless in IEEE arithmetic.
//
//===----------------------------------------------------------------------===//

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace {

//===----------------------------------------------------------------------===//
// Vectors, boxes, random numbers
//===----------------------------------------------------------------------===//

struct Vec3 {
  float x = 0, y = 0, z = 0;

  float operator[](int axis) const {
    return axis == 0 ? x : axis == 1 ? y : z;
  }
};

Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec3 operator*(Vec3 a, float s) { return {a.x * s, a.y * s, a.z * s}; }
Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

float dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
          a.x * b.y - a.y * b.x};
}

Vec3 normalize(Vec3 v) {
  float length = std::sqrt(dot(v, v));
  return length > 0 ? v * (1.0f / length) : v;
}

constexpr float Far = 1e30f;

struct Box {
  Vec3 lo{Far, Far, Far};
  Vec3 hi{-Far, -Far, -Far};

  void grow(Vec3 p) {
    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
  }

  void grow(const Box &other) {
    lo = {std::min(lo.x, other.lo.x), std::min(lo.y, other.lo.y),
          std::min(lo.z, other.lo.z)};
    hi = {std::max(hi.x, other.hi.x), std::max(hi.y, other.hi.y),
          std::max(hi.z, other.hi.z)};
  }

  Vec3 center() const { return (lo + hi) * 0.5f; }

  float halfArea() const {
    Vec3 d = hi - lo;
    return d.x < 0 ? 0 : d.x * d.y + d.y * d.z + d.z * d.x;
  }

  bool contains(const Box &other) const {
    return lo.x <= other.lo.x && lo.y <= other.lo.y && lo.z <= other.lo.z &&
           hi.x >= other.hi.x && hi.y >= other.hi.y && hi.z >= other.hi.z;
  }
};

class Random {
public:
  explicit Random(uint32_t seed) : state(seed) {}

  float next() {
    state = state * 1664525u + 1013904223u;
    return float(state >> 8) * (1.0f / 16777216.0f);
  }

private:
  uint32_t state;
};

//===----------------------------------------------------------------------===//
// The scene: a tiled floor and ceiling, a wall with slats, some pebbles
//===----------------------------------------------------------------------===//

struct Triangle {
  Vec3 a, b, c;

  Box bounds() const {
    Box box;
    box.grow(a);
    box.grow(b);
    box.grow(c);
    return box;
  }

  Vec3 normal() const { return normalize(cross(b - a, c - a)); }
};

using Mesh = std::vector<Triangle>;

void addQuad(Mesh &mesh, Vec3 corner, Vec3 u, Vec3 v) {
  mesh.push_back({corner, corner + u, corner + u + v});
  mesh.push_back({corner, corner + u + v, corner + v});
}

void addTiles(Mesh &mesh, float height, int columns, int rows, float size) {
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j)
      addQuad(mesh, {-1.2f + size * i, height, -0.8f + size * j}, {0, 0, size},
              {size, 0, 0});
}

void addSlats(Mesh &mesh, int slats, float pitch) {
  for (int i = 0; i < slats; ++i)
    addQuad(mesh, {-1.1f, 0.3f + pitch * i, 1.9f}, {1.5f, 0, 0},
            {0, 0.004f, 0.015f});
}

void addPebbles(Mesh &mesh, int pebbles, Random &random) {
  for (int i = 0; i < pebbles; ++i) {
    Vec3 base{random.next() * 2 - 1, random.next() * 0.2f, random.next() * 2};
    Vec3 side{0.03f + 0.02f * random.next(), 0, 0.01f};
    Vec3 up{0.01f, 0.05f * random.next() + 0.01f, 0};
    mesh.push_back({base, base + side, base + up});
  }
}

Mesh makeRoom() {
  Mesh mesh;
  Random random(11);
  addTiles(mesh, 0, 17, 17, 0.11f);
  addTiles(mesh, 2, 29, 9, 0.12f);
  addSlats(mesh, 40, 0.02f);
  addPebbles(mesh, 60, random);
  return mesh;
}

//===----------------------------------------------------------------------===//
// Bounding volume hierarchy, by binned surface area heuristic
//===----------------------------------------------------------------------===//

constexpr int BinCount = 16;
constexpr int LeafSize = 2;
constexpr int MaxDepth = 40;

struct Primitive {
  Box bounds;
  Vec3 center;
  int triangle = 0;
};

struct Node {
  Box bounds;
  int begin = 0;
  int end = 0;
  int left = -1;
  int right = -1;

  bool isLeaf() const { return left < 0; }
};

struct Bin {
  Box bounds;
  int count = 0;
};

struct Split {
  int axis = -1;
  int bin = 0;
  int leftCount = 0;
  float lo = 0;
  float hi = 0;
  float cost = Far;
};

// The bin of a center between lo and hi.
int binOf(float center, float lo, float hi) {
#if defined(PLANT_H1)
  int bin = int(BinCount * ((center - lo) / (hi - lo)));
  return std::clamp(bin, 0, BinCount - 1);
#else
  double width = double(hi) - double(lo);
  int bin = int(BinCount * ((double(center) - double(lo)) / width));
  return std::clamp(bin, 0, BinCount - 1);
#endif
}

class Builder {
public:
  explicit Builder(const Mesh &mesh) {
    for (const Triangle &triangle : mesh) {
      Box bounds = triangle.bounds();
      primitives.push_back({bounds, bounds.center(), int(primitives.size())});
    }
    build(0, int(primitives.size()), 0);
  }

  std::vector<Primitive> primitives;
  std::vector<Node> nodes;

private:
  int build(int begin, int end, int depth);
  void fillBins(Bin *bins, int begin, int end, int axis, float lo, float hi);
  Split bestOfAxis(const Bin *bins, int axis, float lo, float hi) const;
  void partition(int begin, int end, const Split &split);
};

__attribute__((noinline)) void Builder::fillBins(Bin *bins, int begin, int end,
                                                 int axis, float lo, float hi) {
  for (int i = begin; i < end; ++i) {
    const Primitive &primitive = primitives[i];
    Bin &target = bins[binOf(primitive.center[axis], lo, hi)];
    ++target.count;
    target.bounds.grow(primitive.bounds);
  }
}

Split Builder::bestOfAxis(const Bin *bins, int axis, float lo,
                          float hi) const {
  float rightArea[BinCount];
  int rightCount[BinCount];
  Box right;
  int count = 0;
  for (int bin = BinCount - 1; bin > 0; --bin) {
    right.grow(bins[bin].bounds);
    count += bins[bin].count;
    rightArea[bin] = right.halfArea();
    rightCount[bin] = count;
  }
  Split best;
  Box left;
  count = 0;
  for (int bin = 1; bin < BinCount; ++bin) {
    left.grow(bins[bin - 1].bounds);
    count += bins[bin - 1].count;
    if (!count || !rightCount[bin])
      continue;
    float cost = left.halfArea() * count + rightArea[bin] * rightCount[bin];
    if (cost < best.cost)
      best = {axis, bin, count, lo, hi, cost};
  }
  return best;
}

// A predicate of its own, as those of std::partition are where they are not
// inlined.
__attribute__((noinline)) bool goesLeft(const Primitive &primitive,
                                        const Split &split) {
  return binOf(primitive.center[split.axis], split.lo, split.hi) < split.bin;
}

// Places the primitives where the counts of the bins say they belong.
void Builder::partition(int begin, int end, const Split &split) {
  std::vector<Primitive> sorted(primitives.begin() + begin,
                                primitives.begin() + end);
  int left = 0, right = split.leftCount;
  for (int i = begin; i < end; ++i) {
    int &target = goesLeft(primitives[i], split) ? left : right;
    if (target < end - begin)
      sorted[target] = primitives[i];
    ++target;
  }
  std::copy(sorted.begin(), sorted.end(), primitives.begin() + begin);
}

int Builder::build(int begin, int end, int depth) {
  int self = int(nodes.size());
  nodes.push_back({});
  Box bounds, centers;
  for (int i = begin; i < end; ++i) {
    bounds.grow(primitives[i].bounds);
    centers.grow(primitives[i].center);
  }
  nodes[self] = {bounds, begin, end, -1, -1};
  if (end - begin <= LeafSize || depth == MaxDepth)
    return self;
  Split best;
  for (int axis = 0; axis < 3; ++axis) {
    float lo = centers.lo[axis], hi = centers.hi[axis];
    if (!(hi > lo))
      continue;
    Bin bins[BinCount];
    fillBins(bins, begin, end, axis, lo, hi);
    Split split = bestOfAxis(bins, axis, lo, hi);
    if (split.cost < best.cost)
      best = split;
  }
  if (best.axis < 0)
    return self;
  partition(begin, end, best);
  int middle = begin + best.leftCount;
  int left = build(begin, middle, depth + 1);
  int right = build(middle, end, depth + 1);
  nodes[self].left = left;
  nodes[self].right = right;
  return self;
}

//===----------------------------------------------------------------------===//
// Rays
//===----------------------------------------------------------------------===//

struct Ray {
  Vec3 origin, direction, inverse;
};

struct Hit {
  float distance = Far;
  int triangle = -1;
};

Ray makeRay(Vec3 origin, Vec3 direction) {
  auto invert = [](float d) {
    return 1.0f / (std::fabs(d) < 1e-12f ? 1e-12f : d);
  };
  return {origin,
          direction,
          {invert(direction.x), invert(direction.y), invert(direction.z)}};
}

bool meets(const Box &box, const Ray &ray, float limit) {
  Vec3 t0 = (box.lo - ray.origin) * ray.inverse;
  Vec3 t1 = (box.hi - ray.origin) * ray.inverse;
  float enter = std::max({std::min(t0.x, t1.x), std::min(t0.y, t1.y),
                          std::min(t0.z, t1.z), 0.0f});
  float leave = std::min({std::max(t0.x, t1.x), std::max(t0.y, t1.y),
                          std::max(t0.z, t1.z), limit});
  return enter <= leave * 1.00001f + 1e-6f;
}

void intersect(const Triangle &triangle, const Ray &ray, int index, Hit &hit) {
  Vec3 u = triangle.b - triangle.a, v = triangle.c - triangle.a;
  Vec3 p = cross(ray.direction, v);
  float determinant = dot(u, p);
  if (std::fabs(determinant) < 1e-12f)
    return;
  float scale = 1.0f / determinant;
  Vec3 s = ray.origin - triangle.a;
  float b = dot(s, p) * scale;
  Vec3 q = cross(s, u);
  float c = dot(ray.direction, q) * scale;
  float distance = dot(v, q) * scale;
  if (b >= 0 && c >= 0 && b + c <= 1 && distance > 1e-4f &&
      distance < hit.distance)
    hit = {distance, index};
}

class Tracer {
public:
  Tracer(const Mesh &mesh, const Builder &tree) : mesh(mesh), tree(tree) {}

  Hit trace(const Ray &ray) const {
    Hit hit;
    int stack[2 * MaxDepth];
    int depth = 0;
    stack[depth++] = 0;
    while (depth) {
      const Node &node = tree.nodes[stack[--depth]];
      if (!meets(node.bounds, ray, hit.distance))
        continue;
      if (!node.isLeaf()) {
        stack[depth++] = node.left;
        stack[depth++] = node.right;
        continue;
      }
      for (int i = node.begin; i < node.end; ++i) {
        int index = tree.primitives[i].triangle;
        intersect(mesh[index], ray, index, hit);
      }
    }
    return hit;
  }

private:
  const Mesh &mesh;
  const Builder &tree;
};

//===----------------------------------------------------------------------===//
// Shading
//===----------------------------------------------------------------------===//

struct Material {
  Vec3 color;
  float gloss = 0;
};

Material materialOf(const Triangle &triangle) {
  if (triangle.a.y == 0)
    return {{0.7f, 0.6f, 0.5f}, 0.1f};
  return triangle.a.z > 1.8f ? Material{{0.8f, 0.8f, 0.9f}, 0.4f}
                             : Material{{0.3f, 0.3f, 0.3f}, 0.2f};
}

float fresnel(float cosine, float reflectance) {
  float m = std::max(0.0f, 1 - cosine);
  return reflectance + (1 - reflectance) * (m * m * m * m * m);
}

float toneMap(float x) {
  x = std::max(0.0f, x - 0.004f);
  return (x * (6.2f * x + 0.5f)) / (x * (6.2f * x + 1.7f) + 0.06f);
}

Vec3 shade(const Triangle &triangle, Vec3 point, Vec3 toEye, Vec3 light) {
  Material material = materialOf(triangle);
  Vec3 normal = triangle.normal();
  if (dot(normal, toEye) < 0)
    normal = normal * -1.0f;
  Vec3 toLight = light - point;
  float squared = dot(toLight, toLight);
  toLight = normalize(toLight);
  float diffuse = std::max(0.0f, dot(normal, toLight));
  Vec3 half = normalize(toLight + toEye);
  float highlight = std::max(0.0f, dot(normal, half));
  for (int i = 0; i < 4; ++i)
    highlight *= highlight;
  float gloss = fresnel(std::max(0.0f, dot(half, toEye)), material.gloss);
  float falloff = 4.0f / (0.5f + squared);
  return (material.color * diffuse + Vec3{1, 1, 1} * (gloss * highlight)) *
         falloff;
}

int renderRow(const Tracer &tracer, const Mesh &mesh, int width, int row,
              std::vector<float> &image) {
  int hits = 0;
  Vec3 eye{0, 0.8f, -2};
  for (int column = 0; column < width; ++column) {
    float u = (column + 0.5f) / width - 0.5f, v = 0.5f - (row + 0.5f) / width;
    Vec3 direction = normalize({u, v - 0.25f, 1});
    Hit hit = tracer.trace(makeRay(eye, direction));
    if (hit.triangle < 0) {
      image.push_back(0);
      continue;
    }
    ++hits;
    Vec3 point = eye + direction * hit.distance;
    Vec3 color =
        shade(mesh[hit.triangle], point, direction * -1.0f, {0.5f, 2, 0});
    image.push_back(toneMap(dot(color, {0.2126f, 0.7152f, 0.0722f})));
  }
  return hits;
}

//===----------------------------------------------------------------------===//
// Histogram of a highlight
//===----------------------------------------------------------------------===//

constexpr int LevelCount = 16;

// The level of a value from 0 to below the brightest.
int levelOf(float value, float brightest) {
#if defined(PLANT_H2)
  return int(LevelCount * (value / brightest));
#else
  return std::min(int(LevelCount * (value / brightest)), LevelCount - 1);
#endif
}

struct Histogram {
  int levels[LevelCount] = {};
  int outside = 0;
};

__attribute__((noinline)) void fill(Histogram &histogram,
                                    const std::vector<float> &values,
                                    float brightest) {
  for (float value : values) {
    int level = levelOf(value, brightest);
    if (level < LevelCount)
      ++histogram.levels[level];
    else
      ++histogram.outside;
  }
}

// The float next below a positive one.
float below(float value) {
  uint32_t bits;
  __builtin_memcpy(&bits, &value, sizeof(bits));
  --bits;
  __builtin_memcpy(&value, &bits, sizeof(bits));
  return value;
}

// Values that approach the brightest one in the smallest steps.
std::vector<float> makeHighlight(float brightest, int count) {
  std::vector<float> values;
  float value = brightest;
  for (int i = 0; i < count; ++i) {
    value = below(value);
    values.push_back(value);
  }
  return values;
}

//===----------------------------------------------------------------------===//
// Angular order of a hull
//===----------------------------------------------------------------------===//

struct Corner {
  float x, y;
  int id;
};

// Whether a comes before b, counter-clockwise.
__attribute__((noinline)) bool before(const Corner &a, const Corner &b) {
#if defined(PLANT_H3)
  return a.x * b.y - a.y * b.x > 0;
#else
  return double(a.x) * b.y > double(a.y) * b.x;
#endif
}

using Order = bool (*)(const Corner &, const Corner &);

std::vector<Corner> makeHull(int corners) {
  std::vector<Corner> hull;
  Random random(23);
  for (int i = 0; i < corners; ++i)
    hull.push_back({0.1f + random.next(), 0.1f + random.next(), i});
  return hull;
}

void insertionSort(std::vector<Corner> &corners, Order order) {
  for (size_t i = 1; i < corners.size(); ++i)
    for (size_t j = i; j > 0 && order(corners[j], corners[j - 1]); --j)
      std::swap(corners[j], corners[j - 1]);
}

// Pairs for which the order says both "before" and "behind".
int contradictions(const std::vector<Corner> &corners, Order order) {
  int found = 0;
  for (const Corner &a : corners)
    for (float scale : {1.0f, 2.0f, 4.0f}) {
      Corner b{a.x * scale, a.y * scale, a.id};
      found += order(a, b) && order(b, a);
    }
  return found;
}

//===----------------------------------------------------------------------===//
// Marching through a medium
//===----------------------------------------------------------------------===//

// How far a step from t really leads in rounded arithmetic.
__attribute__((noinline)) float realStep(float t, float step) {
#if defined(PLANT_H4)
  return (t + step) - t;
#else
  return t < Far ? std::min(t + step, Far) - t : 0;
#endif
}

// Marches from begin until the density is used up; the steps it took. A step
// that leads nowhere ends the march: there is nothing behind infinity.
int march(float begin, float density, int limit) {
  float t = begin, through = 1;
  for (int steps = 0; steps < limit; ++steps) {
    float step = realStep(t, 0.05f);
    if (!(step > 0) || through < 0.01f)
      return steps;
    through *= 1 - density * step;
    t += step;
  }
  return limit;
}

//===----------------------------------------------------------------------===//
// The program
//===----------------------------------------------------------------------===//

int check(const char *what, bool isRight) {
  if (!isRight)
    std::printf("wrong: %s\n", what);
  return !isRight;
}

int checkTree(const Mesh &mesh, const Builder &tree) {
  std::vector<int> seen(mesh.size());
  for (const Primitive &primitive : tree.primitives)
    ++seen[primitive.triangle];
  bool isPermutation =
      std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; });
  bool isNested = true;
  for (const Node &node : tree.nodes)
    if (!node.isLeaf())
      isNested &= node.bounds.contains(tree.nodes[node.left].bounds) &&
                  node.bounds.contains(tree.nodes[node.right].bounds);
  return check("a triangle is missing from the tree", isPermutation) +
         check("a child lies outside of its parent", isNested);
}

int checkImage(const Mesh &mesh, const Builder &tree) {
  Tracer tracer(mesh, tree);
  std::vector<float> image;
  int hits = 0;
  constexpr int Size = 12;
  for (int row = 0; row < Size; ++row)
    hits += renderRow(tracer, mesh, Size, row, image);
  bool isInRange = std::all_of(image.begin(), image.end(), [](float value) {
    return value >= 0 && value <= 1;
  });
  return check("the picture is empty", hits > Size) +
         check("a pixel is out of range", isInRange);
}

int checkHistogram() {
  Histogram histogram;
  for (int i = 1; i <= 20; ++i) {
    float brightest = 0.37f * i;
    fill(histogram, makeHighlight(brightest, 8), brightest);
  }
  return check("a value below the brightest has no level",
               histogram.outside == 0);
}

int checkHull() {
  std::vector<Corner> hull = makeHull(60);
  insertionSort(hull, before);
  bool isSorted = true;
  for (size_t i = 1; i < hull.size(); ++i)
    isSorted &= double(hull[i - 1].y) / hull[i - 1].x <=
                double(hull[i].y) / hull[i].x + 1e-5;
  return check("the hull is not in order", isSorted) +
         check("a corner comes before itself",
               contradictions(hull, before) == 0);
}

int checkMarch(float infinity) {
  return check("the march inside the medium ends early",
               march(0.25f, 0.9f, 400) > 50) +
         check("the march goes on at infinity", march(infinity, 0.9f, 400) == 0);
}

} // namespace

int main() {
  Mesh mesh = makeRoom();
  Builder tree(mesh);
  volatile uint32_t infinityBits = 0x7f800000;
  uint32_t bits = infinityBits;
  float infinity;
  __builtin_memcpy(&infinity, &bits, sizeof(infinity));
  int wrong = checkTree(mesh, tree) + checkImage(mesh, tree) +
              checkHistogram() + checkHull() + checkMarch(infinity);
  std::printf("%zu triangles, %zu nodes, %d wrong\n", mesh.size(),
              tree.nodes.size(), wrong);
  return wrong;
}
