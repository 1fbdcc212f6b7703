//===- TypeReader.cpp - Types from their descriptions --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/NameIndex.h"
#include "debugger/source/TypeTable.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/DebugInfo/DWARF/DWARFUnit.h"
#include "llvm/Support/LEB128.h"
#include "llvm/Support/raw_ostream.h"

using namespace llvm;
using namespace llvm::dwarf;

namespace tp {

static StringRef keyword(Tag T) {
  switch (T) {
  case DW_TAG_structure_type:
    return "struct";
  case DW_TAG_class_type:
    return "class";
  case DW_TAG_union_type:
    return "union";
  default:
    return "enum";
  }
}

static std::string nameOf(DWARFDie Die) {
  switch (Die.getTag()) {
  case DW_TAG_structure_type:
  case DW_TAG_class_type:
  case DW_TAG_union_type:
  case DW_TAG_enumeration_type:
    if (!Die.find(DW_AT_name))
      return "(anonymous " + keyword(Die.getTag()).str() + ")";
    break;
  default:
    break;
  }
  std::string Text;
  raw_string_ostream OS(Text);
  dumpTypeQualifiedName(Die, OS);
  return Text;
}

static TypeKind kindOfEncoding(uint64_t Encoding) {
  switch (Encoding) {
  case DW_ATE_boolean:
    return TypeKind::Boolean;
  case DW_ATE_float:
    return TypeKind::Float;
  case DW_ATE_signed_char:
  case DW_ATE_unsigned_char:
  case DW_ATE_UTF:
  case DW_ATE_ASCII:
    return TypeKind::Character;
  case DW_ATE_signed:
    return TypeKind::Signed;
  case DW_ATE_unsigned:
    return TypeKind::Unsigned;
  default:
    return TypeKind::Incomplete;
  }
}

static TypeKind kindOf(Tag T) {
  switch (T) {
  case DW_TAG_pointer_type:
    return TypeKind::Pointer;
  case DW_TAG_reference_type:
    return TypeKind::LvalueReference;
  case DW_TAG_rvalue_reference_type:
    return TypeKind::RvalueReference;
  case DW_TAG_ptr_to_member_type:
    return TypeKind::MemberPointer;
  case DW_TAG_subroutine_type:
    return TypeKind::Function;
  case DW_TAG_structure_type:
    return TypeKind::Structure;
  case DW_TAG_class_type:
    return TypeKind::Class;
  case DW_TAG_union_type:
    return TypeKind::Union;
  case DW_TAG_enumeration_type:
    return TypeKind::Enumeration;
  case DW_TAG_typedef:
  case DW_TAG_template_alias:
    return TypeKind::Typedef;
  case DW_TAG_const_type:
    return TypeKind::Const;
  case DW_TAG_volatile_type:
    return TypeKind::Volatile;
  case DW_TAG_restrict_type:
  case DW_TAG_atomic_type:
    return TypeKind::OtherQualifier;
  case DW_TAG_unspecified_type:
    return TypeKind::NullPointer;
  default:
    return TypeKind::Incomplete;
  }
}

static std::optional<uint32_t> countOf(DWARFDie Subrange) {
  if (std::optional<uint64_t> Count = toUnsigned(Subrange.find(DW_AT_count)))
    return uint32_t(*Count);
  std::optional<DWARFFormValue> Upper = Subrange.find(DW_AT_upper_bound);
  std::optional<int64_t> Bound = Upper ? constantOf(*Upper) : std::nullopt;
  return Bound ? std::optional(uint32_t(*Bound + 1)) : std::nullopt;
}

/// Only the outermost dimension is this type; the others become arrays of
/// their own.
void TypeTable::readArray(Type &Result, DWARFDie Die) {
  std::vector<std::optional<uint32_t>> Counts;
  for (DWARFDie Child : Die.children())
    if (Child.getTag() == DW_TAG_subrange_type)
      Counts.push_back(countOf(Child));
  const Type *Element = &typeOf(Die);
  for (size_t I = Counts.size(); I-- > 1;)
    Element = &arrayOf(*Element, Counts[I].value_or(0));
  Result.Kind = Die.find(DW_AT_GNU_vector) ? TypeKind::Vector : TypeKind::Array;
  Result.Target = Element;
  if (!Counts.empty() && !is_contained(drop_begin(Counts), std::nullopt))
    Result.Count = Counts.front();
  if (!Result.Size && Result.Count)
    Result.Size = *Result.Count * Element->Size;
}

void TypeTable::readEnumerators(Type &Result, DWARFDie Die) {
  for (DWARFDie Child : Die.children()) {
    if (Child.getTag() != DW_TAG_enumerator)
      continue;
    Enumerator Named;
    Named.Name = baseName(Child).str();
    if (std::optional<DWARFFormValue> Form = Child.find(DW_AT_const_value))
      Named.Value = constantOf(*Form).value_or(0);
    Result.Enumerators.push_back(std::move(Named));
  }
  Result.IsScoped = Die.find(DW_AT_enum_class).has_value();
}

/// The number that DWARF 2's expression for a member adds; nothing for a
/// virtual base's.
static std::optional<uint64_t> addedConstant(const DWARFFormValue &Form) {
  std::optional<ArrayRef<uint8_t>> Block = Form.getAsBlock();
  if (!Block || Block->size() < 2 || Block->front() != DW_OP_plus_uconst)
    return std::nullopt;
  unsigned Length = 0;
  uint64_t Number = decodeULEB128(Block->data() + 1, &Length, Block->end());
  return Length + 1 == Block->size() ? std::optional(Number) : std::nullopt;
}

/// The number in the expression by which an object finds a virtual base: it
/// duplicates and follows the vtable's pointer, subtracts the number, and adds
/// what stands there. 0 if the expression is another one.
static uint32_t virtualBaseSlot(const DWARFFormValue &Form) {
  static constexpr uint8_t kBefore[] = {DW_OP_dup, DW_OP_deref, DW_OP_constu};
  static constexpr uint8_t kBehind[] = {DW_OP_minus, DW_OP_deref, DW_OP_plus};
  ArrayRef<uint8_t> Block = Form.getAsBlock().value_or(ArrayRef<uint8_t>());
  if (!Block.take_front(std::min(Block.size(), std::size(kBefore)))
           .equals(kBefore))
    return 0;
  Block = Block.drop_front(std::size(kBefore));
  unsigned Length = 0;
  uint64_t Number = decodeULEB128(Block.begin(), &Length, Block.end());
  return Block.drop_front(Length).equals(kBehind) ? uint32_t(Number) : 0;
}

/// Where a member is, in bits; nothing if that is not constant.
static std::optional<uint64_t> bitPosition(DWARFDie Die, uint32_t BitSize,
                                           uint32_t TypeSize) {
  std::optional<uint64_t> Bits = toUnsigned(Die.find(DW_AT_data_bit_offset));
  if (Bits)
    return Bits;
  uint64_t Bytes = 0;
  if (std::optional<DWARFFormValue> Form =
          Die.find(DW_AT_data_member_location)) {
    std::optional<uint64_t> Constant = Form->getAsUnsignedConstant();
    if (!Constant)
      Constant = addedConstant(*Form);
    if (!Constant)
      return std::nullopt;
    Bytes = *Constant;
  }
  std::optional<uint64_t> FromTop = toUnsigned(Die.find(DW_AT_bit_offset));
  if (!FromTop)
    return 8 * Bytes;
  uint64_t Storage = toUnsigned(Die.find(DW_AT_byte_size), TypeSize);
  // DWARF 2 counts from the highest bit of the storage.
  return uint64_t(int64_t(8 * (Bytes + Storage)) - int64_t(int32_t(*FromTop)) -
                  BitSize);
}

void TypeTable::readMembers(Type &Result, DWARFDie Die) {
  for (DWARFDie Child : Die.children()) {
    Tag T = Child.getTag();
    bool IsStatic = T == DW_TAG_variable ||
                    (T == DW_TAG_member && (Child.find(DW_AT_external) ||
                                            Child.find(DW_AT_declaration)));
    if (IsStatic && Child.find(DW_AT_artificial))
      continue;
    if (IsStatic) {
      Result.StaticMembers.push_back({baseName(Child).str(), Child});
      continue;
    }
    if (T != DW_TAG_member && T != DW_TAG_inheritance)
      continue;
    Member Part;
    Part.Of = &typeOf(Child);
    Part.IsBase = T == DW_TAG_inheritance;
    Part.Name = Part.IsBase ? Part.Of->Name : baseName(Child).str();
    Part.IsArtificial = Child.find(DW_AT_artificial).has_value();
    uint32_t Bits = uint32_t(toUnsigned(Child.find(DW_AT_bit_size), 0));
    std::optional<uint64_t> Position = bitPosition(Child, Bits, Part.Of->Size);
    Part.IsVirtualBase = !Position;
    std::optional<DWARFFormValue> Place =
        Child.find(DW_AT_data_member_location);
    if (Part.IsVirtualBase && Place)
      Part.VirtualBaseSlot = virtualBaseSlot(*Place);
    Part.Offset = uint32_t(Position.value_or(0) / 8);
    Part.BitSize = Bits;
    Part.BitOffset = uint32_t(Position.value_or(0) % 8);
    Result.Members.push_back(std::move(Part));
  }
}

void TypeTable::read(Type &Result, DWARFDie Die) {
  Result.Die = Die;
  Result.Kind = kindOf(Die.getTag());
  Result.Name = nameOf(Die);
  Result.Size = uint32_t(toUnsigned(Die.find(DW_AT_byte_size), 0));
  if (Die.find(DW_AT_declaration)) {
    DWARFDie Definition;
    for (DWARFDie Other : Names.types(baseName(Die)))
      if (!Definition && !Other.find(DW_AT_declaration) &&
          Other.getTag() == Die.getTag() &&
          qualifiedName(Other) == qualifiedName(Die))
        Definition = Other;
    if (Definition)
      return read(Result, Definition);
    Result.Kind = TypeKind::Incomplete;
    return;
  }
  switch (Die.getTag()) {
  case DW_TAG_base_type:
    Result.Kind = kindOfEncoding(toUnsigned(Die.find(DW_AT_encoding), 0));
    Result.IsSignedCharacter =
        toUnsigned(Die.find(DW_AT_encoding), 0) == DW_ATE_signed_char;
    if (toUnsigned(Die.find(DW_AT_encoding), 0) == DW_ATE_complex_float) {
      // Its real part, then its imaginary one.
      Result.Kind = TypeKind::Vector;
      Result.Target = &basic(Result.Size == 8 ? "float" : "double");
      Result.Count = 2;
    }
    break;
  case DW_TAG_array_type:
    readArray(Result, Die);
    break;
  case DW_TAG_structure_type:
  case DW_TAG_class_type:
  case DW_TAG_union_type:
    readMembers(Result, Die);
    break;
  case DW_TAG_enumeration_type:
    Result.Target = &typeOf(Die);
    readEnumerators(Result, Die);
    break;
  case DW_TAG_ptr_to_member_type:
    Result.Container =
        &fromDie(Die.getAttributeValueAsReferencedDie(DW_AT_containing_type));
    Result.Target = &typeOf(Die);
    Result.Size = Result.Target->Kind == TypeKind::Function ? 8 : 4;
    break;
  case DW_TAG_pointer_type:
  case DW_TAG_reference_type:
  case DW_TAG_rvalue_reference_type:
  case DW_TAG_unspecified_type:
    Result.Target = &typeOf(Die);
    Result.Size = 4;
    break;
  case DW_TAG_typedef:
  case DW_TAG_template_alias:
  case DW_TAG_const_type:
  case DW_TAG_volatile_type:
  case DW_TAG_restrict_type:
  case DW_TAG_atomic_type:
    Result.Target = &typeOf(Die);
    Result.Size = Result.Target->Size;
    break;
  case DW_TAG_subroutine_type:
    Result.Target = &typeOf(Die);
    break;
  default:
    break;
  }
}

} // namespace tp
