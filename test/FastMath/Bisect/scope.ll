; tp-fp-scope keeps fast math where a file says so and makes the rest strict.

; RUN: rm -rf %t && mkdir %t
; RUN: printf '# a comment\n\n*\tfree\t*\nscope.c\tpart\t0,2-3\nother.c\tstrict\t*\n' > %t/some
; RUN: printf '*\t*\t*\n' > %t/all
; RUN: %fp_opt -tp-fp-scope=%t/some %s -S | FileCheck %s
; RUN: %fp_opt -tp-fp-scope=%t/all %s -S | sed 's/ "tp-fp-scope"="kept"//' > %t/kept.ll
; RUN: %fp_opt %s -S > %t/untouched.ll
; RUN: diff %t/kept.ll %t/untouched.ll

; What has been seen once stays as it is.
; RUN: %fp_opt -tp-fp-scope=%t/some %s -S | %fp_opt -tp-fp-scope=%t/all -S | FileCheck %s

; RUN: %fp_opt -tp-fp-scope-list=%t/list %s -S -o /dev/null
; RUN: FileCheck %s --check-prefix=LIST < %t/list
; LIST: {"source":"scope.c","function":"free","name":"free","local":false,"items":[{"what":"promises","flags":""},{"what":"fadd","flags":"fast"}]}
; LIST-NEXT: {"source":"scope.c","function":"part",{{.*}}"local":true,{{.*}}{"what":"fmul","flags":"arcp"},{"what":"call llvm.fmuladd.f32","flags":""},
; LIST-NEXT: "function":"strict"
; LIST-NOT: "function"

; RUN: printf 'a b c\n' > %t/spaces && printf '*\t*\t1-\n' > %t/items
; RUN: not %fp_opt -tp-fp-scope=%t/spaces %s -S 2>&1 | FileCheck %s --check-prefix=SPACES
; SPACES: error: {{.*}}spaces:1: expected source file, function and items, separated by tabs
; RUN: not %fp_opt -tp-fp-scope=%t/items %s -S 2>&1 | FileCheck %s --check-prefix=ITEMS
; ITEMS: error: {{.*}}items:1: '1-' are no items; write * or, for example, 0,3-5
; RUN: not %fp_opt -tp-fp-scope=%t/none %s -S 2>&1 | FileCheck %s --check-prefix=NONE
; NONE: error: cannot read the scope file '{{.*}}none': No such file or directory
; RUN: not %fp_opt -tp-fp-scope-list=%t/no/list %s -S 2>&1 | FileCheck %s --check-prefix=WRITE
; WRITE: error: cannot write the list of fast-math items '{{.*}}list': No such file or directory

source_filename = "scope.c"

; CHECK: define nofpclass(nan) float @free(float %a) #[[KEPT:[0-9]+]]
; CHECK-NEXT: fadd fast float
define nofpclass(nan) float @free(float %a) #0 {
  %b = fadd fast float %a, 1.0
  ret float %b
}

; CHECK: define internal float @part(float %a, float %b)
; CHECK-NEXT: %p = fmul arcp float %a, %b
; CHECK-NEXT: [[M:%.*]] = fmul float %p, %a
; CHECK-NEXT: %q = fadd float [[M]], %b
; CHECK-NEXT: %r = call nofpclass(inf) float @other(float nofpclass(inf) %q)
; CHECK-NEXT: %s = fcmp ninf olt float %r, %a
; CHECK-NEXT: %t = select i1 %s, float %r, float %a
define internal float @part(float %a, float %b) #1 {
  %p = fmul arcp float %a, %b
  %q = call float @llvm.fmuladd.f32(float %p, float %a, float %b)
  %r = call nofpclass(inf) float @other(float nofpclass(inf) %q)
  %s = fcmp ninf olt float %r, %a
  %t = select nsz i1 %s, float %r, float %a
  ret float %t
}

; CHECK: define float @strict(float %a) #[[STRICT:[0-9]+]]
; CHECK-NEXT: call float @other(float %a)
; CHECK-NEXT: fsub float
define nofpclass(inf) float @strict(float nofpclass(inf) %a) #0 {
  %b = call reassoc float @other(float nofpclass(nan) %a)
  %c = fsub nnan float %b, %a
  %d = call float @part(float %c, float %c)
  ret float %d
}

; A function without arithmetic has nothing to keep.
; CHECK: define void @nothing()
define void @nothing() #0 {
  ret void
}

; CHECK: declare float @other(float){{$}}
declare nofpclass(inf) float @other(float nofpclass(inf))
declare float @llvm.fmuladd.f32(float, float, float)

; CHECK-DAG: attributes #[[KEPT]] = { "no-nans-fp-math"="true" "tp-fp-scope"="kept" }
; CHECK-DAG: attributes #[[STRICT]] = { "tp-fp-scope"="strict" }
attributes #0 = { "no-nans-fp-math"="true" }
attributes #1 = { nounwind }
