# Float arithmetic and moves.
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

# CHECK: add_s f17, f2, f31 # encoding: [0x01,0xf8,0x22,0x06]
add_s f17, f2, f31
# CHECK: add_s f31, f16, f1 # encoding: [0x01,0x08,0xf0,0x07]
add_s f31, f16, f1
# CHECK: add_s f10, f13, f4 # encoding: [0x01,0x20,0x4d,0x05]
add_s f10, f13, f4

# CHECK: sub_s f17, f2, f31 # encoding: [0x02,0xf8,0x22,0x06]
sub_s f17, f2, f31
# CHECK: sub_s f31, f16, f1 # encoding: [0x02,0x08,0xf0,0x07]
sub_s f31, f16, f1
# CHECK: sub_s f10, f13, f4 # encoding: [0x02,0x20,0x4d,0x05]
sub_s f10, f13, f4

# CHECK: mul_s f17, f2, f31 # encoding: [0x03,0xf8,0x22,0x06]
mul_s f17, f2, f31
# CHECK: mul_s f31, f16, f1 # encoding: [0x03,0x08,0xf0,0x07]
mul_s f31, f16, f1
# CHECK: mul_s f10, f13, f4 # encoding: [0x03,0x20,0x4d,0x05]
mul_s f10, f13, f4

# CHECK: div_s f17, f2, f31 # encoding: [0x04,0xf8,0x22,0x06]
div_s f17, f2, f31
# CHECK: div_s f31, f16, f1 # encoding: [0x04,0x08,0xf0,0x07]
div_s f31, f16, f1
# CHECK: div_s f10, f13, f4 # encoding: [0x04,0x20,0x4d,0x05]
div_s f10, f13, f4

# CHECK: min_s f17, f2, f31 # encoding: [0x08,0xf8,0x22,0x06]
min_s f17, f2, f31
# CHECK: min_s f31, f16, f1 # encoding: [0x08,0x08,0xf0,0x07]
min_s f31, f16, f1
# CHECK: min_s f10, f13, f4 # encoding: [0x08,0x20,0x4d,0x05]
min_s f10, f13, f4

# CHECK: max_s f17, f2, f31 # encoding: [0x09,0xf8,0x22,0x06]
max_s f17, f2, f31
# CHECK: max_s f31, f16, f1 # encoding: [0x09,0x08,0xf0,0x07]
max_s f31, f16, f1
# CHECK: max_s f10, f13, f4 # encoding: [0x09,0x20,0x4d,0x05]
max_s f10, f13, f4

# CHECK: rcp_s f17, f2 # encoding: [0x05,0x00,0x22,0x06]
rcp_s f17, f2
# CHECK: rcp_s f31, f16 # encoding: [0x05,0x00,0xf0,0x07]
rcp_s f31, f16
# CHECK: rcp_s f10, f13 # encoding: [0x05,0x00,0x4d,0x05]
rcp_s f10, f13

# CHECK: sqrt_s f17, f2 # encoding: [0x06,0x00,0x22,0x06]
sqrt_s f17, f2
# CHECK: sqrt_s f31, f16 # encoding: [0x06,0x00,0xf0,0x07]
sqrt_s f31, f16
# CHECK: sqrt_s f10, f13 # encoding: [0x06,0x00,0x4d,0x05]
sqrt_s f10, f13

# CHECK: rsqrt_s f17, f2 # encoding: [0x07,0x00,0x22,0x06]
rsqrt_s f17, f2
# CHECK: rsqrt_s f31, f16 # encoding: [0x07,0x00,0xf0,0x07]
rsqrt_s f31, f16
# CHECK: rsqrt_s f10, f13 # encoding: [0x07,0x00,0x4d,0x05]
rsqrt_s f10, f13

# CHECK: sin_s f17, f2 # encoding: [0x0a,0x00,0x22,0x06]
sin_s f17, f2
# CHECK: sin_s f31, f16 # encoding: [0x0a,0x00,0xf0,0x07]
sin_s f31, f16
# CHECK: sin_s f10, f13 # encoding: [0x0a,0x00,0x4d,0x05]
sin_s f10, f13

# CHECK: cos_s f17, f2 # encoding: [0x0b,0x00,0x22,0x06]
cos_s f17, f2
# CHECK: cos_s f31, f16 # encoding: [0x0b,0x00,0xf0,0x07]
cos_s f31, f16
# CHECK: cos_s f10, f13 # encoding: [0x0b,0x00,0x4d,0x05]
cos_s f10, f13

# CHECK: abs_s f17, f2 # encoding: [0x0c,0x00,0x22,0x06]
abs_s f17, f2
# CHECK: abs_s f31, f16 # encoding: [0x0c,0x00,0xf0,0x07]
abs_s f31, f16
# CHECK: abs_s f10, f13 # encoding: [0x0c,0x00,0x4d,0x05]
abs_s f10, f13

# CHECK: neg_s f17, f2 # encoding: [0x0d,0x00,0x22,0x06]
neg_s f17, f2
# CHECK: neg_s f31, f16 # encoding: [0x0d,0x00,0xf0,0x07]
neg_s f31, f16
# CHECK: neg_s f10, f13 # encoding: [0x0d,0x00,0x4d,0x05]
neg_s f10, f13

# CHECK: mov_s f17, f2 # encoding: [0x0e,0x00,0x22,0x06]
mov_s f17, f2
# CHECK: mov_s f31, f16 # encoding: [0x0e,0x00,0xf0,0x07]
mov_s f31, f16
# CHECK: mov_s f10, f13 # encoding: [0x0e,0x00,0x4d,0x05]
mov_s f10, f13

# CHECK: mfc1 r17, f2 # encoding: [0x0f,0x00,0x22,0x06]
mfc1 r17, f2
# CHECK: mfc1 r31, f16 # encoding: [0x0f,0x00,0xf0,0x07]
mfc1 r31, f16
# CHECK: mfc1 r10, f13 # encoding: [0x0f,0x00,0x4d,0x05]
mfc1 r10, f13

# CHECK: mtc1 f17, r2 # encoding: [0x10,0x00,0x22,0x06]
mtc1 f17, r2
# CHECK: mtc1 f31, r16 # encoding: [0x10,0x00,0xf0,0x07]
mtc1 f31, r16
# CHECK: mtc1 f10, r13 # encoding: [0x10,0x00,0x4d,0x05]
mtc1 f10, r13

# CHECK: movn_s f17, f2, r31 # encoding: [0x11,0xf8,0x22,0x06]
movn_s f17, f2, r31
# CHECK: movn_s f31, f16, r1 # encoding: [0x11,0x08,0xf0,0x07]
movn_s f31, f16, r1
# CHECK: movn_s f10, f13, r4 # encoding: [0x11,0x20,0x4d,0x05]
movn_s f10, f13, r4

# CHECK: movz_s f17, f2, r31 # encoding: [0x12,0xf8,0x22,0x06]
movz_s f17, f2, r31
# CHECK: movz_s f31, f16, r1 # encoding: [0x12,0x08,0xf0,0x07]
movz_s f31, f16, r1
# CHECK: movz_s f10, f13, r4 # encoding: [0x12,0x20,0x4d,0x05]
movz_s f10, f13, r4

# CHECK: madd_s f17, f2, f31 # encoding: [0x13,0xf8,0x22,0x06]
madd_s f17, f2, f31
# CHECK: madd_s f31, f16, f1 # encoding: [0x13,0x08,0xf0,0x07]
madd_s f31, f16, f1
# CHECK: madd_s f10, f13, f4 # encoding: [0x13,0x20,0x4d,0x05]
madd_s f10, f13, f4
