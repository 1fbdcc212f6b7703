//===- Arrays.c - Loops over arrays ---------------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

int sum(const int *Values, int Count) {
  int Sum = 0;
  for (int I = 0; I < Count; ++I)
    Sum += Values[I];
  return Sum;
}

int indexOfMaximum(const int *Values, int Count) {
  int Best = 0;
  for (int I = 1; I < Count; ++I)
    if (Values[I] > Values[Best])
      Best = I;
  return Best;
}

void prefixSum(unsigned *Values, unsigned Count) {
  unsigned Sum = 0;
  for (unsigned I = 0; I < Count; ++I) {
    Sum += Values[I];
    Values[I] = Sum;
  }
}

void histogram(const unsigned char *Bytes, unsigned Count, unsigned *Bins) {
  for (unsigned I = 0; I < Count; ++I)
    ++Bins[Bytes[I]];
}

int binarySearch(const int *Values, int Count, int Key) {
  int Low = 0, High = Count - 1;
  while (Low <= High) {
    int Middle = Low + (High - Low) / 2;
    if (Values[Middle] == Key)
      return Middle;
    if (Values[Middle] < Key)
      Low = Middle + 1;
    else
      High = Middle - 1;
  }
  return -1;
}

void insertionSort(int *Values, int Count) {
  for (int I = 1; I < Count; ++I) {
    int Value = Values[I], J = I;
    for (; J > 0 && Values[J - 1] > Value; --J)
      Values[J] = Values[J - 1];
    Values[J] = Value;
  }
}

void bubbleSort(int *Values, int Count) {
  for (int I = 0; I < Count - 1; ++I)
    for (int J = 0; J < Count - 1 - I; ++J)
      if (Values[J] > Values[J + 1]) {
        int Value = Values[J];
        Values[J] = Values[J + 1];
        Values[J + 1] = Value;
      }
}

struct node {
  struct node *Next;
  int Value;
};

struct node *reverseList(struct node *Node) {
  struct node *Reversed = 0;
  while (Node) {
    struct node *Next = Node->Next;
    Node->Next = Reversed;
    Reversed = Node;
    Node = Next;
  }
  return Reversed;
}
