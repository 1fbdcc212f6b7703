// Inline assembly: constraints, modifiers, tied and early-clobbered operands,
// 64-bit values, memory, symbols, labels, registers by name.
// RUN: %compare %s %t --native clang
#include <stdint.h>
#include <stdio.h>

static int Global = 77;
static int Array[4] = {10, 20, 30, 40};
__attribute__((noinline)) static int twice(int V) { return 2 * V; }
struct Pair { int A, B; };

#ifdef __tp__
#define ASM(Text, Plain, ...) __asm__ volatile(Text : __VA_ARGS__)
#else
#define ASM(Text, Plain, ...) Plain
#endif

__attribute__((noinline)) int basic(int A, int B) {
  int R;
  ASM("sub %0, %1, %2", R = A - B, "=r"(R) : "r"(A), "r"(B));
  return R;
}
__attribute__((noinline)) float real(float A, int B) {
  float R;
  ASM("cvt_s_w %0, %2\n\tmul_s %0, %0, %1", R = A * B, "=&f"(R) : "f"(A), "r"(B));
  return R;
}
__attribute__((noinline)) int named(int A) {
  int R;
  ASM("addi %[out], %[in], %[number]", R = A + -300,
      [out] "=r"(R) : [in] "r"(A), [number] "I"(-300));
  return R;
}
__attribute__((noinline)) int tied(int A, int B) {
  ASM("add %0, %0, %2", A += B, "=r"(A) : "0"(A), "r"(B));
  ASM("sub %0, %0, %1", A -= 2 * B, "+r"(A) : "r"(B * 2));
  return A;
}
__attribute__((noinline)) int early(int A, int B) {
  int R, S;
  ASM("add %0, %2, %3\n\tsub %1, %2, %3", (R = A + B, S = A - B),
      "=&r"(R), "=&r"(S) : "r"(A), "r"(B));
  return R * 1000 + S;
}
__attribute__((noinline)) int memory(int *P, int I) {
  int R;
  struct Pair Local = {I, 5};
  ASM("lw %0, %1\n\tadd %0, %0, %3\n\tsw %0, %2", (R = P[1] + I, Local.B = R),
      "=&r"(R) : "m"(P[1]), "m"(Local.B), "r"(I) : "memory");
  ASM("sw %1, %0", P[2] = I, "=m"(P[2]) : "r"(I));
  ASM("lw r8, %0\n\taddi r8, r8, 1\n\tsw r8, %0", Global++, "+m"(Global) : : "r8");
  char Far[40000];
  ASM("sb %1, %0", Far[39999] = 3, "=m"(Far[39999]) : "r"(3));
  return R + Local.B + P[2] + Far[39999];
}
__attribute__((noinline)) int64_t wide(int64_t A, int64_t B) {
  int64_t R;
  ASM("add %0, %1, %2\n\tsltu r12, %0, %1\n\tadd %D0, %D1, %D2\n\tadd %D0, %D0, r12",
      R = A + B, "=&r"(R) : "r"(A), "r"(B) : "r12");
  ASM("addi %M0, %M0, 1", R += 1ll << 32, "+r"(R));
  ASM("addi %L0, %L0, 0", (void)0, "+r"(R));
  return R;
}
__attribute__((noinline)) int64_t wideMemory(int64_t *P) {
  int64_t R;
  ASM("lw %L0, %1\n\tlw %M0, %D1", R = *P, "=&r"(R) : "m"(*P));
  return R;
}
__attribute__((noinline)) double doubles(double A) {
  ASM("ins %D0, r0, 31, 31", A = A < 0 ? -A : A, "+r"(A));
  return A;
}
__attribute__((noinline)) int zero(int A) {
  int R;
  ASM("add %0, %1, %z2", R = A, "=r"(R) : "r"(A), "rJ"(0));
  ASM("ori %0, %0, %1", R |= 0xfff0, "+r"(R) : "K"(0xfff0));
  ASM("addi %0, %0, %n1", R -= 12, "+r"(R) : "i"(12));
  ASM("addi %0, %0, -%c1", R -= 13, "+r"(R) : "n"(13));
  return R;
}
__attribute__((noinline)) int symbol(void) {
  int R;
  ASM("lui %0, %%hi(%1)\n\tlw %0, %%lo(%1)(%0)", R = Array[3], "=r"(R) : "i"(&Array[3]));
  return R;
}
__attribute__((noinline)) int addresses(int *P) {
  int R, S, T, U, Local[2] = {4, P[1]};
  ASM("lw %0, %1", R = Local[1], "=r"(R) : "o"(Local[1]));
  ASM("lw %0, %1", S = Global, "=r"(S) : "V"(Global));
  ASM("lw %0, %a1", T = P[2], "=r"(T) : "r"(&P[2]), "m"(P[2]));
  ASM("lw %0, 0(%1)", U = P[3], "=r"(U) : "p"(&P[3]), "m"(P[3]));
  ASM("lui r8, %%hi(%1)\n\tlw r8, %%lo(%1)(r8)\n\tadd %0, %0, r8", R += Array[0],
      "+r"(R) : "s"(&Array[0]), "m"(Array[0]) : "r8");
  return R + 2 * S + 3 * T + 5 * U;
}
__attribute__((noinline)) int call(int V) {
#ifdef __tp__
  register int Value __asm__("r4") = V;
  __asm__ volatile("jal %1"
                   : "+r"(Value)
                   : "i"(twice)
                   : "r31", "r2", "r3", "r5", "r6", "r7", "r8", "r9", "r10",
                     "r11", "r12", "r13", "r14", "r15", "memory");
  return Value;
#else
  return twice(V);
#endif
}
__attribute__((noinline)) int jump(int A, int B) {
#ifdef __tp__
  __asm__ goto("blt %0, %1, %l[less]\n\tbeq %0, %1, %l3" : : "r"(A), "r"(B) : : less, equal);
#else
  if (A < B) goto less;
  if (A == B) goto equal;
#endif
  return 1;
less:
  return -1;
equal:
  return 0;
}
__attribute__((noinline)) int jumpWithResult(int A) {
  int R;
#ifdef __tp__
  __asm__ goto("addi %0, %1, 5\n\tbge %0, r0, %l[positive]" : "=r"(R) : "r"(A) : : positive);
#else
  R = A + 5;
  if (R >= 0) goto positive;
#endif
  return -R;
positive:
  return R * 2;
}
__attribute__((noinline)) int registers(int A, float F) {
#ifdef __tp__
  register int In __asm__("r7") = A;
  register int Out __asm__("r16");
  register float Float __asm__("f20") = F;
  __asm__ volatile("add r16, r7, r7\n\tneg_s f20, f20" : "=r"(Out), "+f"(Float) : "r"(In));
  return Out + (int)Float;
#else
  return A + A + (int)-F;
#endif
}
__attribute__((noinline)) int clobbers(int A, float F) {
  int B = A * 3;
  float G = F * 2;
  ASM("li r16, -1\n\tli r17, -1\n\tmtc1 f20, r16\n\tmtc1 f12, r0\n\tli r5, 1", (void)0,
      : : "r16", "r17", "f20", "f12", "r5", "cc", "memory");
  return A + B + (int)G;
}
__attribute__((noinline)) int alternatives(int A) {
  int R;
  ASM("add %0, %1, %2", R = A + A, "=r,r"(R) : "r,0"(A), "r,r"(A));
  ASM("addi %0, %0, %1", R += 7, "+r"(R) : "rI"(7));
  ASM("addi %0, %0, %1", R += 9, "+r"(R) : "g"(9));
  return R;
}
__attribute__((noinline)) int narrow(signed char A, unsigned short B, _Bool C) {
  signed char R = A;
  unsigned short S;
  ASM("add %0, %0, %1", R += C, "+r"(R) : "r"(C));
  ASM("add %0, %1, %1", S = B * 2, "=r"(S) : "r"(B));
  return R + S;
}
__attribute__((noinline)) int *pointer(int *P) {
  ASM("addi %0, %0, 8", P += 2, "+r"(P));
  return P;
}
__attribute__((noinline)) int flow(int N) {
  int Sum = 0;
  for (int I = 0; I < N; ++I)
    ASM("addi r9, %1, 1\n1:\tadd %0, %0, r9\n\taddi r9, r9, -1\n\tbne r9, r0, 1b\n.Lx%=:",
        for (int J = I + 1; J; --J) Sum += J, "+r"(Sum) : "r"(I) : "r9");
  return Sum;
}
#ifdef __tp__
__asm__(".text\n.globl fromAssembly\n.type fromAssembly,@function\nfromAssembly:\n"
        "\taddi r4, r4, 123\n\tjr ra\n.size fromAssembly, .-fromAssembly");
int fromAssembly(int);
#else
static int fromAssembly(int V) { return V + 123; }
#endif

int main(void) {
  printf("%d %g %d %d %d\n", basic(5, 9), real(1.5f, -3), named(20), tied(7, 2), early(9, 4));
  printf("%d\n", memory(Array, 6));
  printf("%d %d %d\n", Global, Array[2], call(21));
  printf("%lld %g\n", (long long)wide(0xffffffffll, 5), doubles(-2.5));
  int64_t Value = -123456789012345;
  printf("%d\n", addresses(Array));
  printf("%lld\n", (long long)wideMemory(&Value));
  printf("%d %d\n", zero(3), symbol());
  printf("%d %d %d %d %d\n", jump(1, 2), jump(2, 2), jump(3, 2), jumpWithResult(3), jumpWithResult(-30));
  printf("%d %d %d %d\n", registers(4, 2.5f), clobbers(3, 4), alternatives(5), narrow(-3, 7, 1));
  printf("%d %d %d\n", (int)(pointer(Array) - Array), flow(5), fromAssembly(1));
}
