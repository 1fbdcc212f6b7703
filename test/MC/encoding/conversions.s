# Conversions.
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

# CHECK: cvt_s_w f17, r2 # encoding: [0x30,0x00,0x22,0x06]
cvt_s_w f17, r2
# CHECK: cvt_s_w f31, r16 # encoding: [0x30,0x00,0xf0,0x07]
cvt_s_w f31, r16
# CHECK: cvt_s_w f10, r13 # encoding: [0x30,0x00,0x4d,0x05]
cvt_s_w f10, r13

# CHECK: cvt_s_wu f17, r2 # encoding: [0x31,0x00,0x22,0x06]
cvt_s_wu f17, r2
# CHECK: cvt_s_wu f31, r16 # encoding: [0x31,0x00,0xf0,0x07]
cvt_s_wu f31, r16
# CHECK: cvt_s_wu f10, r13 # encoding: [0x31,0x00,0x4d,0x05]
cvt_s_wu f10, r13

# CHECK: trunc_w_s r17, f2 # encoding: [0x32,0x00,0x22,0x06]
trunc_w_s r17, f2
# CHECK: trunc_w_s r31, f16 # encoding: [0x32,0x00,0xf0,0x07]
trunc_w_s r31, f16
# CHECK: trunc_w_s r10, f13 # encoding: [0x32,0x00,0x4d,0x05]
trunc_w_s r10, f13

# CHECK: trunc_wu_s r17, f2 # encoding: [0x33,0x00,0x22,0x06]
trunc_wu_s r17, f2
# CHECK: trunc_wu_s r31, f16 # encoding: [0x33,0x00,0xf0,0x07]
trunc_wu_s r31, f16
# CHECK: trunc_wu_s r10, f13 # encoding: [0x33,0x00,0x4d,0x05]
trunc_wu_s r10, f13

# CHECK: round_w_s r17, f2 # encoding: [0x34,0x00,0x22,0x06]
round_w_s r17, f2
# CHECK: round_w_s r31, f16 # encoding: [0x34,0x00,0xf0,0x07]
round_w_s r31, f16
# CHECK: round_w_s r10, f13 # encoding: [0x34,0x00,0x4d,0x05]
round_w_s r10, f13

# CHECK: floor_w_s r17, f2 # encoding: [0x35,0x00,0x22,0x06]
floor_w_s r17, f2
# CHECK: floor_w_s r31, f16 # encoding: [0x35,0x00,0xf0,0x07]
floor_w_s r31, f16
# CHECK: floor_w_s r10, f13 # encoding: [0x35,0x00,0x4d,0x05]
floor_w_s r10, f13

# CHECK: ceil_w_s r17, f2 # encoding: [0x36,0x00,0x22,0x06]
ceil_w_s r17, f2
# CHECK: ceil_w_s r31, f16 # encoding: [0x36,0x00,0xf0,0x07]
ceil_w_s r31, f16
# CHECK: ceil_w_s r10, f13 # encoding: [0x36,0x00,0x4d,0x05]
ceil_w_s r10, f13

# CHECK: trunc_s f17, f2 # encoding: [0x37,0x00,0x22,0x06]
trunc_s f17, f2
# CHECK: trunc_s f31, f16 # encoding: [0x37,0x00,0xf0,0x07]
trunc_s f31, f16
# CHECK: trunc_s f10, f13 # encoding: [0x37,0x00,0x4d,0x05]
trunc_s f10, f13

# CHECK: round_s f17, f2 # encoding: [0x38,0x00,0x22,0x06]
round_s f17, f2
# CHECK: round_s f31, f16 # encoding: [0x38,0x00,0xf0,0x07]
round_s f31, f16
# CHECK: round_s f10, f13 # encoding: [0x38,0x00,0x4d,0x05]
round_s f10, f13

# CHECK: floor_s f17, f2 # encoding: [0x39,0x00,0x22,0x06]
floor_s f17, f2
# CHECK: floor_s f31, f16 # encoding: [0x39,0x00,0xf0,0x07]
floor_s f31, f16
# CHECK: floor_s f10, f13 # encoding: [0x39,0x00,0x4d,0x05]
floor_s f10, f13

# CHECK: ceil_s f17, f2 # encoding: [0x3a,0x00,0x22,0x06]
ceil_s f17, f2
# CHECK: ceil_s f31, f16 # encoding: [0x3a,0x00,0xf0,0x07]
ceil_s f31, f16
# CHECK: ceil_s f10, f13 # encoding: [0x3a,0x00,0x4d,0x05]
ceil_s f10, f13
