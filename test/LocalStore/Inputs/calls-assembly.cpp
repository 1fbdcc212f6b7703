#include "tp/local_store.h"

extern "C" int assembled(int X);

extern "C" int compiled(int X) {
  volatile int Array[30];
  for (int I = 0; I != 30; ++I)
    Array[I] = X;
  return Array[X];
}

int main() {
  return tp::freeLocalStore().Bytes == 0 || assembled(7) != 7;
}
