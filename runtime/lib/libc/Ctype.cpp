//===- Ctype.cpp - Kinds of characters ------------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include <ctype.h>

namespace {

/// Whether \p First <= \p Character <= \p Last.
bool within(int Character, char First, char Last) {
  return static_cast<unsigned>(Character - First) <=
         static_cast<unsigned>(Last - First);
}

} // namespace

extern "C" {

int isdigit(int Character) { return within(Character, '0', '9'); }
int islower(int Character) { return within(Character, 'a', 'z'); }
int isupper(int Character) { return within(Character, 'A', 'Z'); }
int isalpha(int Character) { return within(Character | 0x20, 'a', 'z'); }
int isalnum(int Character) { return isalpha(Character) || isdigit(Character); }
int isblank(int Character) { return Character == ' ' || Character == '\t'; }
int iscntrl(int Character) {
  return within(Character, '\0', '\x1f') || Character == 0x7f;
}
int isgraph(int Character) { return within(Character, '!', '~'); }
int isprint(int Character) { return within(Character, ' ', '~'); }
int ispunct(int Character) { return isgraph(Character) && !isalnum(Character); }
int isspace(int Character) {
  return Character == ' ' || within(Character, '\t', '\r');
}
int isxdigit(int Character) {
  return isdigit(Character) || within(Character | 0x20, 'a', 'f');
}
int tolower(int Character) {
  return isupper(Character) ? Character | 0x20 : Character;
}
int toupper(int Character) {
  return islower(Character) ? Character & ~0x20 : Character;
}

} // extern "C"
