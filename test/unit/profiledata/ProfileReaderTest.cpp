//===- ProfileReaderTest.cpp - Profiles as files --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/profile/ProfileJson.h"
#include "test/unit/profiledata/SmallProfile.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

static std::string textOf(const Profile &Data) {
  std::string Text;
  llvm::raw_string_ostream OS(Text);
  writeProfile(Data, OS);
  return Text;
}

static std::string errorOf(const std::string &Text) {
  llvm::Expected<Profile> Data = parseProfile(Text, "p.json");
  return Data ? "" : toString(Data.takeError());
}

TEST(ProfileReader, ReadsWhatWasWritten) {
  Profile Data = smallProfile();
  Data.Files = {{"a.cpp", "int \"main\"\n"}, {"b.cpp", std::nullopt}};
  Data.Frames[0].File = 1;
  Data.Instructions[0].Memory.Global = 3;
  Data.Instructions[0].Memory.Served[unsigned(ServedBy::L2)] = {2, 77};
  Data.Tms = {{46}, {counts(35, 11)}, {{35}}, {{0}}, {{0}}};
  // Waits whose level has become known.
  Data.Tms.Chip[0].Lost[unsigned(Loss::Memory)] = uint64_t(-5);
  Data.IsCallTreeCut = true;
  std::string Text = textOf(Data);
  llvm::Expected<Profile> Read = parseProfile(Text, "p.json");
  ASSERT_TRUE(bool(Read)) << toString(Read.takeError());
  EXPECT_EQ(textOf(*Read), Text);
  EXPECT_EQ(Read->Files[0].Text, "int \"main\"\n");
  EXPECT_EQ(Read->Instructions[0].Memory, Data.Instructions[0].Memory);
  EXPECT_EQ(Read->Tms.Chip[0], Data.Tms.Chip[0]);
}

TEST(ProfileReader, ErrorsNameThePlace) {
  EXPECT_NE(errorOf("[").find("p.json: not JSON"), std::string::npos);
  EXPECT_NE(errorOf("{}").find("format_version"), std::string::npos);
  Profile Data = smallProfile();
  Data.Frames[2].InlinedInto = 2;
  EXPECT_NE(errorOf(textOf(Data)).find("p.json: frames[2] refers"),
            std::string::npos);
  Data = smallProfile();
  Data.Calls[1].CallSite = 4;
  EXPECT_NE(errorOf(textOf(Data)).find("call_tree[1] refers"),
            std::string::npos);
  Data = smallProfile();
  Data.Tms.Ends = {46};
  EXPECT_NE(errorOf(textOf(Data)).find("utilisation.chip"), std::string::npos);
  std::string Text = textOf(smallProfile());
  Text.replace(Text.find("\"data\""), 6, "\"date\"");
  EXPECT_NE(errorOf(Text).find("unknown name at profile"), std::string::npos);
  Data = smallProfile();
  Data.Statistics = "3";
  EXPECT_NE(errorOf(textOf(Data)).find("expected object at profile.statistics"),
            std::string::npos);
}
