//===- List.cpp - Links of std::list ------------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// libstdc++ leaves the steps that need no element type to its compiled part.
//
//===----------------------------------------------------------------------===//

#include <list>

namespace std::__detail {

void _List_node_base::_M_hook(_List_node_base *const Next) noexcept {
  _M_next = Next;
  _M_prev = Next->_M_prev;
  _M_prev->_M_next = Next->_M_prev = this;
}

void _List_node_base::_M_unhook() noexcept {
  _M_prev->_M_next = _M_next;
  _M_next->_M_prev = _M_prev;
}

void _List_node_base::_M_transfer(_List_node_base *const First,
                                  _List_node_base *const End) noexcept {
  if (this == End)
    return;
  _List_node_base *Last = End->_M_prev;
  First->_M_prev->_M_next = End;
  End->_M_prev = First->_M_prev;
  First->_M_prev = _M_prev;
  _M_prev->_M_next = First;
  Last->_M_next = this;
  _M_prev = Last;
}

void _List_node_base::_M_reverse() noexcept {
  _List_node_base *Node = this;
  do {
    _List_node_base *Next = Node->_M_next;
    Node->_M_next = Node->_M_prev;
    Node->_M_prev = Next;
    Node = Next;
  } while (Node != this);
}

/// The lists' ends change places; an empty list's end is linked to itself.
void _List_node_base::swap(_List_node_base &A, _List_node_base &B) noexcept {
  _List_node_base Marker;
  Marker._M_hook(&A);
  A._M_unhook();
  A._M_hook(&B);
  B._M_unhook();
  B._M_hook(&Marker);
  Marker._M_unhook();
}

} // namespace std::__detail
