#include "pellucida/visualization_vtk/Letters.h"

#include <vtkTextProperty.h>

#include <filesystem>
#include <string>

namespace pellucida {
namespace {

// The file of a face, empty where it is not installed. Looked up once.
const std::string& face_file(bool bold) {
  const auto find = [](const char* name) {
    const std::filesystem::path file = std::filesystem::path("/usr/share/fonts/truetype/dejavu") / name;
    std::error_code ignored;
    return std::filesystem::is_regular_file(file, ignored) ? file.string() : std::string{};
  };
  static const std::string plain_file = find("DejaVuSans.ttf");
  static const std::string bold_file = find("DejaVuSans-Bold.ttf");
  return bold ? bold_file : plain_file;
}

}  // namespace

void set_typeface(vtkTextProperty* letters, bool bold) {
  letters->SetItalic(false);
  if (const std::string& file = face_file(bold); !file.empty()) {
    letters->SetFontFamily(VTK_FONT_FILE);
    letters->SetFontFile(file.c_str());
    letters->SetBold(false);
  } else {
    letters->SetFontFamilyToArial();
    letters->SetBold(bold);
  }
}

}  // namespace pellucida
