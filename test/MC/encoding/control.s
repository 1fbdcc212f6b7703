# Control; every special register.
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

# CHECK: jr r31 # encoding: [0x01,0x00,0x1f,0x10]
jr r31
# CHECK: jr r5 # encoding: [0x01,0x00,0x05,0x10]
jr r5
# CHECK: jr r16 # encoding: [0x01,0x00,0x10,0x10]
jr r16

# CHECK: jalr r31 # encoding: [0x02,0x00,0x1f,0x10]
jalr r31
# CHECK: jalr r5 # encoding: [0x02,0x00,0x05,0x10]
jalr r5
# CHECK: jalr r16 # encoding: [0x02,0x00,0x10,0x10]
jalr r16

# CHECK: sleep r31 # encoding: [0x05,0x00,0x1f,0x10]
sleep r31
# CHECK: sleep r5 # encoding: [0x05,0x00,0x05,0x10]
sleep r5
# CHECK: sleep r16 # encoding: [0x05,0x00,0x10,0x10]
sleep r16

# CHECK: halt r31 # encoding: [0x06,0x00,0x1f,0x10]
halt r31
# CHECK: halt r5 # encoding: [0x06,0x00,0x05,0x10]
halt r5
# CHECK: halt r16 # encoding: [0x06,0x00,0x10,0x10]
halt r16

# CHECK: barrier # encoding: [0x03,0x00,0x00,0x10]
barrier

# CHECK: sync # encoding: [0x04,0x00,0x00,0x10]
sync

# CHECK: teq r2, r31 # encoding: [0x08,0xf8,0x02,0x10]
teq r2, r31
# CHECK: teq r16, r1 # encoding: [0x08,0x08,0x10,0x10]
teq r16, r1
# CHECK: teq r13, r4 # encoding: [0x08,0x20,0x0d,0x10]
teq r13, r4

# CHECK: tne r2, r31 # encoding: [0x09,0xf8,0x02,0x10]
tne r2, r31
# CHECK: tne r16, r1 # encoding: [0x09,0x08,0x10,0x10]
tne r16, r1
# CHECK: tne r13, r4 # encoding: [0x09,0x20,0x0d,0x10]
tne r13, r4

# CHECK: tlt r2, r31 # encoding: [0x0a,0xf8,0x02,0x10]
tlt r2, r31
# CHECK: tlt r16, r1 # encoding: [0x0a,0x08,0x10,0x10]
tlt r16, r1
# CHECK: tlt r13, r4 # encoding: [0x0a,0x20,0x0d,0x10]
tlt r13, r4

# CHECK: tge r2, r31 # encoding: [0x0b,0xf8,0x02,0x10]
tge r2, r31
# CHECK: tge r16, r1 # encoding: [0x0b,0x08,0x10,0x10]
tge r16, r1
# CHECK: tge r13, r4 # encoding: [0x0b,0x20,0x0d,0x10]
tge r13, r4

# CHECK: tltu r2, r31 # encoding: [0x0c,0xf8,0x02,0x10]
tltu r2, r31
# CHECK: tltu r16, r1 # encoding: [0x0c,0x08,0x10,0x10]
tltu r16, r1
# CHECK: tltu r13, r4 # encoding: [0x0c,0x20,0x0d,0x10]
tltu r13, r4

# CHECK: tgeu r2, r31 # encoding: [0x0d,0xf8,0x02,0x10]
tgeu r2, r31
# CHECK: tgeu r16, r1 # encoding: [0x0d,0x08,0x10,0x10]
tgeu r16, r1
# CHECK: tgeu r13, r4 # encoding: [0x0d,0x20,0x0d,0x10]
tgeu r13, r4

# CHECK: mfsr r1, thread # encoding: [0x10,0x00,0x20,0x10]
mfsr r1, thread
# CHECK: mfsr r4, tp # encoding: [0x10,0x08,0x80,0x10]
mfsr r4, tp
# CHECK: mfsr r7, tm # encoding: [0x10,0x10,0xe0,0x10]
mfsr r7, tm
# CHECK: mfsr r10, nthread # encoding: [0x10,0x18,0x40,0x11]
mfsr r10, nthread
# CHECK: mfsr r13, ntp # encoding: [0x10,0x20,0xa0,0x11]
mfsr r13, ntp
# CHECK: mfsr r16, ntm # encoding: [0x10,0x28,0x00,0x12]
mfsr r16, ntm
# CHECK: mfsr r19, lssize # encoding: [0x10,0x30,0x60,0x12]
mfsr r19, lssize
# CHECK: mfsr r22, cycle # encoding: [0x10,0x38,0xc0,0x12]
mfsr r22, cycle
# CHECK: mfsr r25, cycleh # encoding: [0x10,0x40,0x20,0x13]
mfsr r25, cycleh
# CHECK: mfsr r28, instret # encoding: [0x10,0x48,0x80,0x13]
mfsr r28, instret
# CHECK: mfsr r31, instreth # encoding: [0x10,0x50,0xe0,0x13]
mfsr r31, instreth
