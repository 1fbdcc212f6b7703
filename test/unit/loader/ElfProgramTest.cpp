//===- ElfProgramTest.cpp - A TP program as an ELF file -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/loader/ElfProgram.h"
#include "llvm-backend/MCTargetDesc/TPELF.h"

#include "llvm/ADT/SmallString.h"
#include "llvm/BinaryFormat/ELF.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/raw_ostream.h"
#include "gmock/gmock.h"
#include "gtest/gtest.h"

using namespace tp;
using namespace llvm::ELF;
using testing::HasSubstr;

namespace {

/// An executable of a code segment of 16 bytes at 0x10000 and a data segment of
/// 8 bytes in the file and 32 in memory at 0x20000. Tests damage it.
struct TestElf {
  Elf32_Ehdr Header = {};
  Elf32_Phdr Segments[2] = {};
  uint8_t Code[16] = {1, 2, 3, 4};
  uint8_t Data[8] = {5, 6, 7, 8};

  TestElf() {
    memcpy(Header.e_ident, ElfMagic, 4);
    Header.e_ident[EI_CLASS] = ELFCLASS32;
    Header.e_ident[EI_DATA] = ELFDATA2LSB;
    Header.e_ident[EI_VERSION] = EV_CURRENT;
    Header.e_type = ET_EXEC;
    Header.e_machine = llvm::TPELF::EM_TP;
    Header.e_version = EV_CURRENT;
    Header.e_entry = 0x10004;
    Header.e_phoff = offsetof(TestElf, Segments);
    Header.e_ehsize = sizeof(Elf32_Ehdr);
    Header.e_phentsize = sizeof(Elf32_Phdr);
    Header.e_phnum = 2;
    Segments[0] = {
        PT_LOAD, offsetof(TestElf, Code), 0x10000, 0x10000, 16, 16, PF_R | PF_X,
        4};
    Segments[1] = {
        PT_LOAD, offsetof(TestElf, Data), 0x20000, 0x20000, 8, 32, PF_R | PF_W,
        4};
  }
};
static_assert(sizeof(TestElf) == 52 + 2 * 32 + 24);

class ElfProgramTest : public testing::Test {
protected:
  TestElf Elf;
  llvm::SmallString<128> Path;

  void SetUp() override {
    ASSERT_FALSE(
        llvm::sys::fs::createTemporaryFile("elf-program", "elf", Path));
  }
  void TearDown() override { EXPECT_FALSE(llvm::sys::fs::remove(Path)); }

  llvm::Expected<ElfProgram> load(size_t Bytes = sizeof(TestElf)) {
    std::error_code EC;
    llvm::raw_fd_ostream OS(Path, EC);
    OS.write(reinterpret_cast<const char *>(&Elf), Bytes);
    OS.close();
    return ElfProgram::load(Path);
  }

  std::string error(size_t Bytes = sizeof(TestElf)) {
    llvm::Expected<ElfProgram> Program = load(Bytes);
    return Program ? "" : llvm::toString(Program.takeError());
  }
};

TEST_F(ElfProgramTest, ReadsSegmentsAndEntry) {
  llvm::Expected<ElfProgram> Program = load();
  ASSERT_TRUE(bool(Program)) << llvm::toString(Program.takeError());
  EXPECT_EQ(Program->entry(), 0x10004u);
  ASSERT_EQ(Program->segments().size(), 2u);
  EXPECT_EQ(Program->text().Address, 0x10000u);
  EXPECT_EQ(Program->text().Contents[3], 4);
  EXPECT_EQ(Program->segments()[1].Size, 32u);
  EXPECT_EQ(Program->segments()[1].Contents.size(), 8u);
  EXPECT_EQ(Program->imageEnd(), 0x20020u);
  EXPECT_EQ(Program->symbol("nothing"), std::nullopt);
}

TEST_F(ElfProgramTest, ChecksThatTheImageFits) {
  llvm::Expected<ElfProgram> Program = load();
  ASSERT_TRUE(bool(Program)) << llvm::toString(Program.takeError());
  EXPECT_EQ(llvm::toString(Program->checkFits(0x20020, 1024)), "");
  EXPECT_THAT(llvm::toString(Program->checkFits(0x2001f, 1024)),
              HasSubstr("needs 131104 bytes, the chip has 131103"));
}

TEST_F(ElfProgramTest, EveryTruncationIsAnError) {
  for (size_t Bytes = 0; Bytes != sizeof(TestElf); ++Bytes)
    EXPECT_NE(error(Bytes), "") << Bytes;
  EXPECT_THAT(error(0), HasSubstr("is not an ELF file"));
  EXPECT_THAT(error(20), HasSubstr("is cut off"));
  EXPECT_THAT(error(60), HasSubstr("is cut off"));
  EXPECT_THAT(error(sizeof(TestElf) - 1),
              HasSubstr("is cut off: the segment at 0x00020000 ends at byte"));
}

TEST_F(ElfProgramTest, RefusesOtherFiles) {
  Elf.Header.e_machine = EM_386;
  EXPECT_THAT(error(), HasSubstr("is for another machine (e_machine 3)"));
  Elf = TestElf();
  Elf.Header.e_ident[EI_CLASS] = ELFCLASS64;
  EXPECT_THAT(error(), HasSubstr("is for another machine"));
  Elf = TestElf();
  Elf.Header.e_type = ET_REL;
  EXPECT_THAT(error(), HasSubstr("not linked; link it with tpcc"));
  Elf = TestElf();
  Elf.Header.e_type = ET_DYN;
  EXPECT_THAT(error(), HasSubstr("is not an executable"));
}

TEST_F(ElfProgramTest, RefusesBadSegments) {
  Elf.Segments[1].p_vaddr = 0x10008;
  EXPECT_THAT(error(), HasSubstr("overlap"));
  Elf = TestElf();
  Elf.Segments[1].p_vaddr = 0x8000;
  EXPECT_THAT(error(), HasSubstr("in the first 64 KiB"));
  Elf = TestElf();
  Elf.Segments[1].p_memsz = 4;
  EXPECT_THAT(error(), HasSubstr("larger in the file than in memory"));
  Elf = TestElf();
  Elf.Segments[0].p_flags = PF_R;
  EXPECT_THAT(error(), HasSubstr("has 0 executable segments"));
  Elf = TestElf();
  Elf.Segments[0].p_vaddr = 0x10002;
  EXPECT_THAT(error(), HasSubstr("does not begin at a multiple of 4"));
}

TEST_F(ElfProgramTest, RefusesAnEntryOutsideTheCode) {
  for (uint32_t Entry :
       {0u, 0xfffcu, 0x10002u, 0x10010u, 0x20000u, 0xfffffffcu}) {
    Elf.Header.e_entry = Entry;
    EXPECT_THAT(error(), HasSubstr("is not an address of the code")) << Entry;
  }
}

/// The program with a list of functions with floating-point checks.
struct CheckedElf {
  TestElf Program;
  uint32_t List[4] = {0x10004, 8, llvm::TPELF::DeadAddress, 20};
  char Names[26] = "\0.tp_fp_checked\0.shstrtab";
  uint16_t Padding = 0;
  Elf32_Shdr Sections[3] = {};

