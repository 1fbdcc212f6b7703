; Atomic loads and stores are listed in a section, with 1 for a load that
; acquires and 2 for what is meant for some bytes of the word. Atomic
; instructions say themselves what they are.
; RUN: %llc_tp -O2 < %s | FileCheck %s
; RUN: %llc_tp -O0 -filetype=obj < %s -o %t.o
; RUN: llvm-readelf -r %t.o | FileCheck %s --check-prefix=RELOCATIONS

; RELOCATIONS: '.rela.tp_atomics'
; RELOCATIONS-SAME: contains 11 entries

define i32 @relaxed(ptr %p) {
; CHECK-LABEL: relaxed:
; CHECK: [[RELAXED:.Latomic[0-9]+]]:
; CHECK-NEXT: lw
  %r = load atomic i32, ptr %p monotonic, align 4
  ret i32 %r
}
define i8 @acquire(ptr %p) {
; CHECK-LABEL: acquire:
; CHECK: [[ACQUIRE:.Latomic[0-9]+]]:
; CHECK-NEXT: lbu
  %r = load atomic i8, ptr %p acquire, align 1
  ret i8 %r
}
define void @release(ptr %p, i32 %v) {
; CHECK-LABEL: release:
; CHECK: sync
; CHECK-NEXT: [[RELEASE:.Latomic[0-9]+]]:
; CHECK-NEXT: sw
  store atomic i32 %v, ptr %p release, align 4
  ret void
}
define i32 @add(ptr %p, i32 %v) {
; CHECK-LABEL: add:
; CHECK-NOT: .Latomic
; CHECK: atom_add
  %r = atomicrmw add ptr %p, i32 %v acq_rel
  ret i32 %r
}
define i32 @plain(ptr %p) {
; CHECK-LABEL: plain:
; CHECK-NOT: .Latomic
; CHECK: lw
  %r = load volatile i32, ptr %p
  ret i32 %r
}
; The first guess of a compare-exchange loop.
define float @add_float(ptr %p, float %v) {
; CHECK-LABEL: add_float:
; CHECK: [[GUESS:.Latomic[0-9]+]]:
; CHECK-NEXT: lwc1
; CHECK: atom_cas
  %r = atomicrmw fadd ptr %p, float %v monotonic
  ret float %r
}
define i8 @add_byte(ptr %p, i8 %v) {
; CHECK-LABEL: add_byte:
; CHECK: [[WORD:.Latomic[0-9]+]]:
; CHECK-NEXT: lw
; CHECK: [[BYTE:.Latomic[0-9]+]]:
; CHECK-NEXT: atom_cas
  %r = atomicrmw add ptr %p, i8 %v monotonic
  ret i8 %r
}
define i8 @exchange_byte(ptr %p, i8 %old, i8 %new) {
; CHECK-LABEL: exchange_byte:
; CHECK: [[WORD2:.Latomic[0-9]+]]:
; CHECK-NEXT: lw
; CHECK: [[BYTE2:.Latomic[0-9]+]]:
; CHECK-NEXT: atom_cas
  %r = cmpxchg ptr %p, i8 %old, i8 %new monotonic monotonic
  %s = extractvalue { i8, i1 } %r, 0
  ret i8 %s
}
; An operation on a byte of a word whose place is known, and one that is done by
; that on the word.
define i8 @add_aligned_byte(ptr %p, i8 %v) {
; CHECK-LABEL: add_aligned_byte:
; CHECK: [[WORD3:.Latomic[0-9]+]]:
; CHECK-NEXT: lw
; CHECK: [[BYTE3:.Latomic[0-9]+]]:
; CHECK-NEXT: atom_cas
  %r = atomicrmw add ptr %p, i8 %v monotonic, align 4
  ret i8 %r
}
define i8 @or_byte(ptr %p, i8 %v) {
; CHECK-LABEL: or_byte:
; CHECK: [[BYTE4:.Latomic[0-9]+]]:
; CHECK-NEXT: atom_or
  %r = atomicrmw or ptr %p, i8 %v monotonic
  ret i8 %r
}

; CHECK: .section .tp_atomics,"",@progbits
; CHECK-NEXT: .long [[RELAXED]]
; CHECK-NEXT: .long [[ACQUIRE]]+1
; CHECK-NEXT: .long [[RELEASE]]
; CHECK-NEXT: .long [[GUESS]]
; CHECK-NEXT: .long [[WORD]]+2
; CHECK-NEXT: .long [[BYTE]]+2
; CHECK-NEXT: .long [[WORD2]]+2
; CHECK-NEXT: .long [[BYTE2]]+2
; CHECK-NEXT: .long [[WORD3]]+2
; CHECK-NEXT: .long [[BYTE3]]+2
; CHECK-NEXT: .long [[BYTE4]]+2
