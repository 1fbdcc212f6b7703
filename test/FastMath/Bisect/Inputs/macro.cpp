// A header that trusts a macro of the compiler.
#if __FINITE_MATH_ONLY__
static const bool HaveInfinity = false;
#else
static const bool HaveInfinity = true;
#endif

int main() { return !HaveInfinity; }
