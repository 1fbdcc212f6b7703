# Integer instructions between registers.
# The expected bytes were worked out by hand from the format:
# R: opcode 31-26, a 25-21, b 20-16, c 15-11, d 10-6, funct 5-0
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

# CHECK: add r17, r2, r31 # encoding: [0x01,0xf8,0x22,0x02]
add r17, r2, r31
# CHECK: add r31, r16, r1 # encoding: [0x01,0x08,0xf0,0x03]
add r31, r16, r1
# CHECK: add r10, r13, r4 # encoding: [0x01,0x20,0x4d,0x01]
add r10, r13, r4

# CHECK: sub r17, r2, r31 # encoding: [0x02,0xf8,0x22,0x02]
sub r17, r2, r31
# CHECK: sub r31, r16, r1 # encoding: [0x02,0x08,0xf0,0x03]
sub r31, r16, r1
# CHECK: sub r10, r13, r4 # encoding: [0x02,0x20,0x4d,0x01]
sub r10, r13, r4

# CHECK: and r17, r2, r31 # encoding: [0x03,0xf8,0x22,0x02]
and r17, r2, r31
# CHECK: and r31, r16, r1 # encoding: [0x03,0x08,0xf0,0x03]
and r31, r16, r1
# CHECK: and r10, r13, r4 # encoding: [0x03,0x20,0x4d,0x01]
and r10, r13, r4

# CHECK: or r17, r2, r31 # encoding: [0x04,0xf8,0x22,0x02]
or r17, r2, r31
# CHECK: or r31, r16, r1 # encoding: [0x04,0x08,0xf0,0x03]
or r31, r16, r1
# CHECK: or r10, r13, r4 # encoding: [0x04,0x20,0x4d,0x01]
or r10, r13, r4

# CHECK: xor r17, r2, r31 # encoding: [0x05,0xf8,0x22,0x02]
xor r17, r2, r31
# CHECK: xor r31, r16, r1 # encoding: [0x05,0x08,0xf0,0x03]
xor r31, r16, r1
# CHECK: xor r10, r13, r4 # encoding: [0x05,0x20,0x4d,0x01]
xor r10, r13, r4

# CHECK: nor r17, r2, r31 # encoding: [0x06,0xf8,0x22,0x02]
nor r17, r2, r31
# CHECK: nor r31, r16, r1 # encoding: [0x06,0x08,0xf0,0x03]
nor r31, r16, r1
# CHECK: nor r10, r13, r4 # encoding: [0x06,0x20,0x4d,0x01]
nor r10, r13, r4

# CHECK: slt r17, r2, r31 # encoding: [0x07,0xf8,0x22,0x02]
slt r17, r2, r31
# CHECK: slt r31, r16, r1 # encoding: [0x07,0x08,0xf0,0x03]
slt r31, r16, r1
# CHECK: slt r10, r13, r4 # encoding: [0x07,0x20,0x4d,0x01]
slt r10, r13, r4

# CHECK: sltu r17, r2, r31 # encoding: [0x08,0xf8,0x22,0x02]
sltu r17, r2, r31
# CHECK: sltu r31, r16, r1 # encoding: [0x08,0x08,0xf0,0x03]
sltu r31, r16, r1
# CHECK: sltu r10, r13, r4 # encoding: [0x08,0x20,0x4d,0x01]
sltu r10, r13, r4

# CHECK: addc r17, r2, r31 # encoding: [0x09,0xf8,0x22,0x02]
addc r17, r2, r31
# CHECK: addc r31, r16, r1 # encoding: [0x09,0x08,0xf0,0x03]
addc r31, r16, r1
# CHECK: addc r10, r13, r4 # encoding: [0x09,0x20,0x4d,0x01]
addc r10, r13, r4

# CHECK: subc r17, r2, r31 # encoding: [0x0a,0xf8,0x22,0x02]
subc r17, r2, r31
# CHECK: subc r31, r16, r1 # encoding: [0x0a,0x08,0xf0,0x03]
subc r31, r16, r1
# CHECK: subc r10, r13, r4 # encoding: [0x0a,0x20,0x4d,0x01]
subc r10, r13, r4

# CHECK: mul r17, r2, r31 # encoding: [0x10,0xf8,0x22,0x02]
mul r17, r2, r31
# CHECK: mul r31, r16, r1 # encoding: [0x10,0x08,0xf0,0x03]
mul r31, r16, r1
# CHECK: mul r10, r13, r4 # encoding: [0x10,0x20,0x4d,0x01]
mul r10, r13, r4

# CHECK: mulh r17, r2, r31 # encoding: [0x11,0xf8,0x22,0x02]
mulh r17, r2, r31
# CHECK: mulh r31, r16, r1 # encoding: [0x11,0x08,0xf0,0x03]
mulh r31, r16, r1
# CHECK: mulh r10, r13, r4 # encoding: [0x11,0x20,0x4d,0x01]
mulh r10, r13, r4

# CHECK: mulhu r17, r2, r31 # encoding: [0x12,0xf8,0x22,0x02]
mulhu r17, r2, r31
# CHECK: mulhu r31, r16, r1 # encoding: [0x12,0x08,0xf0,0x03]
mulhu r31, r16, r1
# CHECK: mulhu r10, r13, r4 # encoding: [0x12,0x20,0x4d,0x01]
mulhu r10, r13, r4

