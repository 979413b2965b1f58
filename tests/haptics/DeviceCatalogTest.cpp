#include "pellucida/haptics/DeviceCatalog.h"

#include <gtest/gtest.h>

#include <fstream>

#include "pellucida/core/Error.h"
#include "pellucida/core/TemporaryFolder.h"

namespace pellucida {
namespace {

std::string text_of_error(const std::string& json) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "devices.json";
  std::ofstream(file) << json;
  try {
    read_device_catalog(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string with_device(const std::string& device) {
  return R"({"schema": "pellucida-haptic-devices", "schema_version": 1, "devices": [)" + device + "]}";
}

TEST(DeviceCatalog, TheShippedListHasThePlannedDevices) {
  struct Expected {
    const char* name;
    double force_N, stiffness_N_per_m;
  };
  for (const Expected& expected :
       {Expected{"Touch", 3.3, 400}, Expected{"PHANTOM Omni", 3.3, 700}, Expected{"PHANTOM Desktop", 7.9, 1000},
        Expected{"PHANTOM Premium 1.5 6DOF", 8.5, 800}, Expected{"PHANTOM Premium 3.0 6DOF", 22, 1000},
        Expected{"omega.3", 12, 5000}, Expected{"delta.3", 20, 5000}, Expected{"sigma.7", 12, 4000},
        Expected{"lambda.7", 12, 8000}, Expected{"Falcon", 8, 3000}, Expected{"Mouse", 0, 0}}) {
    const DeviceSpecification device = find_device(expected.name);
    EXPECT_EQ(device.max_force_N, expected.force_N) << expected.name;
    EXPECT_EQ(device.max_stiffness_N_per_m, expected.stiffness_N_per_m) << expected.name;
    EXPECT_FALSE(device.source.empty()) << expected.name;
  }
}

TEST(DeviceCatalog, NamesIgnoreCaseAndUnknownOnesListTheKnown) {
  EXPECT_EQ(find_device("touch").name, "Touch");
  try {
    find_device("Tuch");
    FAIL() << "an unknown name was taken";
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("omega.3"), std::string::npos) << error.what();
  }
}

TEST(DeviceCatalog, FaultsNameFileDeviceAndKey) {
  EXPECT_NE(text_of_error("{").find("no JSON"), std::string::npos);
  EXPECT_NE(text_of_error("{}").find("\"schema\""), std::string::npos);
  EXPECT_NE(text_of_error(R"({"schema": "pellucida-haptic-devices", "schema_version": 2})").find("schema_version"),
            std::string::npos);
  const std::string missing = text_of_error(with_device(R"({"name": "A", "source": "s", "max_force_N": 1})"));
  EXPECT_NE(missing.find("(A): max_stiffness_N_per_m is missing"), std::string::npos) << missing;
  const std::string common = R"("source": "s", "max_damping_N_s_per_m": 1, "workspace_radius_m": 0.1)";
  const auto device = [&](const std::string& more) {
    return with_device("{\"name\": \"A\", " + common + ", " + more + "}");
  };
  EXPECT_EQ(text_of_error(device(R"("max_force_N": 1, "max_stiffness_N_per_m": 10)")), "");
  EXPECT_NE(text_of_error(device(R"("max_force_N": -1, "max_stiffness_N_per_m": 10)"))
                .find("max_force_N is -1; allowed: 0 to 1e+09"),
            std::string::npos);
  EXPECT_NE(text_of_error(device(R"("max_force_N": 1, "max_stiffness_N_per_m": 0)")).find("max_stiffness_N_per_m"),
            std::string::npos);
  EXPECT_NE(text_of_error(device(R"("max_force_N": 0, "max_stiffness_N_per_m": 10)")).find("must be 0 too"),
            std::string::npos);
  EXPECT_NE(text_of_error(device(R"("max_force_N": "1", "max_stiffness_N_per_m": 10)")).find("must be a number"),
            std::string::npos);
  EXPECT_NE(text_of_error(device(R"("max_force_N": 1, "max_stifness": 10, "max_stiffness_N_per_m": 10)"))
                .find("max_stifness is an unknown key; known: name, max_force_N"),
            std::string::npos);
}

}  // namespace
}  // namespace pellucida
