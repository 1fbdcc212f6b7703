; RUN: not %llc_tp -O2 -o /dev/null < %s 2>&1 | FileCheck %s
; CHECK: error: {{.*}}musttail call with variadic, by-value or stack arguments

declare i32 @nine(i32, i32, i32, i32, i32, i32, i32, i32, i32)
define i32 @caller(i32 %a, i32, i32, i32, i32, i32, i32, i32, i32) {
  %r = musttail call i32 @nine(i32 %a, i32 %a, i32 %a, i32 %a, i32 %a, i32 %a, i32 %a, i32 %a, i32 %a)
  ret i32 %r
}
