tbreak main
run
next
next
next
next
break sum
continue
next
next
next
next
step
finish
delete
next
finish
next
next
next
step
next
next
next
next
break insert if Value == 4
run
next
next
step
up
list
down
finish
finish
finish
tbreak tour.cpp:46
continue
until
until
advance 63
step
next
step
