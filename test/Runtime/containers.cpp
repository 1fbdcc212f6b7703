// std::map, std::set, std::list and the unordered containers, whose parts
// without element types are the runtime's own: random steps on the chip and on
// the host. Every tree stays red and black.
// RUN: %host_cxx -w -std=c++20 -O1 %s -o %t.host && %t.host > %t.expected
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf > %t.out
// RUN: diff %t.expected %t.out
// RUN: tpcc -O0 %s -o %t0.elf && tpsim --chip 1x1 --quiet %t0.elf > %t0.out
// RUN: diff %t.expected %t0.out

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

static uint32_t State = 1;

static uint32_t next(uint32_t Bound) {
  State = State * 1664525u + 1013904223u;
  return (State >> 8) % Bound;
}

using Node = std::_Rb_tree_node_base;

/// Black nodes down to every leaf, or -1 if the tree is not well-formed.
static int blackHeight(const Node *N, const Node *Parent) {
  if (!N)
    return 0;
  if (N->_M_parent != Parent)
    return -1;
  bool Red = N->_M_color == std::_S_red;
  for (const Node *Child : {N->_M_left, N->_M_right})
    if (Red && Child && Child->_M_color == std::_S_red)
      return -1;
  int Left = blackHeight(N->_M_left, N), Right = blackHeight(N->_M_right, N);
  return Left < 0 || Left != Right ? -1 : Left + !Red;
}

template <typename Tree> static bool isWellFormed(const Tree &T) {
  const Node *Header = T.end()._M_node;
  const Node *Root = Header->_M_parent;
  if (T.empty())
    return !Root && Header->_M_left == Header && Header->_M_right == Header;
  return Root->_M_color == std::_S_black && blackHeight(Root, Header) > 0 &&
         Header->_M_left == T.begin()._M_node &&
         static_cast<size_t>(std::distance(T.begin(), T.end())) == T.size();
}

static void testTrees() {
  std::map<int, int> Map;
  std::multiset<int> Multiset;
  int Wrong = 0;
  for (int Step = 0; Step != 400; ++Step) {
    int Key = static_cast<int>(next(60));
    // Grows, shrinks, and grows again.
    bool Add = next(10) < (Step / 100 % 2 == 0 ? 7u : 3u);
    if (Add) {
      Map[Key] += Step;
      Multiset.insert(Key);
    } else {
      Map.erase(Key);
      if (auto Place = Multiset.find(Key); Place != Multiset.end())
        Multiset.erase(Place);
    }
    Wrong += !isWellFormed(Map) + !isWellFormed(Multiset);
  }
  unsigned Sum = 0;
  for (auto [Key, Value] : Map)
    Sum = Sum * 31 + Key * 7 + Value;
  for (auto Place = Multiset.rbegin(); Place != Multiset.rend(); ++Place)
    Sum = Sum * 31 + *Place;
  auto Place = Map.lower_bound(30);
  std::printf("%d wrong, %zu %zu %u, %d\n", Wrong, Map.size(), Multiset.size(),
              Sum, Place == Map.end() ? -1 : Place->first);
  auto Copy = Map;
  while (!Copy.empty()) {
    Copy.erase(next(2) ? Copy.begin() : std::prev(Copy.end()));
    Wrong += !isWellFormed(Copy);
  }
  std::set<std::string> Words = {"tree", "red", "black", "root", "leaf"};
  Words.erase("red");
  Words.merge(std::set<std::string>{"node", "root"});
  for (const std::string &Word : Words)
    std::printf("%s ", Word.c_str());
  std::printf("%d wrong\n", Wrong);
}

static void put(const std::list<int> &List) {
  for (int Value : List)
    std::printf("%d ", Value);
  std::printf("| ");
  for (auto Place = List.rbegin(); Place != List.rend(); ++Place)
    std::printf("%d ", *Place);
  std::printf("(%zu)\n", List.size());
}

static void testLists() {
  std::list<int> A = {5, 1, 4, 1, 3}, B = {9, 2, 6}, Empty;
  A.sort();
  put(A);
  A.unique();
  B.reverse();
  put(B);
  A.splice(std::next(A.begin()), B, std::next(B.begin()), B.end());
  put(A);
  put(B);
  A.swap(B);
  put(A);
  A.swap(Empty);
  put(A);
  put(Empty);
  A.swap(B);
  std::list<int> C = {1, 7, 8};
  A.sort(std::greater<int>());
  C.sort(std::greater<int>());
  A.merge(C, std::greater<int>());
  put(A);
  A.remove_if([](int Value) { return Value % 2 == 1; });
  put(A);
  put(C);
}

static void testHashTables() {
  std::unordered_map<int, int> Numbers;
  std::unordered_map<std::string, int> Words;
  for (int I = 0; I != 500; ++I) {
    int Key = static_cast<int>(next(300));
    if (next(4) == 0) {
      Numbers.erase(Key);
      Words.erase(std::to_string(Key));
    } else {
      Numbers[Key] += I;
      Words["w" + std::to_string(Key % 50)] += I;
    }
  }
  // The order is the implementation's.
  unsigned Sum = 0;
  for (auto [Key, Value] : Numbers)
    Sum += Key * 31 + Value;
  for (auto &[Word, Value] : Words)
    Sum += Word.size() * 17 + Value;
  std::unordered_multiset<int> Set = {3, 1, 3, 3};
  Set.reserve(1000);
  std::printf("%zu %zu %u %zu %d %d\n", Numbers.size(), Words.size(), Sum,
              Set.count(3), Numbers.load_factor() <= 1,
              Set.bucket_count() >= 1000);
}

static void testSharedPointers() {
  auto First = std::make_shared<std::string>("shared");
  std::weak_ptr<std::string> Weak = First;
  std::vector<std::shared_ptr<std::string>> All(3, First);
  std::printf("%ld %s\n", First.use_count(), Weak.lock()->c_str());
  All.clear();
  First.reset();
  std::printf("%d\n", Weak.expired());
}

int main() {
  testTrees();
  testLists();
  testHashTables();
  testSharedPointers();
}
