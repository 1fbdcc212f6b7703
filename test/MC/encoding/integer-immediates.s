# Integer instructions with an immediate.
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

# CHECK: addi r17, r2, -32768 # encoding: [0x00,0x80,0x22,0x22]
addi r17, r2, -32768
# CHECK: addi r31, r16, 32767 # encoding: [0xff,0x7f,0xf0,0x23]
addi r31, r16, 32767
# CHECK: addi r10, r13, -2 # encoding: [0xfe,0xff,0x4d,0x21]
addi r10, r13, -2

# CHECK: andi r17, r2, 0 # encoding: [0x00,0x00,0x22,0x26]
andi r17, r2, 0
# CHECK: andi r31, r16, 65535 # encoding: [0xff,0xff,0xf0,0x27]
andi r31, r16, 65535
# CHECK: andi r10, r13, 32769 # encoding: [0x01,0x80,0x4d,0x25]
andi r10, r13, 32769

# CHECK: ori r17, r2, 0 # encoding: [0x00,0x00,0x22,0x2a]
ori r17, r2, 0
# CHECK: ori r31, r16, 65535 # encoding: [0xff,0xff,0xf0,0x2b]
ori r31, r16, 65535
# CHECK: ori r10, r13, 32769 # encoding: [0x01,0x80,0x4d,0x29]
ori r10, r13, 32769

# CHECK: xori r17, r2, 0 # encoding: [0x00,0x00,0x22,0x2e]
xori r17, r2, 0
# CHECK: xori r31, r16, 65535 # encoding: [0xff,0xff,0xf0,0x2f]
xori r31, r16, 65535
# CHECK: xori r10, r13, 32769 # encoding: [0x01,0x80,0x4d,0x2d]
xori r10, r13, 32769

# CHECK: slti r17, r2, -32768 # encoding: [0x00,0x80,0x22,0x32]
slti r17, r2, -32768
# CHECK: slti r31, r16, 32767 # encoding: [0xff,0x7f,0xf0,0x33]
slti r31, r16, 32767
# CHECK: slti r10, r13, -2 # encoding: [0xfe,0xff,0x4d,0x31]
slti r10, r13, -2

# CHECK: sltiu r17, r2, -32768 # encoding: [0x00,0x80,0x22,0x36]
sltiu r17, r2, -32768
# CHECK: sltiu r31, r16, 32767 # encoding: [0xff,0x7f,0xf0,0x37]
sltiu r31, r16, 32767
# CHECK: sltiu r10, r13, -2 # encoding: [0xfe,0xff,0x4d,0x35]
sltiu r10, r13, -2

# CHECK: lui r17, 0 # encoding: [0x00,0x00,0x20,0x3a]
lui r17, 0
# CHECK: lui r31, 65535 # encoding: [0xff,0xff,0xe0,0x3b]
lui r31, 65535
# CHECK: lui r10, 4660 # encoding: [0x34,0x12,0x40,0x39]
lui r10, 4660
