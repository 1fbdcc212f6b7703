# Rows of the table, against what can be counted by hand: one thread on one TP,
# where a load from memory takes 100 cycles.

# RUN: tpcc -nostdlib %s -g -o %t.elf
# RUN: tpsim --chip 1x1 --set memory.latency_cycles=100 --quiet %t.elf --profile=%t.json
# RUN: tpsim --read-profile %t.json | FileCheck --strict-whitespace %s
# RUN: tpsim --read-profile %t.json --profile-by function --profile-sort instructions | FileCheck --strict-whitespace --check-prefix=FUNCTION %s
# RUN: tpsim --read-profile %t.json --profile-by path --profile-sort memory | FileCheck --strict-whitespace --check-prefix=PATH %s
# RUN: tpsim --read-profile %t.json --profile-by instruction --profile-sort latency --profile-rows 1 | FileCheck --strict-whitespace --check-prefix=INSTRUCTION %s

# 4 + 2 * 7 = 18 instructions; each addi of the callee waits 99 cycles for its
# load: 216 cycles.
#      CHECK:profile: percent of 216 thread-cycles (1 threads x 216 cycles);
#      CHECK:cycles  issued    data  memory  units  fetch   wait  access  in
# CHECK-NEXT:  92.6     0.9            91.7                               lines.s:[[#ADDI:]] called
# CHECK-NEXT:   0.9     0.9                                               lines.s:[[#ADDI-2]] called
# CHECK-NEXT:   0.9     0.9                                          100  lines.s:[[#ADDI-1]] called

#      FUNCTION:cycles  issued
# FUNCTION-NEXT:  98.1     6.5            91.7                          100  called
# FUNCTION-NEXT:   1.9     1.9                                               _start
#  FUNCTION-NOT:{{.}}

#      PATH:cycles  issued
# PATH-NEXT:  98.1     6.5            91.7                          100  called < _start
# PATH-NEXT:   1.9     1.9                                               _start

#      INSTRUCTION:cycles  issued
# INSTRUCTION-NEXT:   0.9     0.9                                          100  0x00010014 lw r5, 0(r4)  lines.s:{{[0-9]+}}
# INSTRUCTION-NEXT:  99.1     7.4            91.7                               (10 more)

  .globl _start
  .type _start, @function
_start:
  jal called
  jal called
  addi r4, r0, 0
  halt r4
  .type called, @function
called:
  lui r4, 2
  lw r5, 0(r4)
  addi r5, r5, 1
  addi r6, r0, 1
  addi r6, r6, 1
  addi r6, r6, 1
  jr r31
