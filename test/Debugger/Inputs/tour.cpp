#include <cstdio>

namespace shapes {
struct Vector {
  float X, Y, Z;
};

struct Node {
  int Value;
  Node *Left;
  Node *Right;
};

enum class Kind { Small, Large };
} // namespace shapes

using shapes::Node;

Node Pool[8];
int Used = 0;
int Total = 0;
thread_local int Depth = 0;

Node *make(int Value) {
  Node *New = &Pool[Used];
  Used = Used + 1;
  New->Value = Value;
  return New;
}

Node *insert(Node *Root, int Value) {
  if (!Root)
    return make(Value);
  if (Value < Root->Value)
    Root->Left = insert(Root->Left, Value);
  else
    Root->Right = insert(Root->Right, Value);
  return Root;
}

int sum(const Node *Root) {
  if (!Root)
    return 0;
  Depth = Depth + 1;
  int Left = sum(Root->Left);
  int Right = sum(Root->Right);
  Depth = Depth - 1;
  return Left + Right + Root->Value;
}

float length(const shapes::Vector &Of) {
  float Square = Of.X * Of.X + Of.Y * Of.Y;
  return Square + Of.Z * Of.Z;
}

int main() {
  const int Values[5] = {5, 3, 8, 1, 4};
  Node *Root = nullptr;
  for (int I = 0; I < 5; ++I)
    Root = insert(Root, Values[I]);
  Total = sum(Root);
  shapes::Vector Direction = {1.0f, 2.0f, 3.0f};
  float Length = length(Direction);
  shapes::Kind Size = Total > 20 ? shapes::Kind::Large : shapes::Kind::Small;
  printf("total %d, length %g, kind %d\n", Total, Length, int(Size));
  return Total - 21;
}
