#include "SessionFolder.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

TEST(SessionFolder, NamesGoBothWays) {
  EXPECT_EQ(part_file(SessionPart::kSurface, 12), "surface/surface_00000012.vtp");
  EXPECT_EQ(part_file(SessionPart::kFrame, 0), "frames/frame_00000000.vti");
  for (const PartNames& names : kParts) {
    for (const long frame : {0L, 7L, 99999999L, 123456789012L}) {
      const std::string file = part_file(names.part, frame);
      EXPECT_EQ(frame_index_of(names.part, file.substr(file.find('/') + 1)), frame) << file;
    }
  }
}

TEST(SessionFolder, OtherNamesAreNoFrames) {
  for (const char* name : {"", "surface_.vtp", "surface_12.vti", "surface_1x.vtp", "surface_-1.vtp",
                           "surface_00000012.vtp.tmp", "tools_00000012.vtp", "surface_00000012"}) {
    EXPECT_FALSE(frame_index_of(SessionPart::kSurface, name)) << name;
  }
}

}  // namespace
}  // namespace pellucida
