# Atomics and streams: rd, rt, (rs) with b = rs, c = rt.
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

# CHECK: atom_add r17, r31, (r2) # encoding: [0x00,0xf8,0x22,0x0e]
atom_add r17, r31, (r2)
# CHECK: atom_add r31, r1, (r16) # encoding: [0x00,0x08,0xf0,0x0f]
atom_add r31, r1, (r16)
# CHECK: atom_add r10, r4, (r13) # encoding: [0x00,0x20,0x4d,0x0d]
atom_add r10, r4, (r13)

# CHECK: atom_and r17, r31, (r2) # encoding: [0x01,0xf8,0x22,0x0e]
atom_and r17, r31, (r2)
# CHECK: atom_and r31, r1, (r16) # encoding: [0x01,0x08,0xf0,0x0f]
atom_and r31, r1, (r16)
# CHECK: atom_and r10, r4, (r13) # encoding: [0x01,0x20,0x4d,0x0d]
atom_and r10, r4, (r13)

# CHECK: atom_or r17, r31, (r2) # encoding: [0x02,0xf8,0x22,0x0e]
atom_or r17, r31, (r2)
# CHECK: atom_or r31, r1, (r16) # encoding: [0x02,0x08,0xf0,0x0f]
atom_or r31, r1, (r16)
# CHECK: atom_or r10, r4, (r13) # encoding: [0x02,0x20,0x4d,0x0d]
atom_or r10, r4, (r13)

# CHECK: atom_xor r17, r31, (r2) # encoding: [0x03,0xf8,0x22,0x0e]
atom_xor r17, r31, (r2)
# CHECK: atom_xor r31, r1, (r16) # encoding: [0x03,0x08,0xf0,0x0f]
atom_xor r31, r1, (r16)
# CHECK: atom_xor r10, r4, (r13) # encoding: [0x03,0x20,0x4d,0x0d]
atom_xor r10, r4, (r13)

# CHECK: atom_min r17, r31, (r2) # encoding: [0x04,0xf8,0x22,0x0e]
atom_min r17, r31, (r2)
# CHECK: atom_min r31, r1, (r16) # encoding: [0x04,0x08,0xf0,0x0f]
atom_min r31, r1, (r16)
# CHECK: atom_min r10, r4, (r13) # encoding: [0x04,0x20,0x4d,0x0d]
atom_min r10, r4, (r13)

# CHECK: atom_max r17, r31, (r2) # encoding: [0x05,0xf8,0x22,0x0e]
atom_max r17, r31, (r2)
# CHECK: atom_max r31, r1, (r16) # encoding: [0x05,0x08,0xf0,0x0f]
atom_max r31, r1, (r16)
# CHECK: atom_max r10, r4, (r13) # encoding: [0x05,0x20,0x4d,0x0d]
atom_max r10, r4, (r13)

# CHECK: atom_minu r17, r31, (r2) # encoding: [0x06,0xf8,0x22,0x0e]
atom_minu r17, r31, (r2)
# CHECK: atom_minu r31, r1, (r16) # encoding: [0x06,0x08,0xf0,0x0f]
atom_minu r31, r1, (r16)
# CHECK: atom_minu r10, r4, (r13) # encoding: [0x06,0x20,0x4d,0x0d]
atom_minu r10, r4, (r13)

# CHECK: atom_maxu r17, r31, (r2) # encoding: [0x07,0xf8,0x22,0x0e]
atom_maxu r17, r31, (r2)
# CHECK: atom_maxu r31, r1, (r16) # encoding: [0x07,0x08,0xf0,0x0f]
atom_maxu r31, r1, (r16)
# CHECK: atom_maxu r10, r4, (r13) # encoding: [0x07,0x20,0x4d,0x0d]
atom_maxu r10, r4, (r13)

# CHECK: atom_swap r17, r31, (r2) # encoding: [0x08,0xf8,0x22,0x0e]
atom_swap r17, r31, (r2)
# CHECK: atom_swap r31, r1, (r16) # encoding: [0x08,0x08,0xf0,0x0f]
atom_swap r31, r1, (r16)
# CHECK: atom_swap r10, r4, (r13) # encoding: [0x08,0x20,0x4d,0x0d]
atom_swap r10, r4, (r13)

# CHECK: atom_cas r17, r31, (r2) # encoding: [0x09,0xf8,0x22,0x0e]
atom_cas r17, r31, (r2)
# CHECK: atom_cas r31, r1, (r16) # encoding: [0x09,0x08,0xf0,0x0f]
atom_cas r31, r1, (r16)
# CHECK: atom_cas r10, r4, (r13) # encoding: [0x09,0x20,0x4d,0x0d]
atom_cas r10, r4, (r13)

# CHECK: stream_push r17, r31, (r2) # encoding: [0x10,0xf8,0x22,0x0e]
stream_push r17, r31, (r2)
# CHECK: stream_push r31, r1, (r16) # encoding: [0x10,0x08,0xf0,0x0f]
stream_push r31, r1, (r16)
# CHECK: stream_push r10, r4, (r13) # encoding: [0x10,0x20,0x4d,0x0d]
stream_push r10, r4, (r13)

# CHECK: stream_pop r17, (r2) # encoding: [0x11,0x00,0x22,0x0e]
stream_pop r17, (r2)
# CHECK: stream_pop r31, (r16) # encoding: [0x11,0x00,0xf0,0x0f]
stream_pop r31, (r16)
# CHECK: stream_pop r10, (r13) # encoding: [0x11,0x00,0x4d,0x0d]
stream_pop r10, (r13)
