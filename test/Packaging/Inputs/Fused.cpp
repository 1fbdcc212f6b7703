// Options of tpcc, and what clangd is told of them.
#if !defined(__TP_FMA__) || !defined(__FP_FAST_FMAF) || defined(__TP_TRIG__)
#error "the macros of -mfma and -mno-trig"
#endif
static_assert(LIMIT == 3);

int main() { return __builtin_tp_trunc_w(0.5f); }
