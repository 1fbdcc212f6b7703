info line main
info symbol main
info functions insert
list insert
list
list -
start
print Used
tbreak tour.cpp:44
info breakpoints
continue
backtrace
up
info frame
info locals
down
info args
print *Root
print/x Root->Value
print &Pool[1]
print sizeof(Pool)
print Root->Left == 0 || Root->Value * 2 + 1 == 11
print $1 + 1
whatis Root
ptype struct shapes::Node
output Used
echo \ntext\n
x/3dw Pool
x/2i $pc
info registers sp pc
display Depth
display/x $r29
info display
next
undisplay 1
undisplay
watch Depth
rwatch Pool[1].Value
awatch -r &Pool[2] 4
info breakpoints
continue
disable 3
continue
disable 4
enable 3
reverse-continue
disable 3
continue
delete
break sum thread 0 if Root && Root->Value == 3
run
info breakpoints
backtrace full
backtrace 1
condition 6
ignore 6 2
continue
frame 1
frame
clear sum
up
down
finish
echo reverse-finish\n
reverse-finish
echo step\n
step
reverse-step
echo next\n
next
reverse-next
echo stepi\n
stepi
reverse-stepi
echo nexti\n
nexti
reverse-nexti
echo until\n
until
advance 47
who-wrote Used
who-wrote Pool[0].Left
who-wrote Pool[0].Left before 100
set var Used = 77
print Used
who-wrote Used
set $r15 = 0x1234
info registers r15
set register r15 = 2
print $r15
set memory &Used 1 2 0 0
print Used
set listsize 3
list make
set print pretty on
print Pool[0]
set print pretty off
disassemble /s make
info source
info variables Pool
info program
info threads
thread
thread 0
thread apply all print Used
cycle
info chip
info checkpoints
goto 300
info cycle
print Used
goto 0
reverse-continue
continue
bt
tbreak main
run
kill
info breakpoints
help step
help info line
quit 3