  CheckedElf() {
    Program.Header.e_shoff = offsetof(CheckedElf, Sections);
    Program.Header.e_shentsize = sizeof(Elf32_Shdr);
    Program.Header.e_shnum = 3;
    Program.Header.e_shstrndx = 2;
    Sections[1].sh_name = 1;
    Sections[1].sh_type = SHT_PROGBITS;
    Sections[1].sh_offset = offsetof(CheckedElf, List);
    Sections[1].sh_size = sizeof(List);
    Sections[2].sh_name = 16;
    Sections[2].sh_type = SHT_STRTAB;
    Sections[2].sh_offset = offsetof(CheckedElf, Names);
    Sections[2].sh_size = sizeof(Names);
  }
};

class CheckedFunctions : public ElfProgramTest {
protected:
  CheckedElf Checked;

  llvm::Expected<ElfProgram> loadChecked() {
    std::error_code EC;
    llvm::raw_fd_ostream OS(Path, EC);
    OS.write(reinterpret_cast<const char *>(&Checked), sizeof(Checked));
    OS.close();
    return ElfProgram::load(Path);
  }
  std::string checkedError() {
    llvm::Expected<ElfProgram> Program = loadChecked();
    return Program ? "" : llvm::toString(Program.takeError());
  }
};

TEST_F(CheckedFunctions, AreListed) {
  llvm::Expected<ElfProgram> Program = loadChecked();
  ASSERT_TRUE(bool(Program)) << llvm::toString(Program.takeError());
  ASSERT_EQ(Program->floatChecked().size(), 1u);
  EXPECT_EQ(Program->floatChecked()[0].Begin, 0x10004u);
  EXPECT_EQ(Program->floatChecked()[0].End, 0x1000Cu);
}

TEST_F(CheckedFunctions, LieInTheCode) {
  for (auto [Begin, Size] : {std::pair(0x10004u, 16u),
                             {0x10002u, 4u},
                             {0xFFF0u, 4u},
                             {0x20000u, 4u},
                             {0x10000u, 0xFFFFFFF0u}}) {
    Checked.List[0] = Begin;
    Checked.List[1] = Size;
    EXPECT_THAT(checkedError(), HasSubstr("that is not in the code"));
  }
}

TEST_F(CheckedFunctions, HaveWholeEntries) {
  Checked.Sections[1].sh_size = 12;
  EXPECT_THAT(checkedError(),
              HasSubstr("section .tp_fp_checked has 12 bytes, no multiple"));
  Checked.Sections[1].sh_offset = 0x10000;
  EXPECT_THAT(checkedError(),
              HasSubstr("the section .tp_fp_checked is damaged"));
}

TEST_F(CheckedFunctions, AtomicAccessesAreListedWithTheirFlags) {
  std::strcpy(&Checked.Names[Checked.Sections[1].sh_name], ".tp_atomics");
  Checked.Sections[1].sh_size = 3 * sizeof(uint32_t);
  Checked.List[0] = 0x10004 + 1;
  Checked.List[1] = 0x10008 + 2;
  llvm::Expected<ElfProgram> Program = loadChecked();
  ASSERT_TRUE(bool(Program)) << llvm::toString(Program.takeError());
  llvm::ArrayRef<AtomicAccess> Found = Program->atomicAccesses();
  ASSERT_EQ(Found.size(), 2u);
  EXPECT_EQ(Found[0].Address, 0x10004u);
  EXPECT_TRUE(Found[0].Acquires);
  EXPECT_FALSE(Found[0].IsPartOfWord);
  EXPECT_EQ(Found[1].Address, 0x10008u);
  EXPECT_FALSE(Found[1].Acquires);
  EXPECT_TRUE(Found[1].IsPartOfWord);

  Checked.List[0] = 0xFFFFFFFF;
  Checked.List[1] = 0x20001;
  EXPECT_THAT(checkedError(),
              HasSubstr("lists an access at 0x00020000 that is not in the "
                        "code"));
}

} // namespace
