#include "scale.h"

float share(float value, float whole) { return value / whole; }
