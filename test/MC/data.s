# RUN: tp-mc -filetype=obj %s -o %t.o
# RUN: llvm-readobj -x .data %t.o | FileCheck %s
# RUN: llvm-readobj -x .text %t.o | FileCheck --check-prefix=TEXT %s
# RUN: tp-mc %s | tp-mc -filetype=obj -o %t2.o
# RUN: cmp %t.o %t2.o

.data
# CHECK: 0x00000000 01020000 03000000 04000000 05000000
.byte 1
.half 2
.hword 0x300
.balign 4
.word 4
.long 5
.space 3
.balign 16
# CHECK-NEXT: 0x00000010 00000000 00000000 00000000 00000000
# CHECK-NEXT: 0x00000020 efcdab89 67452301 ffffffff ffffffff
.8byte 0x0123456789abcdef
.quad -1
# CHECK-NEXT: 0x00000030 08070605 04030201 0000803f 00000000
.dword 0x0102030405060708
.float 1.0
.space 4
# CHECK-NEXT: 0x00000040 00000000 0000f03f 616200
.double 1.0
.asciz "ab"

# Code is padded with nops.
# TEXT: 0x00000000 0000001f 00000020 00000020 00000020
# TEXT-NEXT: 0x00000010 0000001f
.text
.4byte 0x1f000000
.balign 16
.4byte 0x1f000000
