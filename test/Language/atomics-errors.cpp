// Atomic objects of more than 64 bits are an error that says so, at each level
// and with debugging information at its place; smaller ones are not.
// RUN: not tpcc -std=c++20 -O2 -c %s -o %t.o 2>&1 | FileCheck %s
// RUN: not tpcc -std=c++20 -O0 -fno-lto -c %s -o %t.o 2>&1 | FileCheck %s
// RUN: not tpcc -std=c++20 -O0 -g -c %s -o %t.o 2>&1 | FileCheck %s --check-prefix=PLACE
// RUN: tpcc -std=c++20 -O2 -DWORDS=2 -DSMALL -c %s -o %t.o

#include <atomic>
#include <cstdint>

#ifndef WORDS
#define WORDS 4
#endif
struct Words { uint32_t V[WORDS]; };
std::atomic<Words> Object;

// CHECK: atomic:{{[0-9]+}}:{{[0-9]+}}: error: atomic operation on 16 bytes in 'std::atomic<Words>::load(std::memory_order) const'; the TP has them for at most 8: protect the object with a lock
Words read() { return Object.load(); }

// CHECK: atomics-errors.cpp:[[#@LINE+2]]:{{[0-9]+}}: error: atomic operation on 16 bytes in 'write(
// PLACE: atomics-errors.cpp:[[#@LINE+1]]:42: error: atomic operation on 16 bytes
void write(_Atomic(Words) *P, Words V) { __c11_atomic_store(P, V, 5); }

// CHECK: atomics-errors.cpp:[[#@LINE+2]]:{{[0-9]+}}: error: atomic operation on 16 bytes in 'add(
#ifndef SMALL
unsigned __int128 add(_Atomic unsigned __int128 *P) { return __c11_atomic_fetch_add(P, 5, 5); }
#endif

// CHECK: 3 errors generated
