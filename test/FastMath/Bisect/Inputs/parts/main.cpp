// Both ways to compute a share give the same bits in IEEE arithmetic.
#include "scale.h"

int main() {
  volatile float given = 49;
  float whole = given, values[64], result[64];
  for (int i = 0; i < 64; ++i)
    values[i] = i;
  shares(values, 64, whole, result);
  int wrong = 0;
  for (int i = 0; i < 64; ++i)
    wrong += result[i] != share(values[i], whole);
  return wrong != 0;
}
