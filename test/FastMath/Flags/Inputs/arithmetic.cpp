// Arithmetic under each of clang's ways to say how it is compiled.
float plain(float A, float B, float C) { return A * B + C / B; }

float contracted(float A, float B, float C) {
#pragma STDC FP_CONTRACT ON
  return A * B + C;
}

float separate(float A, float B, float C) {
#pragma STDC FP_CONTRACT OFF
  return A * B + C;
}

float byPragma(float A, float B, float C) {
#pragma clang fp reassociate(on) reciprocal(on) contract(fast)
  return A * B + C / B;
}

float offByPragma(float A, float B, float C) {
#pragma clang fp reassociate(off) reciprocal(off) contract(off)
  return A * B + C / B;
}

float observed(float A, float B, float C) {
#pragma clang fp exceptions(strict)
  return A * B + C;
}

// Clang refuses it where exceptions are observed.
#ifndef STRICT
#pragma float_control(precise, off, push)
float imprecise(float A, float B, float C) { return A * B + C / B; }
#pragma float_control(pop)
#endif

#pragma float_control(precise, on, push)
float precise(float A, float B, float C) { return A * B + C / B; }
#pragma float_control(pop)

__attribute__((optnone, noinline)) float unoptimized(float A, float B,
                                                     float C) {
  return A * B + C / B;
}

double wide(double A, double B, double C) { return -A * B - C / B; }

bool compared(float A, float B) { return A < B && A != 0.0f; }

float chosen(float A, float B) { return A < B ? A : B; }

int truncated(float A) { return (int)A; }

float grouped(float A, float B, float C) { return (A + B) + (C - A); }
