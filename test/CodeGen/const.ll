; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

define i32 @zero() {
; CHECK-LABEL: zero:
; CHECK: move r4, r0
; CHECK-NEXT: ret
  ret i32 0
}
define i32 @small() {
; CHECK-LABEL: small:
; CHECK: addi r4, r0, -32768
; CHECK-NEXT: ret
  ret i32 -32768
}
define i32 @unsigned_half() {
; CHECK-LABEL: unsigned_half:
; CHECK: ori r4, r0, 65535
; CHECK-NEXT: ret
  ret i32 65535
}
define i32 @high_half() {
; CHECK-LABEL: high_half:
; CHECK: lui r4, 4660
; CHECK-NEXT: ret
  ret i32 305397760
}
define i32 @word() {
; CHECK-LABEL: word:
; CHECK: lui r12, 4660
; CHECK-NEXT: ori r4, r12, 22136
; CHECK-NEXT: ret
  ret i32 305419896
}
define float @float_zero() {
; CHECK-LABEL: float_zero:
; CHECK: mtc1 f4, r0
; CHECK-NEXT: ret
  ret float 0.0
}
define float @float_negative_zero() {
; CHECK-LABEL: float_negative_zero:
; CHECK: lui r12, 32768
; CHECK-NEXT: mtc1 f4, r12
; CHECK-NEXT: ret
  ret float -0.0
}
define float @float_one() {
; CHECK-LABEL: float_one:
; CHECK: lui r12, 16256
; CHECK-NEXT: mtc1 f4, r12
; CHECK-NEXT: ret
  ret float 1.0
}
define float @float_tenth() {
; CHECK-LABEL: float_tenth:
; CHECK: lui r12, 15820
; CHECK-NEXT: ori r12, r12, 52429
; CHECK-NEXT: mtc1 f4, r12
; CHECK-NEXT: ret
  ret float 0x3FB99999A0000000
}
define i64 @long() {
; CHECK-LABEL: long:
; CHECK: addi r5, r0, 1
; CHECK-NEXT: move r4, r0
; CHECK-NEXT: ret
  ret i64 4294967296
}
define void @store_zero(ptr %p) {
; CHECK-LABEL: store_zero:
; CHECK: sw r0, 0(r4)
; CHECK-NEXT: ret
  store i32 0, ptr %p
  ret void
}
