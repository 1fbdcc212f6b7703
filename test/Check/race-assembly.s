# Assembly says of its loads and stores which are atomic.

# RUN: tpcc -nostdlib %s -o %t.elf
# RUN: tpsim --chip 1x1 --set tm.tps=2 --functional --quiet --check=race %t.elf \
# RUN:   2>&1 | count 0
# RUN: tpcc -nostdlib -DPLAIN -x assembler-with-cpp %s -o %t.plain.elf
# RUN: not tpsim --chip 1x1 --set tm.tps=2 --functional --quiet --check=race \
# RUN:   %t.plain.elf 2>&1 | FileCheck %s
# CHECK: data-race: load and store by two threads

        .globl _start
_start:
        lui r5, %hi(word)
        addi r5, r5, %lo(word)
        mfsr r6, thread
        bne r6, r0, reader
writer: sw r6, 0(r5)
        halt r0
reader: lw r4, 0(r5)
        halt r0

#ifndef PLAIN
        .section .tp_atomics, ""
        .word writer
        .word reader + 1
#endif

        .data
word:   .word 0
