// Prints its arguments and the size of its local store.
#include "tp/local_store.h"
#include <stdio.h>

int main(int ArgumentCount, char **Arguments) {
  if (tp::threadId() == 0) {
    for (int I = 1; I != ArgumentCount; ++I)
      printf("argument %s\n", Arguments[I]);
    printf("local store of %u bytes\n", (unsigned)tp::localStoreBytes());
  }
  return Arguments[ArgumentCount] != nullptr;
}
