  .globl addTwo
addTwo:
  addi r2, r4, 2
  jr ra
