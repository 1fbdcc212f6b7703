// What tpcc decides before the user does, and that the user can decide
// otherwise.
//
// RUN: tpcc -### -O2 -c %s 2>&1 | FileCheck %s
// RUN: tpcc -### -c %s -fno-omit-frame-pointer -ffp-contract=fast -fmath-errno 2>&1 | FileCheck --check-prefix=OVERRIDE %s
// RUN: tpcc -### -c -x c++ %s 2>&1 | FileCheck --check-prefix=CXX %s
// RUN: tpcc -### -c -x c++ -std=c++17 %s 2>&1 | FileCheck --check-prefix=CXX17 %s
// RUN: tpcc -### -c -x c++ -nostdinc++ %s 2>&1 | FileCheck --check-prefix=NOSTDINCXX %s
// RUN: tpcc -### -c -x c++ -nostdinc %s 2>&1 | FileCheck --check-prefix=NOSTDINC %s
// RUN: tpcc -### %s -O3 -o %t.elf 2>&1 | FileCheck --check-prefix=LINK %s
// RUN: tpcc -### %s -nostdlib 2>&1 | FileCheck --check-prefix=NOSTDLIB %s
// RUN: tpcc -### -c -mno-trig %s 2>&1 | FileCheck --check-prefix=NOTRIG %s

// CHECK: tpcc version
// CHECK: "-cc1" "-triple" "tp-unknown-elf"
// CHECK-SAME: "-emit-obj"
// CHECK-SAME: "-mrelocation-model" "static"
// CHECK-SAME: "-mframe-pointer=none"
// CHECK-SAME: "-ffp-contract=off"
// CHECK-SAME: "-fno-strict-float-cast-overflow"
// CHECK-SAME: "-internal-isystem" "{{[^"]*}}/lib/tp/include"
// CHECK-SAME: "-internal-isystem" "{{[^"]*}}clang/22/include"
// CHECK-NOT: "-fmath-errno"

// OVERRIDE: "-mframe-pointer=all"
// OVERRIDE-SAME: "-fmath-errno"
// OVERRIDE-SAME: "-ffp-contract=fast"

// CXX: "-std=gnu++20"
// CXX-SAME: "-internal-isystem" "{{[^"]*}}/lib/tp/libstdcxx"
// CXX-SAME: "-internal-isystem" "{{[^"]*}}/c++/{{[0-9]+}}"
// CXX-NOT: "-fexceptions"
// CXX17-NOT: gnu++20
// CXX17: "-std=c++17"
// NOSTDINCXX-NOT: libstdcxx
// NOSTDINCXX: /lib/tp/include
// NOSTDINC-NOT: -internal-isystem

// LINK: "-cc1"
// LINK-SAME: "-emit-llvm-bc"
// LINK-SAME: "-flto=full"
// LINK: tpcc" "-o" "{{[^"]*}}.elf" "-O3" "{{[^"]*}}.o"
// NOSTDLIB: tpcc" "-o" "a.out" "-nostdlib"
// NOTRIG: "-target-feature" "-trig"
