; A musttail call whose result comes through memory that the caller makes
; cannot be one.
; RUN: not %llc_tp -O2 -o /dev/null < %s 2>&1 | FileCheck %s
; CHECK: error: {{.*}}in function forward {{.*}}: musttail call of a function that returns more than two words

declare i128 @wide(i128)

define i128 @forward(i128 %a) {
  %r = musttail call i128 @wide(i128 %a)
  ret i128 %r
}
