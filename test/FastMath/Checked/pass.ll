; What the pass inserts and removes, and that later passes leave its checks.

; RUN: tpcc -O0 -S -emit-llvm -mllvm -tp-fp-canonicalize=0 -ftp-check-fp %s -o %t.ll
; RUN: FileCheck %s < %t.ll
; RUN: tpcc -O0 -S -emit-llvm -mllvm -tp-fp-canonicalize=0 %s -o - | FileCheck %s --check-prefix=OFF
; OFF-NOT: tp_fp_check_failed
; RUN: tpcc -O3 -S -emit-llvm -mllvm -tp-fp-canonicalize=0 -ftp-check-fp %s -o - | FileCheck %s --check-prefix=O3
; A second run finds nothing to do.
; RUN: tpcc -O0 -S -emit-llvm -mllvm -tp-fp-canonicalize=0 -ftp-check-fp %t.ll -o - | FileCheck %s

target triple = "tp-unknown-elf"

; The result says what became of the operands.
; CHECK-LABEL: define float @sum(
; CHECK-SAME: float %a, float %b) #[[CHECKED:[0-9]+]] {
; CHECK-NEXT: %sum = fadd float %a, %b
; CHECK-NEXT: [[BITS:%.*]] = bitcast float %sum to i32
; CHECK-NEXT: [[MAGNITUDE:%.*]] = and i32 [[BITS]], 2147483647
; CHECK-NEXT: [[FAILED:%.*]] = icmp uge i32 [[MAGNITUDE]], 2139095040
; CHECK-NEXT: br i1 [[FAILED]], label %[[REPORT:.*]], label %[[REST:.*]], !prof
; CHECK: [[REST]]:
; CHECK-NEXT: ret float %sum
; CHECK: [[REPORT]]:
; CHECK: call void @tp_fp_check_failed(i32 {{[0-9]+}}, i32 %{{.*}}, i32 %{{.*}}, i32 %{{.*}}, i32 poison, i32 poison, i32 poison) #[[COLD:[0-9]+]]
; CHECK-NEXT: unreachable
; O3-LABEL: define {{.*}}@sum(
; O3: call void @tp_fp_check_failed(
define nofpclass(nan inf) float @sum(float nofpclass(nan inf) %a, float nofpclass(nan inf) %b) "no-nans-fp-math"="true" "no-infs-fp-math"="true" {
  %sum = fadd nnan ninf float %a, %b
  ret float %sum
}

; A quotient hides an infinite divisor. Constants are known.
; CHECK-LABEL: define float @quotient(
; CHECK: bitcast float %b to i32
; CHECK: %quotient = fdiv float 1.0{{.*}}, %b
; CHECK: bitcast float %quotient to i32
; CHECK-COUNT-2: call void @tp_fp_check_failed(
; CHECK-NOT: call
; O3-LABEL: define {{.*}}@quotient(
; O3-COUNT-2: call void @tp_fp_check_failed(
define float @quotient(float %b) {
  %quotient = fdiv nnan ninf float 1.0, %b
  ret float %quotient
}

; Only what the flags promise.
; CHECK-LABEL: define float @no_nans(
; CHECK: icmp ugt i32 %{{.*}}, 2139095040
; CHECK-LABEL: define float @no_infinities(
; CHECK: icmp eq i32 %{{.*}}, 2139095040
; CHECK: icmp eq i32 %{{.*}}, 2139095040
; CHECK: fadd float
; CHECK: icmp eq i32 %{{.*}}, 2139095040
define float @no_nans(float %a, float %b) {
  %sum = fadd nnan float %a, %b
  ret float %sum
}
define float @no_infinities(float %a, float %b) {
  %sum = fadd ninf float %a, %b
  ret float %sum
}

; What has been checked is not checked again.
; CHECK-LABEL: define i1 @chain(
; CHECK-COUNT-2: call void @tp_fp_check_failed(
; CHECK-NOT: call void
; CHECK-LABEL: define i1 @plain_compare(
define i1 @chain(float %a, float %b) {
  %sum = fadd nnan ninf float %a, %b
  %product = fmul nnan ninf float %sum, %a
  %negated = fneg nnan ninf float %product
  %magnitude = call nnan ninf float @llvm.fabs.f32(float %negated)
  %less = fcmp nnan ninf olt float %magnitude, 2.0
  ret i1 %less
}

; Both operands; the branch after the check is the program's.
; CHECK: icmp ugt i32 %{{.*}}, 2139095040
; CHECK: icmp ugt i32 %{{.*}}, 2139095040
; CHECK: or i1
; CHECK: br i1
; CHECK: fcmp olt float %a, %b
; O3-LABEL: define {{.*}}@plain_compare(
; O3: call void @tp_fp_check_failed(
define i1 @plain_compare(float %a, float %b) {
  %less = fcmp olt float %a, %b
  ret i1 %less
}

; CHECK-LABEL: define i1 @tests(
; CHECK-NOT: tp_fp_check_failed
; CHECK-LABEL: define i8 @half(
define i1 @tests(ptr %p, float %b) {
  %a1 = load float, ptr %p
  %a2 = load float, ptr %p
  %nan = fcmp une float %a1, %a2
  %unordered = fcmp uno float %a1, %b
  %isnan = call i1 @llvm.is.fpclass.f32(float %b, i32 3)
  %1 = or i1 %nan, %unordered
  %2 = or i1 %1, %isnan
  ret i1 %2
}

; The limits of an int8_t in binary16: 128 and -129.
; CHECK: select i1 %{{.*}}, i16 22536, i16 22528
; CHECK: icmp uge i16
define i8 @half(half %x) {
  %i = fptosi half %x to i8
  ret i8 %i
}

; CHECK-LABEL: define i32 @between(
; CHECK: call void @tp_fp_check_failed(
; CHECK-LABEL: define i32 @vector(
; A store between two loads: not one variable.
define i32 @between(ptr %p, float %b) {
  %a1 = load float, ptr %p
  store float %b, ptr %p
  %a2 = load float, ptr %p
  %nan = fcmp une float %a1, %a2
  %i = zext i1 %nan to i32
  ret i32 %i
}

; Each element of a vector, and an unsigned range.
; CHECK-COUNT-2: extractelement <2 x double>
; CHECK-COUNT-2: call void @tp_fp_check_failed(
; CHECK-NOT: call void @tp_fp_check_failed(
; CHECK-LABEL: define double @left_alone(
define i32 @vector(<2 x double> %x) {
  %v = fptoui <2 x double> %x to <2 x i32>
  %i = extractelement <2 x i32> %v, i32 0
  ret i32 %i
}

; CHECK-SAME: double nofpclass(nan) %x)
; CHECK-NEXT: fadd nnan double
; CHECK-NOT: call
; CHECK: ret double
define double @left_alone(double nofpclass(nan) %x) "tp-fp-unchecked" {
  %sum = fadd nnan double %x, %x
  ret double %sum
}

; Checks that follow each other share a branch when the program is optimized,
; but for what follows a conversion: it may be an address.
; O3-LABEL: define {{.*}}@one_branch(
; O3-NOT: br
; O3: or i32
; O3: br i1 %{{.*}}, label %[[SEARCH:.*]], label %[[REST:.*]], !prof
; O3: {{^}}[[REST]]:
; O3: load i32
; O3: ret
; O3: {{^}}[[SEARCH]]:
; O3: br i1 %{{.*}}, label %{{.*}}, label %
; O3: br label
define i32 @one_branch(float %a, float %b, ptr %p) {
  %less = fcmp olt float %a, 0.0
  %i = load i32, ptr %p
  %more = fcmp ogt float %b, 0.0
  %1 = select i1 %less, i32 %i, i32 1
  %2 = select i1 %more, i32 %1, i32 2
  ret i32 %2
}
; O3-LABEL: define {{.*}}@two_branches(
; O3: br i1
; O3: getelementptr
; O3: load float
; O3: br i1
define i1 @two_branches(float %a, ptr %p) {
  %i = fptosi float %a to i32
  %q = getelementptr float, ptr %p, i32 %i
  %b = load float, ptr %q
  %less = fcmp olt float %b, 0.0
  ret i1 %less
}

; CHECK: attributes #[[CHECKED]] = {
; CHECK-NOT: no-nans
; CHECK-SAME: "tp-fp-checked"
; CHECK: attributes #[[COLD]] = { {{.*}}cold nomerge noreturn
