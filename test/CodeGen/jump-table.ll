; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

define i32 @many(i32 %x, ptr %p) {
; CHECK-LABEL: many:
; CHECK: addi r12, r0, 69
; CHECK-NEXT: bltu r12, r4, .LBB0_73
; CHECK: lui r13, %hi(.LJTI0_0)
; CHECK-NEXT: sll r12, r4, 2
; CHECK-NEXT: addi r13, r13, %lo(.LJTI0_0)
; CHECK-NEXT: lwx r12, r12(r13)
; CHECK-NEXT: jr r12
; CHECK-NEXT: .LBB0_2:
; CHECK-NEXT: addi r12, r0, 3
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_3:
; CHECK-NEXT: addi r12, r0, 353
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_4:
; CHECK-NEXT: addi r12, r0, 304
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_5:
; CHECK-NEXT: addi r12, r0, 465
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_6:
; CHECK-NEXT: addi r12, r0, 262
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_7:
; CHECK-NEXT: addi r12, r0, 374
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_8:
; CHECK-NEXT: addi r12, r0, 332
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_9:
; CHECK-NEXT: addi r12, r0, 395
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_10:
; CHECK-NEXT: addi r12, r0, 248
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_11:
; CHECK-NEXT: addi r12, r0, 255
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_12:
; CHECK-NEXT: addi r12, r0, 486
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_13:
; CHECK-NEXT: addi r12, r0, 192
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_14:
; CHECK-NEXT: addi r12, r0, 241
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_15:
; CHECK-NEXT: addi r12, r0, 115
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_16:
; CHECK-NEXT: addi r12, r0, 472
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_17:
; CHECK-NEXT: addi r12, r0, 311
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_18:
; CHECK-NEXT: addi r12, r0, 101
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_19:
; CHECK-NEXT: addi r12, r0, 234
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_20:
; CHECK-NEXT: addi r12, r0, 339
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_21:
; CHECK-NEXT: addi r12, r0, 409
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_22:
; CHECK-NEXT: addi r12, r0, 80
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_23:
; CHECK-NEXT: addi r12, r0, 346
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_24:
; CHECK-NEXT: addi r12, r0, 31
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_25:
; CHECK-NEXT: addi r12, r0, 283
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_26:
; CHECK-NEXT: addi r12, r0, 423
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_27:
; CHECK-NEXT: addi r12, r0, 451
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_28:
; CHECK-NEXT: addi r12, r0, 87
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_29:
; CHECK-NEXT: addi r12, r0, 66
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_30:
; CHECK-NEXT: addi r12, r0, 178
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_31:
; CHECK-NEXT: addi r12, r0, 171
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_32:
; CHECK-NEXT: addi r12, r0, 17
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_33:
; CHECK-NEXT: addi r12, r0, 108
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_34:
; CHECK-NEXT: addi r12, r0, 444
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_35:
; CHECK-NEXT: addi r12, r0, 24
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_36:
; CHECK-NEXT: addi r12, r0, 52
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_37:
; CHECK-NEXT: addi r12, r0, 10
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_38:
; CHECK-NEXT: addi r12, r0, 220
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_39:
; CHECK-NEXT: addi r12, r0, 122
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_40:
; CHECK-NEXT: addi r12, r0, 290
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_41:
; CHECK-NEXT: addi r12, r0, 143
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_42:
; CHECK-NEXT: addi r12, r0, 430
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_43:
; CHECK-NEXT: addi r12, r0, 38
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_44:
; CHECK-NEXT: addi r12, r0, 458
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_45:
; CHECK-NEXT: addi r12, r0, 437
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_46:
; CHECK-NEXT: addi r12, r0, 150
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_47:
; CHECK-NEXT: addi r12, r0, 94
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_48:
; CHECK-NEXT: addi r12, r0, 45
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_49:
; CHECK-NEXT: addi r12, r0, 129
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_50:
; CHECK-NEXT: addi r12, r0, 73
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_51:
; CHECK-NEXT: addi r12, r0, 59
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_52:
; CHECK-NEXT: addi r12, r0, 213
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_53:
; CHECK-NEXT: addi r12, r0, 227
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_54:
; CHECK-NEXT: addi r12, r0, 318
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_55:
; CHECK-NEXT: addi r12, r0, 157
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_56:
; CHECK-NEXT: addi r12, r0, 276
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_57:
; CHECK-NEXT: addi r12, r0, 136
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_58:
; CHECK-NEXT: addi r12, r0, 402
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_59:
; CHECK-NEXT: addi r12, r0, 297
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_60:
; CHECK-NEXT: addi r12, r0, 416
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_61:
; CHECK-NEXT: addi r12, r0, 164
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_62:
; CHECK-NEXT: addi r12, r0, 199
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_63:
; CHECK-NEXT: addi r12, r0, 206
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_64:
; CHECK-NEXT: addi r12, r0, 269
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_65:
; CHECK-NEXT: addi r12, r0, 185
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_66:
; CHECK-NEXT: addi r12, r0, 381
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_67:
; CHECK-NEXT: addi r12, r0, 388
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_68:
; CHECK-NEXT: addi r12, r0, 367
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_69:
; CHECK-NEXT: addi r12, r0, 325
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_70:
; CHECK-NEXT: addi r12, r0, 360
; CHECK-NEXT: j .LBB0_72
; CHECK-NEXT: .LBB0_71:
; CHECK-NEXT: addi r12, r0, 479
; CHECK-NEXT: .LBB0_72:
; CHECK-NEXT: addi r4, r0, 1
; CHECK-NEXT: sw r12, 0(r5)
; CHECK-NEXT: ret
; CHECK-NEXT: .LBB0_73:
; CHECK-NEXT: move r4, r0
; CHECK-NEXT: ret
  switch i32 %x, label %other [
    i32 0, label %case0
    i32 1, label %case1
    i32 2, label %case2
    i32 3, label %case3
    i32 4, label %case4
    i32 5, label %case5
    i32 6, label %case6
    i32 7, label %case7
    i32 8, label %case8
    i32 9, label %case9
    i32 10, label %case10
    i32 11, label %case11
    i32 12, label %case12
    i32 13, label %case13
    i32 14, label %case14
    i32 15, label %case15
    i32 16, label %case16
    i32 17, label %case17
    i32 18, label %case18
    i32 19, label %case19
    i32 20, label %case20
    i32 21, label %case21
    i32 22, label %case22
    i32 23, label %case23
    i32 24, label %case24
    i32 25, label %case25
    i32 26, label %case26
    i32 27, label %case27
    i32 28, label %case28
    i32 29, label %case29
    i32 30, label %case30
    i32 31, label %case31
    i32 32, label %case32
    i32 33, label %case33
    i32 34, label %case34
    i32 35, label %case35
    i32 36, label %case36
    i32 37, label %case37
    i32 38, label %case38
    i32 39, label %case39
    i32 40, label %case40
    i32 41, label %case41
    i32 42, label %case42
    i32 43, label %case43
    i32 44, label %case44
    i32 45, label %case45
    i32 46, label %case46
    i32 47, label %case47
    i32 48, label %case48
    i32 49, label %case49
    i32 50, label %case50
    i32 51, label %case51
    i32 52, label %case52
    i32 53, label %case53
    i32 54, label %case54
    i32 55, label %case55
    i32 56, label %case56
    i32 57, label %case57
    i32 58, label %case58
    i32 59, label %case59
    i32 60, label %case60
    i32 61, label %case61
    i32 62, label %case62
    i32 63, label %case63
    i32 64, label %case64
    i32 65, label %case65
    i32 66, label %case66
    i32 67, label %case67
    i32 68, label %case68
    i32 69, label %case69
  ]
case0:
  store volatile i32 3, ptr %p
  br label %done
case1:
  store volatile i32 10, ptr %p
  br label %done
case2:
  store volatile i32 17, ptr %p
  br label %done
case3:
  store volatile i32 24, ptr %p
  br label %done
case4:
  store volatile i32 31, ptr %p
  br label %done
case5:
  store volatile i32 38, ptr %p
  br label %done
case6:
  store volatile i32 45, ptr %p
  br label %done
case7:
  store volatile i32 52, ptr %p
  br label %done
case8:
  store volatile i32 59, ptr %p
  br label %done
case9:
  store volatile i32 66, ptr %p
  br label %done
case10:
  store volatile i32 73, ptr %p
  br label %done
case11:
  store volatile i32 80, ptr %p
  br label %done
case12:
  store volatile i32 87, ptr %p
  br label %done
case13:
  store volatile i32 94, ptr %p
  br label %done
case14:
  store volatile i32 101, ptr %p
  br label %done
case15:
  store volatile i32 108, ptr %p
  br label %done
case16:
  store volatile i32 115, ptr %p
  br label %done
case17:
  store volatile i32 122, ptr %p
  br label %done
case18:
  store volatile i32 129, ptr %p
  br label %done
case19:
  store volatile i32 136, ptr %p
  br label %done
case20:
  store volatile i32 143, ptr %p
  br label %done
case21:
  store volatile i32 150, ptr %p
  br label %done
case22:
  store volatile i32 157, ptr %p
  br label %done
case23:
  store volatile i32 164, ptr %p
  br label %done
case24:
  store volatile i32 171, ptr %p
  br label %done
case25:
  store volatile i32 178, ptr %p
  br label %done
case26:
  store volatile i32 185, ptr %p
  br label %done
case27:
  store volatile i32 192, ptr %p
  br label %done
case28:
  store volatile i32 199, ptr %p
  br label %done
case29:
  store volatile i32 206, ptr %p
  br label %done
case30:
  store volatile i32 213, ptr %p
  br label %done
case31:
  store volatile i32 220, ptr %p
  br label %done
case32:
  store volatile i32 227, ptr %p
  br label %done
case33:
  store volatile i32 234, ptr %p
  br label %done
case34:
  store volatile i32 241, ptr %p
  br label %done
case35:
  store volatile i32 248, ptr %p
  br label %done
case36:
  store volatile i32 255, ptr %p
  br label %done
case37:
  store volatile i32 262, ptr %p
  br label %done
case38:
  store volatile i32 269, ptr %p
  br label %done
case39:
  store volatile i32 276, ptr %p
  br label %done
case40:
  store volatile i32 283, ptr %p
  br label %done
case41:
  store volatile i32 290, ptr %p
  br label %done
case42:
  store volatile i32 297, ptr %p
  br label %done
case43:
  store volatile i32 304, ptr %p
  br label %done
case44:
  store volatile i32 311, ptr %p
  br label %done
case45:
  store volatile i32 318, ptr %p
  br label %done
case46:
  store volatile i32 325, ptr %p
  br label %done
case47:
  store volatile i32 332, ptr %p
  br label %done
case48:
  store volatile i32 339, ptr %p
  br label %done
case49:
  store volatile i32 346, ptr %p
  br label %done
case50:
  store volatile i32 353, ptr %p
  br label %done
case51:
  store volatile i32 360, ptr %p
  br label %done
case52:
  store volatile i32 367, ptr %p
  br label %done
case53:
  store volatile i32 374, ptr %p
  br label %done
case54:
  store volatile i32 381, ptr %p
  br label %done
case55:
  store volatile i32 388, ptr %p
  br label %done
case56:
  store volatile i32 395, ptr %p
  br label %done
case57:
  store volatile i32 402, ptr %p
  br label %done
case58:
  store volatile i32 409, ptr %p
  br label %done
case59:
  store volatile i32 416, ptr %p
  br label %done
case60:
  store volatile i32 423, ptr %p
  br label %done
case61:
  store volatile i32 430, ptr %p
  br label %done
case62:
  store volatile i32 437, ptr %p
  br label %done
case63:
  store volatile i32 444, ptr %p
  br label %done
case64:
  store volatile i32 451, ptr %p
  br label %done
case65:
  store volatile i32 458, ptr %p
  br label %done
case66:
  store volatile i32 465, ptr %p
  br label %done
case67:
  store volatile i32 472, ptr %p
  br label %done
case68:
  store volatile i32 479, ptr %p
  br label %done
case69:
  store volatile i32 486, ptr %p
  br label %done
other:
  ret i32 0
done:
  ret i32 1
}
define i32 @few(i32 %x, ptr %p) {
; CHECK-LABEL: few:
; CHECK: addi r12, r0, 3
; CHECK-NEXT: blt r12, r4, .LBB1_5
; CHECK: addi r12, r0, 1
; CHECK-NEXT: blt r12, r4, .LBB1_9
; CHECK: beq r4, r0, .LBB1_15
; CHECK: addi r12, r0, 1
; CHECK-NEXT: bne r4, r12, .LBB1_20
; CHECK: addi r12, r0, 10
; CHECK-NEXT: j .LBB1_19
; CHECK-NEXT: .LBB1_5:
; CHECK-NEXT: addi r12, r0, 5
; CHECK-NEXT: blt r12, r4, .LBB1_12
; CHECK: addi r12, r0, 4
; CHECK-NEXT: beq r4, r12, .LBB1_16
; CHECK: addi r12, r0, 5
; CHECK-NEXT: bne r4, r12, .LBB1_20
; CHECK: addi r12, r0, 38
; CHECK-NEXT: j .LBB1_19
; CHECK-NEXT: .LBB1_9:
; CHECK-NEXT: addi r12, r0, 2
; CHECK-NEXT: beq r4, r12, .LBB1_17
; CHECK: addi r12, r0, 3
; CHECK-NEXT: bne r4, r12, .LBB1_20
; CHECK: addi r12, r0, 24
; CHECK-NEXT: j .LBB1_19
; CHECK-NEXT: .LBB1_12:
; CHECK-NEXT: addi r12, r0, 6
; CHECK-NEXT: beq r4, r12, .LBB1_18
; CHECK: addi r12, r0, 7
; CHECK-NEXT: bne r4, r12, .LBB1_20
; CHECK: addi r12, r0, 52
; CHECK-NEXT: j .LBB1_19
; CHECK-NEXT: .LBB1_15:
; CHECK-NEXT: addi r12, r0, 3
; CHECK-NEXT: j .LBB1_19
; CHECK-NEXT: .LBB1_16:
; CHECK-NEXT: addi r12, r0, 31
; CHECK-NEXT: j .LBB1_19
; CHECK-NEXT: .LBB1_17:
; CHECK-NEXT: addi r12, r0, 17
; CHECK-NEXT: j .LBB1_19
; CHECK-NEXT: .LBB1_18:
; CHECK-NEXT: addi r12, r0, 45
; CHECK-NEXT: .LBB1_19:
; CHECK-NEXT: addi r4, r0, 1
; CHECK-NEXT: sw r12, 0(r5)
; CHECK-NEXT: ret
; CHECK-NEXT: .LBB1_20:
; CHECK-NEXT: move r4, r0
; CHECK-NEXT: ret
  switch i32 %x, label %other [
    i32 0, label %case0
    i32 1, label %case1
    i32 2, label %case2
    i32 3, label %case3
    i32 4, label %case4
    i32 5, label %case5
    i32 6, label %case6
    i32 7, label %case7
  ]
case0:
  store volatile i32 3, ptr %p
  br label %done
case1:
  store volatile i32 10, ptr %p
  br label %done
case2:
  store volatile i32 17, ptr %p
  br label %done
case3:
  store volatile i32 24, ptr %p
  br label %done
case4:
  store volatile i32 31, ptr %p
  br label %done
case5:
  store volatile i32 38, ptr %p
  br label %done
case6:
  store volatile i32 45, ptr %p
  br label %done
case7:
  store volatile i32 52, ptr %p
  br label %done
other:
  ret i32 0
done:
  ret i32 1
}
