//===- HashTable.cpp - Hashes and sizes of the unordered containers -----===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// libstdc++ leaves the steps that need no element type to its compiled part.
//
//===----------------------------------------------------------------------===//

#include <stddef.h>
#include <unordered_map>

static bool isPrime(size_t Number) {
  if (Number < 4)
    return Number >= 2;
  if (Number % 2 == 0 || Number % 3 == 0)
    return false;
  for (size_t Divisor = 5; Divisor <= Number / Divisor; Divisor += 6)
    if (Number % Divisor == 0 || Number % (Divisor + 2) == 0)
      return false;
  return true;
}

/// FNV-1a, and a last step that spreads the lowest bits' differences.
static size_t hashOf(const void *Data, size_t Bytes, size_t Seed) {
  const auto *Byte = static_cast<const unsigned char *>(Data);
  size_t Hash = Seed ^ 0x811C9DC5u;
  for (; Bytes != 0; --Bytes)
    Hash = (Hash ^ *Byte++) * 0x01000193u;
  return Hash ^ Hash >> 15;
}

namespace std {

size_t _Hash_bytes(const void *Data, size_t Bytes, size_t Seed) {
  return hashOf(Data, Bytes, Seed);
}

size_t _Fnv_hash_bytes(const void *Data, size_t Bytes, size_t Seed) {
  return hashOf(Data, Bytes, Seed);
}

namespace __detail {

/// The least prime from \p Wanted on, and from when on it is too small.
size_t _Prime_rehash_policy::_M_next_bkt(size_t Wanted) const {
  if (Wanted == 0)
    return 1;
  size_t Count = Wanted < 2 ? 2 : Wanted;
  while (!isPrime(Count))
    ++Count;
  _M_next_resize =
      static_cast<size_t>(static_cast<float>(Count) * _M_max_load_factor);
  return Count;
}

pair<bool, size_t> _Prime_rehash_policy::_M_need_rehash(size_t Buckets,
                                                        size_t Elements,
                                                        size_t Added) const {
  constexpr size_t First = 11;
  size_t Needed = Elements + Added;
  if (Needed <= _M_next_resize)
    return {false, 0};
  if (_M_next_resize == 0 && Needed < First)
    Needed = First;
  auto LeastBuckets =
      static_cast<size_t>(static_cast<float>(Needed) / _M_max_load_factor);
  if (LeastBuckets >= Buckets) {
    size_t Grown = Buckets * _S_growth_factor;
    return {true, _M_next_bkt(LeastBuckets < Grown ? Grown : LeastBuckets + 1)};
  }
  _M_next_resize =
      static_cast<size_t>(static_cast<float>(Buckets) * _M_max_load_factor);
  return {false, 0};
}

} // namespace __detail
} // namespace std
