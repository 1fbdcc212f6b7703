static volatile int Counter;
int increment(int By) { return Counter += By; }
