; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

define i32 @add_immediate(i32 %a) {
; CHECK-LABEL: add_immediate:
; CHECK: addi r4, r4, -32768
; CHECK-NEXT: ret
  %r = add i32 %a, -32768
  ret i32 %r
}
define i32 @sub_immediate(i32 %a) {
; CHECK-LABEL: sub_immediate:
; CHECK: addi r4, r4, -100
; CHECK-NEXT: ret
  %r = sub i32 %a, 100
  ret i32 %r
}
define i32 @add_large(i32 %a) {
; CHECK-LABEL: add_large:
; CHECK: lui r12, 1
; CHECK-NEXT: ori r12, r12, 9029
; CHECK-NEXT: add r4, r4, r12
; CHECK-NEXT: ret
  %r = add i32 %a, 74565
  ret i32 %r
}
define i32 @logic(i32 %a, i32 %b) {
; CHECK-LABEL: logic:
; CHECK: lui r13, 65535
; CHECK-NEXT: or r12, r4, r5
; CHECK-NEXT: ori r13, r13, 21554
; CHECK-NEXT: xor r12, r12, r13
; CHECK-NEXT: and r4, r12, r5
; CHECK-NEXT: ret
  %c = or i32 %a, %b
  %d = xor i32 %c, -1
  %e = xor i32 %d, 43981
  %f = and i32 %e, %b
  ret i32 %f
}
define i32 @invert(i32 %a) {
; CHECK-LABEL: invert:
; CHECK: not r4, r4
; CHECK-NEXT: ret
  %r = xor i32 %a, -1
  ret i32 %r
}
define i32 @divide(i32 %a, i32 %b) {
; CHECK-LABEL: divide:
; CHECK: div r12, r4, r5
; CHECK-NEXT: divu r12, r12, r5
; CHECK-NEXT: rem r12, r12, r5
; CHECK-NEXT: remu r4, r12, r5
; CHECK-NEXT: ret
  %c = sdiv i32 %a, %b
  %d = udiv i32 %c, %b
  %e = srem i32 %d, %b
  %f = urem i32 %e, %b
  ret i32 %f
}
define i32 @divide_constant(i32 %a) {
; CHECK-LABEL: divide_constant:
; CHECK: lui r12, 52428
; CHECK-NEXT: ori r12, r12, 52429
; CHECK-NEXT: mulhu r12, r4, r12
; CHECK-NEXT: srl r4, r12, 3
; CHECK-NEXT: ret
  %r = udiv i32 %a, 10
  ret i32 %r
}
define i32 @shifts(i32 %a, i32 %s) {
; CHECK-LABEL: shifts:
; CHECK: sllv r12, r4, r5
; CHECK-NEXT: srlv r12, r12, r5
; CHECK-NEXT: sra r4, r12, 3
; CHECK-NEXT: ret
  %m = and i32 %s, 31
  %b = shl i32 %a, %m
  %c = lshr i32 %b, %s
  %d = ashr i32 %c, 3
  ret i32 %d
}
define i32 @rotate(i32 %a, i32 %s) {
; CHECK-LABEL: rotate:
; CHECK: rotrv r12, r4, r5
; CHECK-NEXT: rotr r12, r12, 27
; CHECK-NEXT: neg r13, r5
; CHECK-NEXT: rotrv r4, r12, r13
; CHECK-NEXT: ret
  %b = call i32 @llvm.fshr.i32(i32 %a, i32 %a, i32 %s)
  %c = call i32 @llvm.fshl.i32(i32 %b, i32 %b, i32 5)
  %d = call i32 @llvm.fshl.i32(i32 %c, i32 %c, i32 %s)
  ret i32 %d
}
define i32 @extract(i32 %a) {
; CHECK-LABEL: extract:
; CHECK: ext r4, r4, 7, 16
; CHECK-NEXT: ret
  %b = lshr i32 %a, 7
  %c = and i32 %b, 1023
  ret i32 %c
}
define i32 @extract_low(i32 %a) {
; CHECK-LABEL: extract_low:
; CHECK: ext r4, r4, 0, 19
; CHECK-NEXT: ret
  %b = and i32 %a, 1048575
  ret i32 %b
}
define i32 @insert(i32 %a, i32 %b) {
; CHECK-LABEL: insert:
; CHECK: ins r4, r5, 8, 15
; CHECK-NEXT: ret
  %c = and i32 %a, -65281
  %d = shl i32 %b, 8
  %e = and i32 %d, 65280
  %f = or i32 %c, %e
  ret i32 %f
}
define i32 @insert_top(i32 %a, i32 %b) {
; CHECK-LABEL: insert_top:
; CHECK: ins r4, r5, 16, 31
; CHECK-NEXT: ret
  %c = and i32 %a, 65535
  %d = shl i32 %b, 16
  %f = or i32 %c, %d
  ret i32 %f
}
define i32 @count(i32 %a) {
; CHECK-LABEL: count:
; CHECK: addi r13, r4, -1
; CHECK-NEXT: not r14, r4
; CHECK-NEXT: and r13, r14, r13
; CHECK-NEXT: clz r12, r4
; CHECK-NEXT: clz r13, r13
; CHECK-NEXT: sub r12, r12, r13
; CHECK-NEXT: addi r4, r12, 32
; CHECK-NEXT: ret
  %b = call i32 @llvm.ctlz.i32(i32 %a, i1 false)
  %c = call i32 @llvm.cttz.i32(i32 %a, i1 false)
  %d = add i32 %b, %c
  ret i32 %d
}
define i32 @population(i32 %a) {
; CHECK-LABEL: population:
; CHECK: lui r13, 21845
; CHECK-NEXT: srl r12, r4, 1
; CHECK-NEXT: ori r13, r13, 21845
; CHECK-NEXT: and r12, r12, r13
; CHECK-NEXT: sub r14, r4, r12
; CHECK-NEXT: lui r12, 13107
; CHECK-NEXT: ori r13, r12, 13107
; CHECK-NEXT: and r12, r14, r13
; CHECK-NEXT: srl r14, r14, 2
; CHECK-NEXT: and r13, r14, r13
; CHECK-NEXT: add r12, r12, r13
; CHECK-NEXT: srl r13, r12, 4
; CHECK-NEXT: add r12, r12, r13
; CHECK-NEXT: lui r13, 3855
; CHECK-NEXT: ori r13, r13, 3855
; CHECK-NEXT: and r12, r12, r13
; CHECK-NEXT: lui r13, 257
; CHECK-NEXT: ori r13, r13, 257
; CHECK-NEXT: mul r12, r12, r13
; CHECK-NEXT: srl r4, r12, 24
; CHECK-NEXT: ret
  %b = call i32 @llvm.ctpop.i32(i32 %a)
  ret i32 %b
}
define i32 @swap(i32 %a) {
; CHECK-LABEL: swap:
; CHECK: lui r13, 255
; CHECK-NEXT: rotr r12, r4, 24
; CHECK-NEXT: ori r13, r13, 255
; CHECK-NEXT: and r12, r12, r13
; CHECK-NEXT: and r13, r4, r13
; CHECK-NEXT: rotr r13, r13, 8
; CHECK-NEXT: or r4, r13, r12
; CHECK-NEXT: ret
  %b = call i32 @llvm.bswap.i32(i32 %a)
  ret i32 %b
}
define i32 @sign_extend(i32 %a) {
; CHECK-LABEL: sign_extend:
; CHECK: seb r12, r4
; CHECK-NEXT: seh r13, r4
; CHECK-NEXT: add r4, r12, r13
; CHECK-NEXT: ret
  %b = trunc i32 %a to i8
  %c = sext i8 %b to i32
  %d = trunc i32 %a to i16
  %e = sext i16 %d to i32
  %f = add i32 %c, %e
  ret i32 %f
}
define i32 @minimum(i32 %a, i32 %b) {
; CHECK-LABEL: minimum:
; CHECK: slt r13, r4, r5
; CHECK-NEXT: move r12, r5
; CHECK-NEXT: movn r12, r4, r13
; CHECK-NEXT: sltu r13, r5, r12
; CHECK-NEXT: movn r5, r12, r13
; CHECK-NEXT: move r4, r5
; CHECK-NEXT: ret
  %c = call i32 @llvm.smin.i32(i32 %a, i32 %b)
  %d = call i32 @llvm.umax.i32(i32 %c, i32 %b)
  ret i32 %d
}
define i32 @magnitude(i32 %a) {
; CHECK-LABEL: magnitude:
; CHECK: sra r12, r4, 31
; CHECK-NEXT: xor r13, r4, r12
; CHECK-NEXT: sub r4, r13, r12
; CHECK-NEXT: ret
  %b = call i32 @llvm.abs.i32(i32 %a, i1 false)
  ret i32 %b
}
define {i32, i1} @overflow(i32 %a, i32 %b) {
; CHECK-LABEL: overflow:
; CHECK: move r12, r4
; CHECK-NEXT: add r4, r12, r5
; CHECK-NEXT: slt r12, r4, r12
; CHECK-NEXT: slti r13, r5, 0
; CHECK-NEXT: xor r5, r13, r12
; CHECK-NEXT: ret
  %r = call {i32, i1} @llvm.sadd.with.overflow.i32(i32 %a, i32 %b)
  ret {i32, i1} %r
}
define i32 @saturate(i32 %a, i32 %b) {
; CHECK-LABEL: saturate:
; CHECK: move r12, r4
; CHECK-NEXT: sub r4, r12, r5
; CHECK-NEXT: sltu r12, r12, r4
; CHECK-NEXT: movn r4, r0, r12
; CHECK-NEXT: ret
  %r = call i32 @llvm.usub.sat.i32(i32 %a, i32 %b)
  ret i32 %r
}
