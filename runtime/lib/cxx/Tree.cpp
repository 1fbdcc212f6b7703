//===- Tree.cpp - Balanced trees of std::map and std::set ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// libstdc++ leaves the steps that need no element type to its compiled part:
// how to go from node to node, and red-black trees' insertion and removal
// (Cormen et al., Introduction to Algorithms, chapter 13). The header node has
// the root as parent and the first and last node as children.
//
//===----------------------------------------------------------------------===//

#include <bits/stl_tree.h>

using Node = std::_Rb_tree_node_base;

static bool isBlack(const Node *N) {
  return !N || N->_M_color == std::_S_black;
}

/// The child on one side: left of \p N if \p Left, else right.
static Node *&child(Node *N, bool Left) {
  return Left ? N->_M_left : N->_M_right;
}

static bool isLeft(const Node *N) { return N->_M_parent->_M_left == N; }

/// Puts \p New where \p Old hangs on its parent.
static void replace(Node *Old, Node *New, Node *&Root) {
  if (Old == Root)
    Root = New;
  else
    child(Old->_M_parent, isLeft(Old)) = New;
  if (New)
    New->_M_parent = Old->_M_parent;
}

/// Lifts the child of \p N on the side that is not \p ToLeft into its place;
/// \p N becomes that child's child on the side \p ToLeft.
static void rotate(Node *N, bool ToLeft, Node *&Root) {
  Node *Up = child(N, !ToLeft);
  Node *Between = child(Up, ToLeft);
  replace(N, Up, Root);
  child(N, !ToLeft) = Between;
  if (Between)
    Between->_M_parent = N;
  child(Up, ToLeft) = N;
  N->_M_parent = Up;
}

/// The neighbour of \p N in the tree's order: before if \p Left, else behind.
static Node *neighbour(Node *N, bool Left) {
  if (Node *Next = child(N, Left)) {
    while (child(Next, !Left))
      Next = child(Next, !Left);
    return Next;
  }
  Node *Parent = N->_M_parent;
  while (N == child(Parent, Left)) {
    N = Parent;
    Parent = Parent->_M_parent;
  }
  // From the root of a tree whose first or last node it is, the climb ends on
  // the header's other side.
  return child(N, Left) != Parent ? Parent : N;
}

/// Restores the colors above the new red node \p N.
static void balanceInsertion(Node *N, Node *&Root) {
  while (N != Root && !isBlack(N->_M_parent)) {
    Node *Parent = N->_M_parent;
    Node *Grandparent = Parent->_M_parent;
    bool Left = isLeft(Parent);
    Node *Uncle = child(Grandparent, !Left);
    if (!isBlack(Uncle)) {
      Parent->_M_color = Uncle->_M_color = std::_S_black;
      Grandparent->_M_color = std::_S_red;
      N = Grandparent;
      continue;
    }
    if (N == child(Parent, !Left)) {
      rotate(Parent, Left, Root);
      Parent = N;
    }
    Parent->_M_color = std::_S_black;
    Grandparent->_M_color = std::_S_red;
    rotate(Grandparent, !Left, Root);
    break;
  }
  Root->_M_color = std::_S_black;
}

/// Restores the colors where the paths through \p N, a child of \p Parent or
/// null, have lost a black node.
static void balanceRemoval(Node *N, Node *Parent, Node *&Root) {
  while (N != Root && isBlack(N)) {
    bool Left = N == Parent->_M_left;
    Node *Sibling = child(Parent, !Left);
    if (!isBlack(Sibling)) {
      Sibling->_M_color = std::_S_black;
      Parent->_M_color = std::_S_red;
      rotate(Parent, Left, Root);
      Sibling = child(Parent, !Left);
    }
    if (isBlack(Sibling->_M_left) && isBlack(Sibling->_M_right)) {
      Sibling->_M_color = std::_S_red;
      N = Parent;
      Parent = Parent->_M_parent;
      continue;
    }
    if (isBlack(child(Sibling, !Left))) {
      child(Sibling, Left)->_M_color = std::_S_black;
      Sibling->_M_color = std::_S_red;
      rotate(Sibling, !Left, Root);
      Sibling = child(Parent, !Left);
    }
    Sibling->_M_color = Parent->_M_color;
    Parent->_M_color = std::_S_black;
    child(Sibling, !Left)->_M_color = std::_S_black;
    rotate(Parent, Left, Root);
    break;
  }
  if (N)
    N->_M_color = std::_S_black;
}

namespace std {

Node *_Rb_tree_increment(Node *N) noexcept { return neighbour(N, false); }

const Node *_Rb_tree_increment(const Node *N) noexcept {
  return neighbour(const_cast<Node *>(N), false);
}

Node *_Rb_tree_decrement(Node *N) noexcept {
  // Before the header, the end, is the last node.
  bool IsHeader = N->_M_color == _S_red && N->_M_parent->_M_parent == N;
  return IsHeader ? N->_M_right : neighbour(N, true);
}

const Node *_Rb_tree_decrement(const Node *N) noexcept {
  return _Rb_tree_decrement(const_cast<Node *>(N));
}

void _Rb_tree_insert_and_rebalance(const bool Left, Node *N, Node *Parent,
                                   Node &Header) noexcept {
  N->_M_parent = Parent;
  N->_M_left = N->_M_right = nullptr;
  N->_M_color = _S_red;
  if (Parent == &Header) {
    Header._M_parent = Header._M_left = Header._M_right = N;
  } else {
    child(Parent, Left) = N;
    if (Parent == child(&Header, Left))
      child(&Header, Left) = N;
  }
  balanceInsertion(N, Header._M_parent);
}

Node *_Rb_tree_rebalance_for_erase(Node *const N, Node &Header) noexcept {
  Node *&Root = Header._M_parent;
  if (N == Header._M_left)
    Header._M_left = N->_M_right ? neighbour(N, false) : N->_M_parent;
  if (N == Header._M_right)
    Header._M_right = N->_M_left ? neighbour(N, true) : N->_M_parent;

  Node *Child;
  Node *Parent;
  _Rb_tree_color Lost = N->_M_color;
  if (N->_M_left && N->_M_right) {
    Node *Next = neighbour(N, false);
    Lost = Next->_M_color;
    Child = Next->_M_right;
    Parent = Next;
    if (Next != N->_M_right) {
      Parent = Next->_M_parent;
      replace(Next, Child, Root);
      Next->_M_right = N->_M_right;
      Next->_M_right->_M_parent = Next;
    }
    replace(N, Next, Root);
    Next->_M_left = N->_M_left;
    Next->_M_left->_M_parent = Next;
    Next->_M_color = N->_M_color;
  } else {
    Child = N->_M_left ? N->_M_left : N->_M_right;
    Parent = N->_M_parent;
    replace(N, Child, Root);
  }
  if (Lost == _S_black)
    balanceRemoval(Child, Parent, Root);
  return N;
}

} // namespace std
