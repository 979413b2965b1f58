#include "pellucida/core/FieldTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "pellucida/core/Error.h"
#include "pellucida/core/FieldJson.h"

namespace pellucida {
namespace {

using Json = nlohmann::ordered_json;

struct Lens {
  double focus_um = 2.5;
  int count = 3;
};
struct Device {
  std::string name;
  bool enabled = true;
  std::uint64_t seed = 7;
  Lens lens;
};

constexpr Field<Device> kDevice[] = {
    {"name", "", &Device::name, {}, "for lists", FieldNeed::kRequired},
    {"enabled", "", &Device::enabled, {}, "works"},
    {"seed", "", &Device::seed, {0}, "of the noise"},
};
constexpr Field<Lens> kLens[] = {
    {"focus_um", "um", &Lens::focus_um, above(0, 50), "from the front"},
    {"count", "", &Lens::count, {1, 4}, "of glasses"},
};

FieldList fields_of(Device& device) {
  return FieldList().add("", kDevice, device).add("front.lens", kLens, device.lens);
}

// What reading `text` complains about; "" when nothing.
std::string fault_of(const std::string& text) {
  Device device;
  const FieldList fields = fields_of(device);
  auto fault = read_fields(Json::parse(text), fields);
  if (!fault) fault = range_fault(fields);
  return fault.value_or("");
}

TEST(FieldTable, ReadsWhatIsGivenAndKeepsTheRest) {
  Device device;
  const auto json = R"({"name": "a", "seed": 18446744073709551615, "front": {"lens": {"count": 4}}})";
  EXPECT_EQ(read_fields(Json::parse(json), fields_of(device)), std::nullopt);
  EXPECT_EQ(device.name, "a");
  EXPECT_EQ(device.seed, 18446744073709551615u);
  EXPECT_EQ(device.lens.count, 4);
  EXPECT_EQ(device.lens.focus_um, 2.5);
  EXPECT_TRUE(device.enabled);
}

TEST(FieldTable, WhatIsWrittenReadsBackInTheTablesOrder) {
  Device device{"b", false, 9, {1.25, 2}};
  Json json;
  write_fields(fields_of(device), json);
  EXPECT_EQ(json.dump(), R"({"name":"b","enabled":false,"seed":9,"front":{"lens":{"focus_um":1.25,"count":2}}})");
  Device back;
  EXPECT_EQ(read_fields(json, fields_of(back)), std::nullopt);
  EXPECT_EQ(back.lens.focus_um, 1.25);
  EXPECT_FALSE(back.enabled);
}

TEST(FieldTable, EveryFaultSaysWhatWhereAndWhatIsAllowed) {
  EXPECT_EQ(fault_of(R"({"name": "a"})"), "");
  EXPECT_EQ(fault_of("{}"), "name is missing; add it");
  EXPECT_EQ(fault_of(R"({"name": ""})"), "name is empty; write a text");
  EXPECT_EQ(fault_of(R"({"name": 3})"), "name is 3, but must be a text");
  EXPECT_EQ(fault_of(R"({"enabled": 1})"), "enabled is 1, but must be true or false");
  EXPECT_EQ(fault_of(R"({"seed": -1})"), "seed is -1, but must be a whole number, 0 or more");
  EXPECT_EQ(fault_of(R"({"front": 2})"), "front is no group of keys; write \"front\": {...}");
  EXPECT_EQ(fault_of(R"({"rear": 2})"), "rear is an unknown key; known: name, enabled, seed, front");
  EXPECT_EQ(fault_of(R"({"front.lens": {}})"), "front.lens is an unknown key; known: name, enabled, seed, front");
  EXPECT_EQ(fault_of(R"({"front": {"lens": {"blur": 2}}})"),
            "front.lens.blur is an unknown key; known: focus_um, count");
  EXPECT_EQ(fault_of(R"({"front": {"lens": {"count": 2.5}}})"), "front.lens.count is 2.5, but must be a whole number");
  EXPECT_EQ(fault_of(R"({"front": {"lens": {"count": 1e300}}})"),
            "front.lens.count is 1e+300, but must be a whole number below 1e9");
  EXPECT_EQ(fault_of(R"({"name": "a", "front": {"lens": {"count": 5}}})"), "front.lens.count is 5; allowed: 1 to 4");
  EXPECT_EQ(fault_of(R"({"name": "a", "front": {"lens": {"focus_um": 0}}})"),
            "front.lens.focus_um is 0; allowed: above 0, up to 50");
}

TEST(FieldTable, RangesHoldTheirEndsButNeverNaN) {
  EXPECT_TRUE((FieldRange{0, 1}).holds(0) && (FieldRange{0, 1}).holds(1) && !(FieldRange{0, 1}).holds(1.1));
  EXPECT_TRUE(!above(0).holds(0) && above(0).holds(1e300) && above(0).holds(INFINITY));
  EXPECT_FALSE(FieldRange{}.holds(std::nan("")));
  EXPECT_EQ(range_fault("x", std::nan(""), FieldRange{}), "x is not a number; allowed: any number");
  EXPECT_EQ(to_string(FieldRange{0}), "0 or more");
  EXPECT_EQ(to_string(above(0)), "above 0");
}

TEST(FieldTable, MarkdownHasATableAGroup) {
  Device device;
  EXPECT_EQ(markdown(fields_of(device)),
            "| key | unit | allowed | default | meaning |\n|---|---|---|---|---|\n"
            "| `name` |  | text | required | for lists |\n"
            "| `enabled` |  | true or false | true | works |\n"
            "| `seed` |  | 0 or more | 7 | of the noise |\n"
            "\n### front.lens\n\n"
            "| key | unit | allowed | default | meaning |\n|---|---|---|---|---|\n"
            "| `focus_um` | um | above 0, up to 50 | 2.5 | from the front |\n"
            "| `count` |  | 1 to 4 | 3 | of glasses |\n");
}

TEST(FieldTable, TextThatHoldsNoObjectIsAnInputError) {
  for (const char* text : {"", "{", "[]", "3"}) EXPECT_THROW(parse_json_object(text, "x"), InputError) << text;
  EXPECT_EQ(parse_json_object("{\"a\": 1 /* one */}", "x").at("a"), 1);
  EXPECT_THROW(read_json_object("/nowhere/x.json"), InputError);
}

}  // namespace
}  // namespace pellucida
