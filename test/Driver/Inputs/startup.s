  .text
  .globl _start
  .type _start,@function
_start:
  jal main
  halt r4
  .size _start, .-_start
