#include "DataFile.h"

#include <vtkCallbackCommand.h>
#include <vtkExecutive.h>
#include <vtkPoints.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <fstream>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

// Turns VTK's Error and Warning events of a reader into one text, and keeps them off stderr.
class Complaints {
 public:
  explicit Complaints(vtkXMLReader* reader) {
    callback_->SetClientData(this);
    callback_->SetCallback([](vtkObject*, unsigned long, void* self, void* text) {
      auto& complaints = *static_cast<Complaints*>(self);
      if (complaints.text_.empty()) complaints.text_ = first_line(static_cast<const char*>(text));
    });
    for (const auto event : {vtkCommand::ErrorEvent, vtkCommand::WarningEvent}) {
      reader->AddObserver(event, callback_);
      // The pipeline round it repeats the failure on its own.
      reader->GetExecutive()->AddObserver(event, callback_);
    }
    reader->SetReaderErrorObserver(callback_);
    reader->SetParserErrorObserver(callback_);
  }
  Complaints(const Complaints&) = delete;
  Complaints& operator=(const Complaints&) = delete;

  const std::string& text() const noexcept { return text_; }

 private:
  // VTK writes "ERROR: In file, line n\nvtkClass (0x...): what happened\n\n": the last part is what matters.
  static std::string first_line(const char* text) {
    std::string all = text ? text : "unknown";
    while (!all.empty() && all.back() == '\n') all.pop_back();
    const auto start = all.find("): ");
    all = start == std::string::npos ? all : all.substr(start + 3);
    return all.substr(0, all.find('\n'));
  }

  vtkNew<vtkCallbackCommand> callback_;
  std::string text_;
};

// How a kind of data is packed. Measured on 728 x 486 pixels and 2 x 1,764 nodes with their arrays: zlib at its fastest
// halves an image in 4 ms, where LZ4 gains nothing on its noise; of the surface LZ4 saves a third in 0.3 ms, zlib half
// in 4 ms.
struct Compression {
  int compressor;
  int level;
};
constexpr Compression kImageCompression{vtkXMLWriter::ZLIB, 1};
constexpr Compression kNoCompression{vtkXMLWriter::NONE, 0};
constexpr Compression kPolyCompression{vtkXMLWriter::LZ4, 1};

// Raw appended blocks are the smallest and fastest form VTK reads everywhere. The writer keeps what it is given only
// until it has written, so one writer a call leaves no reference behind.
template <class Writer, class Data>
std::string serialise_with(Data* data, Compression compression) {
  vtkNew<Writer> writer;
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorType(compression.compressor);
  if (compression.level > 0) writer->SetCompressionLevel(compression.level);
  writer->SetWriteToOutputString(true);
  if (writer->Write() != 1) throw Error(ExitCode::kOurFault, "a data object could not be turned into a VTK file");
  return writer->GetOutputString();
}

// The end tag comes last: without it the file was cut off, whatever the parser makes of the rest.
bool has_end_tag(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) throw InputError(file.string() + ": can't be read; check that it exists, and its permission");
  const std::streamoff size = stream.tellg();
  std::string tail(static_cast<std::size_t>(std::min<std::streamoff>(size, 32)), '\0');
  stream.seekg(size - static_cast<std::streamoff>(tail.size()));
  stream.read(tail.data(), static_cast<std::streamsize>(tail.size()));
  return tail.find("</VTKFile>") != std::string::npos;
}

template <class Reader, class Data>
vtkSmartPointer<Data> read_with(const std::filesystem::path& file) {
  if (!has_end_tag(file)) throw InputError(file.string() + ": cut off before its end");
  vtkNew<Reader> reader;
  const Complaints complaints(reader);
  reader->SetFileName(file.c_str());
  reader->Update();
  if (!complaints.text().empty()) throw InputError(file.string() + ": damaged (" + complaints.text() + ")");
  vtkSmartPointer<Data> data = reader->GetOutput();
  if (!data) throw InputError(file.string() + ": damaged (no data object in it)");
  return data;
}

}  // namespace

std::string serialise(vtkImageData* data, Packing packing) {
  return serialise_with<vtkXMLImageDataWriter>(data, packing == Packing::kQuick ? kNoCompression : kImageCompression);
}

std::string serialise(vtkPolyData* data) {
  return serialise_with<vtkXMLPolyDataWriter>(data, kPolyCompression);
}

std::string empty_poly_file() {
  // ParaView warns of a file without a list of points, though it be empty.
  vtkNew<vtkPolyData> data;
  data->SetPoints(vtkNew<vtkPoints>());
  return serialise(data.Get());
}

vtkSmartPointer<vtkImageData> read_image_file(const std::filesystem::path& file) {
  return read_with<vtkXMLImageDataReader, vtkImageData>(file);
}

vtkSmartPointer<vtkPolyData> read_poly_file(const std::filesystem::path& file) {
  return read_with<vtkXMLPolyDataReader, vtkPolyData>(file);
}

}  // namespace pellucida
