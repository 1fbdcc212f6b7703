#include "scale.h"

void shares(const float *values, int count, float whole, float *result) {
  for (int i = 0; i < count; ++i)
    result[i] = values[i] / whole;
}