# CHECK: div r17, r2, r31 # encoding: [0x14,0xf8,0x22,0x02]
div r17, r2, r31
# CHECK: div r31, r16, r1 # encoding: [0x14,0x08,0xf0,0x03]
div r31, r16, r1
# CHECK: div r10, r13, r4 # encoding: [0x14,0x20,0x4d,0x01]
div r10, r13, r4

# CHECK: divu r17, r2, r31 # encoding: [0x15,0xf8,0x22,0x02]
divu r17, r2, r31
# CHECK: divu r31, r16, r1 # encoding: [0x15,0x08,0xf0,0x03]
divu r31, r16, r1
# CHECK: divu r10, r13, r4 # encoding: [0x15,0x20,0x4d,0x01]
divu r10, r13, r4

# CHECK: rem r17, r2, r31 # encoding: [0x16,0xf8,0x22,0x02]
rem r17, r2, r31
# CHECK: rem r31, r16, r1 # encoding: [0x16,0x08,0xf0,0x03]
rem r31, r16, r1
# CHECK: rem r10, r13, r4 # encoding: [0x16,0x20,0x4d,0x01]
rem r10, r13, r4

# CHECK: remu r17, r2, r31 # encoding: [0x17,0xf8,0x22,0x02]
remu r17, r2, r31
# CHECK: remu r31, r16, r1 # encoding: [0x17,0x08,0xf0,0x03]
remu r31, r16, r1
# CHECK: remu r10, r13, r4 # encoding: [0x17,0x20,0x4d,0x01]
remu r10, r13, r4

# CHECK: sllv r17, r2, r31 # encoding: [0x24,0xf8,0x22,0x02]
sllv r17, r2, r31
# CHECK: sllv r31, r16, r1 # encoding: [0x24,0x08,0xf0,0x03]
sllv r31, r16, r1
# CHECK: sllv r10, r13, r4 # encoding: [0x24,0x20,0x4d,0x01]
sllv r10, r13, r4

# CHECK: srlv r17, r2, r31 # encoding: [0x25,0xf8,0x22,0x02]
srlv r17, r2, r31
# CHECK: srlv r31, r16, r1 # encoding: [0x25,0x08,0xf0,0x03]
srlv r31, r16, r1
# CHECK: srlv r10, r13, r4 # encoding: [0x25,0x20,0x4d,0x01]
srlv r10, r13, r4

# CHECK: srav r17, r2, r31 # encoding: [0x26,0xf8,0x22,0x02]
srav r17, r2, r31
# CHECK: srav r31, r16, r1 # encoding: [0x26,0x08,0xf0,0x03]
srav r31, r16, r1
# CHECK: srav r10, r13, r4 # encoding: [0x26,0x20,0x4d,0x01]
srav r10, r13, r4

# CHECK: rotrv r17, r2, r31 # encoding: [0x27,0xf8,0x22,0x02]
rotrv r17, r2, r31
# CHECK: rotrv r31, r16, r1 # encoding: [0x27,0x08,0xf0,0x03]
rotrv r31, r16, r1
# CHECK: rotrv r10, r13, r4 # encoding: [0x27,0x20,0x4d,0x01]
rotrv r10, r13, r4

# CHECK: movn r17, r2, r31 # encoding: [0x2d,0xf8,0x22,0x02]
movn r17, r2, r31
# CHECK: movn r31, r16, r1 # encoding: [0x2d,0x08,0xf0,0x03]
movn r31, r16, r1
# CHECK: movn r10, r13, r4 # encoding: [0x2d,0x20,0x4d,0x01]
movn r10, r13, r4

# CHECK: movz r17, r2, r31 # encoding: [0x2e,0xf8,0x22,0x02]
movz r17, r2, r31
# CHECK: movz r31, r16, r1 # encoding: [0x2e,0x08,0xf0,0x03]
movz r31, r16, r1
# CHECK: movz r10, r13, r4 # encoding: [0x2e,0x20,0x4d,0x01]
movz r10, r13, r4

# CHECK: clz r17, r2 # encoding: [0x28,0x00,0x22,0x02]
clz r17, r2
# CHECK: clz r31, r16 # encoding: [0x28,0x00,0xf0,0x03]
clz r31, r16
# CHECK: clz r10, r13 # encoding: [0x28,0x00,0x4d,0x01]
clz r10, r13

# CHECK: seb r17, r2 # encoding: [0x29,0x00,0x22,0x02]
seb r17, r2
# CHECK: seb r31, r16 # encoding: [0x29,0x00,0xf0,0x03]
seb r31, r16
# CHECK: seb r10, r13 # encoding: [0x29,0x00,0x4d,0x01]
seb r10, r13

# CHECK: seh r17, r2 # encoding: [0x2a,0x00,0x22,0x02]
seh r17, r2
# CHECK: seh r31, r16 # encoding: [0x2a,0x00,0xf0,0x03]
seh r31, r16
# CHECK: seh r10, r13 # encoding: [0x2a,0x00,0x4d,0x01]
seh r10, r13
