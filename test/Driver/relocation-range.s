# Values that do not fit into an instruction, with their place.
#
# RUN: not tpcc -nostdlib %s -o %t.elf 2>&1 | FileCheck %s

  .globl _start
  .type _start,@function
_start:
# CHECK: relocation-range.s:(_start+0x0): relocation R_TP_PC16 to 'distant' is out of range: {{[0-9]+}} is not in [-131072, 131071]
  beq r0, r0, distant
  lui r4, %hi(bytes)
  halt r0
  .size _start, .-_start
# CHECK: relocation-range.s:(bytes+0x0): relocation R_TP_8 to 'distant' is out of range
  .data
  .globl bytes
  .type bytes,@object
bytes:
  .byte distant
  .size bytes, 1
  .section .text.distant,"ax",@progbits
  .space 0x40000
  .globl distant
distant:
  halt r0
