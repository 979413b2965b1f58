#pragma once
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace pellucida::test {

using Chance = std::mt19937_64;

/// What was changed: the files that a report may name for it, and in words.
struct Mutation {
  std::vector<std::string> named;
  std::string what;
};

/// A closed session of four steps with every kind of file. `shift` makes another session of the same names.
void write_all_parts(const std::filesystem::path& folder, long shift);

/// The names of all files of a session, relative to it.
std::vector<std::string> files_of(const std::filesystem::path& session);

/// Flips one bit of one file.
Mutation flip(const std::filesystem::path& session, Chance& chance);

/// Any other change, some of them with checksums that agree; `other` is another session of the same names. What is
/// moved or linked to lies beside the session.
Mutation mutate(const std::filesystem::path& session, const std::filesystem::path& other, Chance& chance);

}  // namespace pellucida::test
