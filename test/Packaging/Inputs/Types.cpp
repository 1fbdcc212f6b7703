#include <cstddef>
#include <cstdint>
#include <type_traits>

static_assert(sizeof(void *) == 4 && sizeof(long) == 4);
static_assert(sizeof(long long) == 8 && alignof(long long) == 8);
static_assert(sizeof(double) == 8 && alignof(double) == 8);
static_assert(sizeof(long double) == 8 && alignof(long double) == 8);
static_assert(sizeof(_Float16) == 2 && sizeof(__bf16) == 2);
static_assert(sizeof(__int128) == 16);
static_assert(std::is_signed_v<char> && std::is_signed_v<wchar_t>);
static_assert(sizeof(wchar_t) == 4);
static_assert(std::is_same_v<size_t, unsigned>);
static_assert(std::is_same_v<ptrdiff_t, int>);
static_assert(std::is_same_v<int32_t, int>);
static_assert(std::is_same_v<uint32_t, unsigned>);
static_assert(std::is_same_v<int64_t, long long>);
static_assert(std::is_same_v<uintptr_t, unsigned>);
static_assert(alignof(max_align_t) == 8);
#if defined(__riscv) || !defined(__tp__) || !defined(__TP_TRIG__)
#error "not the TP's macros"
#endif
#if __has_feature(cxx_exceptions) || __has_feature(cxx_rtti)
#error "the TP has neither"
#endif
