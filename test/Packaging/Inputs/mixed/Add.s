  .globl addTwo
addTwo:
  addi r4, r4, 2
  jr ra
