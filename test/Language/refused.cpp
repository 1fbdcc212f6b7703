// What there is not says so: types, attributes, conventions of other machines.
// RUN: not tpcc -std=c++20 -c %s -o %t.o 2>&1 | FileCheck %s

#include <typeinfo>

// CHECK: [[#@LINE+1]]:1: error: __float128 is not supported on this target
__float128 Quad;
// CHECK: [[#@LINE+1]]:1: error: GNU decimal type extension not supported
_Decimal64 Decimal;
// CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: unsigned _BitInt of bit sizes greater than 8388608 not supported
unsigned _BitInt(8388609) TooWide;
int resolve();
// CHECK: [[#@LINE+1]]:{{[0-9]+}}: warning: unknown attribute 'ifunc' ignored
int indirect() __attribute__((ifunc("resolve")));
// CHECK: [[#@LINE+1]]:{{[0-9]+}}: warning: unknown attribute 'interrupt' ignored
void handler() __attribute__((interrupt));
// CHECK: [[#@LINE+1]]:{{[0-9]+}}: warning: 'vectorcall' calling convention is not supported for this target
__attribute__((vectorcall)) int vector(int V) { return V; }
// CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: function multiversioning is not supported on the current target
__attribute__((target_clones("a", "default"))) int versions(int V) { return V; }
// CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: cannot use 'throw' with exceptions disabled
void fail() { throw 1; }
struct Base { virtual ~Base(); };
struct Derived : Base {};
// CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: use of dynamic_cast requires -frtti
Derived *cast(Base *B) { return dynamic_cast<Derived *>(B); }
// CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: use of typeid requires -frtti
const std::type_info &type(Base *B) { return typeid(*B); }
void *Buffer[5];
// CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: __builtin_setjmp is not supported for the current target
int jump() { return __builtin_setjmp(Buffer); }
