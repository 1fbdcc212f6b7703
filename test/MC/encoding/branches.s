# Branches; the target is the distance in bytes, encoded in words.
# The expected bytes were worked out by hand from the format:
# I: opcode 31-26, a 25-21, b 20-16, immediate 15-0
#
# RUN: tp-mc -no-aliases -show-encoding %s | FileCheck %s
#
# Round trip: the object's disassembly makes the same object.
# RUN: tp-mc -filetype=obj %s -o %t.o
# RUN: tp-objdump --assembly %t.o > %t.again.s
# RUN: tp-mc -filetype=obj %t.again.s -o %t.again.o
# RUN: cmp %t.o %t.again.o
# RUN: tp-objdump --assembly -no-aliases %t.o > %t.plain.s
# RUN: tp-mc -filetype=obj %t.plain.s -o %t.plain.o
# RUN: cmp %t.o %t.plain.o

# CHECK: beq r17, r2, -131072 # encoding: [0x00,0x80,0x22,0xc2]
beq r17, r2, -131072
# CHECK: beq r31, r16, 131068 # encoding: [0xff,0x7f,0xf0,0xc3]
beq r31, r16, 131068
# CHECK: beq r10, r13, -8 # encoding: [0xfe,0xff,0x4d,0xc1]
beq r10, r13, -8

# CHECK: bne r17, r2, -131072 # encoding: [0x00,0x80,0x22,0xc6]
bne r17, r2, -131072
# CHECK: bne r31, r16, 131068 # encoding: [0xff,0x7f,0xf0,0xc7]
bne r31, r16, 131068
# CHECK: bne r10, r13, -8 # encoding: [0xfe,0xff,0x4d,0xc5]
bne r10, r13, -8

# CHECK: blt r17, r2, -131072 # encoding: [0x00,0x80,0x22,0xca]
blt r17, r2, -131072
# CHECK: blt r31, r16, 131068 # encoding: [0xff,0x7f,0xf0,0xcb]
blt r31, r16, 131068
# CHECK: blt r10, r13, -8 # encoding: [0xfe,0xff,0x4d,0xc9]
blt r10, r13, -8

# CHECK: bge r17, r2, -131072 # encoding: [0x00,0x80,0x22,0xce]
bge r17, r2, -131072
# CHECK: bge r31, r16, 131068 # encoding: [0xff,0x7f,0xf0,0xcf]
bge r31, r16, 131068
# CHECK: bge r10, r13, -8 # encoding: [0xfe,0xff,0x4d,0xcd]
bge r10, r13, -8

# CHECK: bltu r17, r2, -131072 # encoding: [0x00,0x80,0x22,0xd2]
bltu r17, r2, -131072
# CHECK: bltu r31, r16, 131068 # encoding: [0xff,0x7f,0xf0,0xd3]
bltu r31, r16, 131068
# CHECK: bltu r10, r13, -8 # encoding: [0xfe,0xff,0x4d,0xd1]
bltu r10, r13, -8

# CHECK: bgeu r17, r2, -131072 # encoding: [0x00,0x80,0x22,0xd6]
bgeu r17, r2, -131072
# CHECK: bgeu r31, r16, 131068 # encoding: [0xff,0x7f,0xf0,0xd7]
bgeu r31, r16, 131068
# CHECK: bgeu r10, r13, -8 # encoding: [0xfe,0xff,0x4d,0xd5]
bgeu r10, r13, -8

# CHECK: bltzal r17, -131072 # encoding: [0x00,0x80,0x20,0xda]
bltzal r17, -131072
# CHECK: bltzal r31, 131068 # encoding: [0xff,0x7f,0xe0,0xdb]
bltzal r31, 131068
# CHECK: bltzal r10, -8 # encoding: [0xfe,0xff,0x40,0xd9]
bltzal r10, -8

# CHECK: bgezal r17, -131072 # encoding: [0x00,0x80,0x20,0xde]
bgezal r17, -131072
# CHECK: bgezal r31, 131068 # encoding: [0xff,0x7f,0xe0,0xdf]
bgezal r31, 131068
# CHECK: bgezal r10, -8 # encoding: [0xfe,0xff,0x40,0xdd]
bgezal r10, -8
