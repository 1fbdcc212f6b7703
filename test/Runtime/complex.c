// <complex.h> on the chip as on the host.
// RUN: %host_cc -w -O1 -ffp-contract=off %s -o %t.host -lm
// RUN: %t.host > %t.expected
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf > %t.out
// RUN: diff %t.expected %t.out

#include <complex.h>
#include <stdio.h>
#include <tgmath.h>

static void put(double complex Z) {
  printf(" %.12g,%.12g", creal(Z), cimag(Z));
}

int main(void) {
  const double Parts[] = {0.25, -1.5, 3.0};
  for (int A = 0; A < 3; ++A)
    for (int B = 0; B < 3; ++B) {
      volatile double X = Parts[A], Y = Parts[B];
      double complex Z = __builtin_complex(X, Y);
      double complex (*const Functions[])(double complex) = {
        cacos,
        cacosh,
        casin,
        casinh,
        catan,
        catanh,
        ccos,
        ccosh,
        cexp,
        clog,
        conj,
        cproj,
        csin,
        csinh,
        csqrt,
        ctan,
        ctanh
      };
      for (unsigned F = 0; F < sizeof(Functions) / sizeof(*Functions); ++F)
        put(Functions[F](Z));
      put(cpow(Z, 0.5 + 2 * I));
      put(Z * Z / (Z + 1));
      float complex W = __builtin_complex((float)X, (float)Y);
      printf(" %.5g %.5g %.5g %.12g\n", cabsf(W), carg(W), crealf(cexpf(W)),
             fabs(Z));
    }
}
