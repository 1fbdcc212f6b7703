// Writes a row of grey pixels: white where a division can be undone.
#include <cstdio>

__attribute__((noinline)) void fill(unsigned char *row, int width,
                                    float whole) {
  for (int x = 0; x < width; ++x)
    row[x] = float(x) / whole * whole == float(x) ? 200 : 0;
}

int main(int, char **arguments) {
  volatile float whole = 49;
  unsigned char row[48];
  fill(row, sizeof(row), whole);
  std::FILE *file = std::fopen(arguments[1], "wb");
  std::fputs("P5\n48 1\n255\n", file);
  std::fwrite(row, 1, sizeof(row), file);
  std::puts("done");
  return std::fclose(file);
}
