#pragma once
#include <filesystem>
#include <string>

namespace pellucida {

/// Chooses the folder of each recording. One thread.
class RecordingPresenter {
 public:
  /// `wanted`: the folder the user named, empty for none; `home`: where a folder `Pellucida` is kept.
  RecordingPresenter(std::filesystem::path wanted, std::filesystem::path home);

  /// Where recordings and pictures go from now on, each in a folder or file of its own.
  void set_place(std::filesystem::path place);
  /// The folder that the next recordings are in.
  std::filesystem::path place() const;

  /// The folder for a recording that begins at `stamp` ("2026-11-20T20-15-00Z"). The folder named by the user serves
  /// the first recording; later ones get a number behind it, so that nothing is ever written over.
  std::filesystem::path next_folder(const std::string& stamp);

  /// A file for a picture of the window, and one for the list of cells, beside the recordings.
  std::filesystem::path picture_file(const std::string& stamp) const;
  std::filesystem::path cells_file(const std::string& stamp) const;

  /// The present time in UTC as folder names carry it.
  static std::string utc_stamp();

 private:
  std::filesystem::path wanted_;
  std::filesystem::path place_;
  int count_ = 0;
};

}  // namespace pellucida
