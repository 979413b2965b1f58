#include "ImageFile.h"

#include <itkBMPImageIO.h>
#include <itkPNGImageIO.h>

#include <array>
#include <cctype>
#include <fstream>
#include <string_view>

#include "ImageStructure.h"
#include "JpegFile.h"
#include "TiffPages.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"

namespace pellucida {
namespace {

using namespace std::string_view_literals;

// ITK's text spans several lines and names its own source files: only the reason at its end is for a user.
std::string reason_of(const itk::ExceptionObject& error) {
  std::string text = error.GetDescription();
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  text = text.substr(text.find_last_of('\n') + 1);
  if (const auto end_of_class = text.find("): "); end_of_class != std::string::npos)
    text = text.substr(end_of_class + 3);
  return text;
}

itk::ImageIOBase::Pointer make_reader(ImageKind kind) {
  switch (kind) {
    case ImageKind::kPng:
      return itk::PNGImageIO::New().GetPointer();
    case ImageKind::kBmp:
      return itk::BMPImageIO::New().GetPointer();
    case ImageKind::kTiff:
    case ImageKind::kJpeg:
    case ImageKind::kNone:
      break;
  }
  return nullptr;
}

// A reader that has read the head of `file`.
itk::ImageIOBase::Pointer open_image(const std::filesystem::path& file) {
  itk::Object::SetGlobalWarningDisplay(false);
  const itk::ImageIOBase::Pointer reader = make_reader(image_kind(file));
  if (!reader) throw InputError(file.string() + ": not a PNG, TIFF, JPEG or BMP image");
  try {
    reader->SetFileName(file.string());
    reader->ReadImageInformation();
  } catch (const itk::ExceptionObject& error) {
    throw InputError(file.string() + ": broken image (" + reason_of(error) + ")");
  }
  const auto type = reader->GetComponentType();
  if (type != itk::IOComponentEnum::UCHAR && type != itk::IOComponentEnum::USHORT) {
    throw InputError(file.string() + ": holds " + itk::ImageIOBase::GetComponentTypeAsString(type) +
                     " pixels; convert it to 8 or 16 bit grey");
  }
  return reader;
}

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

int bytes_per_sample(const itk::ImageIOBase& reader) {
  return reader.GetComponentType() == itk::IOComponentEnum::USHORT ? 2 : 1;
}

}  // namespace

ImageKind image_kind(const std::filesystem::path& file) {
  std::array<char, 8> bytes{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(bytes.data(), bytes.size());
  const std::string_view start(bytes.data(), static_cast<std::size_t>(stream.gcount()));
  if (start.starts_with("\x89PNG\r\n\x1a\n"sv)) return ImageKind::kPng;
  if (start.starts_with("\xff\xd8\xff"sv)) return ImageKind::kJpeg;
  for (const auto magic : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}) {
    if (start.starts_with(magic)) return ImageKind::kTiff;
  }
  // Two letters are little: a bitmap must also be called one.
  return start.starts_with("BM") && lower_extension(file) == ".bmp" ? ImageKind::kBmp : ImageKind::kNone;
}

bool has_image_name(const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  for (const char* known : {".png", ".tif", ".tiff", ".jpg", ".jpeg", ".bmp"}) {
    if (extension == known) return true;
  }
  return false;
}

void require_size(const std::string& name, std::uint64_t width_px, std::uint64_t height_px, double most_megapixels) {
  const double megapixels = 1e-6 * static_cast<double>(width_px) * static_cast<double>(height_px);
  if (megapixels <= most_megapixels) return;
  throw InputError(name + ": " + std::to_string(width_px) + " x " + std::to_string(height_px) + " px, more than " +
                   csv_number(most_megapixels) + " megapixels; raise --max-megapixels if that is right");
}

ImageFileInfo read_image_info(const std::filesystem::path& file, double most_megapixels) {
  const ImageKind kind = image_kind(file);
  if (kind == ImageKind::kTiff) return TiffPages(file, most_megapixels).info();
  // ITK gives a spacing of 1 for these kinds whatever the file says: the scale comes from the file's structure.
  const ImageStructure structure = check_structure(file, kind, most_megapixels);
  ImageFileInfo info;
  if (kind == ImageKind::kJpeg) {
    info.width_px = structure.width_px;
    info.height_px = structure.height_px;
    return info;
  }
  const auto reader = open_image(file);
  info.physical.pixel_size_um = structure.pixel_size_um;
  info.width_px = static_cast<int>(reader->GetDimensions(0));
  info.height_px = static_cast<int>(reader->GetDimensions(1));
  info.bit_depth = 8 * bytes_per_sample(*reader);
  return info;
}

GreyImage read_image(const std::filesystem::path& file, double most_megapixels) {
  const ImageKind kind = image_kind(file);
  check_structure(file, kind, most_megapixels);
  if (kind == ImageKind::kTiff) return TiffPages(file, most_megapixels).read();
  if (kind == ImageKind::kJpeg) return read_jpeg(file);
  const auto reader = open_image(file);
  const auto width_px = static_cast<int>(reader->GetDimensions(0));
  const auto height_px = static_cast<int>(reader->GetDimensions(1));
  itk::ImageIORegion region(2);
  region.SetSize(0, reader->GetDimensions(0));
  region.SetSize(1, reader->GetDimensions(1));
  reader->SetIORegion(region);

  GreyImage image = make_grey(width_px, height_px, 8 * bytes_per_sample(*reader));
  const auto channel_count = static_cast<int>(reader->GetNumberOfComponents());
  std::vector<std::uint8_t> samples(image.bytes.size() * static_cast<std::size_t>(channel_count));
  try {
    reader->Read(samples.data());
  } catch (const itk::ExceptionObject& error) {
    throw InputError(file.string() + ": broken image (" + reason_of(error) + ")");
  }
  to_grey(samples.data(), channel_count, bytes_per_sample(*reader), image.pixel_count(), image.bytes.data());
  return image;
}

}  // namespace pellucida
