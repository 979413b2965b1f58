#include <cstdio>

#include "pellucida/core/Error.h"
#include "pellucida/core/LatestValue.h"
#include "pellucida/core/Resources.h"
#include "pellucida/core/Version.h"

// Uses a template and a compiled part of the library, as a program of somebody else's would.
int main() {
  pellucida::LatestValue<int> newest;
  newest.publish(42);
  if (!newest.refresh() || newest.value() != 42) return 1;
  try {
    std::printf("resources in %s\n", pellucida::resource_folder().c_str());
    return 1;  // nothing lies beside this program
  } catch (const pellucida::InputError& error) {
    std::printf("Pellucida %s says: %s\n", pellucida::kVersion, error.what());
  }
  return 0;
}
