# Errors that show only when all addresses are known.
# RUN: not tp-mc -filetype=obj -o /dev/null %s 2>&1 | FileCheck --implicit-check-not=error: %s

# CHECK: :[[@LINE+1]]:13: error: branch target out of range: it is 131072 bytes away, the range is [-131072, 131068]
beq r4, r5, far
# In range, just so.
beq r4, r5, far
# CHECK: :[[@LINE+1]]:14: error: the immediate is not a constant; write %hi(...) or %lo(...) for half an address
addi r4, r5, elsewhere
# CHECK: :[[@LINE+1]]:17: error: value 131060 is out of the range [0, 65535]
ori r4, r5, far - .
# CHECK: :[[@LINE+1]]:18: error: value 131056 is out of the range [-32768, 32767]
addi r4, r5, far - .
# CHECK: :[[@LINE+1]]:8: error: branch target is not a multiple of 4 bytes away
jal far+2
.space 131048
far:
# CHECK: :[[@LINE+1]]:11: error: value 131072 is out of the range [-128, 255]
.byte far - start
# CHECK: :[[@LINE+1]]:8: error: the TP has no relocation for this expression
.8byte elsewhere
# CHECK: :[[@LINE+1]]:18: error: the TP has no relocation for this expression
.2byte elsewhere - .
.set start, far - 131072
