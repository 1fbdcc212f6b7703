# Bytes to instructions.
# RUN: tp-mc -disassemble %s | FileCheck %s

# CHECK: addi r4, r0, 5
05 00 80 20
# CHECK-NEXT: ret
0x01 0x00 0x1f 0x10
# CHECK-NEXT: beq r17, r2, -8
[0xfe,0xff,0x22,0xc2]
# CHECK-NEXT: add r17, r2, r31
# CHECK-NEXT: nop
01 f8 22 02 00 00 00 20
