#include "SessionMutations.h"

#include <sys/stat.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "TestSession.h"
#include "pellucida/vtk_files/DataFile.h"

namespace pellucida::test {
namespace {

std::size_t pick(Chance& chance, std::size_t count) {
  return std::uniform_int_distribution<std::size_t>(0, count - 1)(chance);
}

template <class T>
const T& one_of(Chance& chance, const std::vector<T>& all) {
  return all[pick(chance, all.size())];
}

Frozen<vtkPolyData> hand_block(int block) {
  auto paths = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> time;
  time->SetName("time_s");
  for (int line = 0; line < 2; ++line) {
    lines->InsertNextCell(3);
    for (int tick = 0; tick < 3; ++tick) {
      lines->InsertCellPoint(points->InsertNextPoint(line, tick, block));
      time->InsertNextValue(block + 0.001 * tick);
    }
  }
  paths->SetPoints(points);
  paths->SetLines(lines);
  paths->GetPointData()->AddArray(time);
  return Frozen<vtkPolyData>(paths);
}

const std::vector<std::string> kTables{"measurements.csv", "events.csv", "checksums.csv"};

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

void replace_once(const fs::path& file, const std::string& what, const std::string& by) {
  std::string text = text_of(file);
  const auto at = text.find(what);
  if (at != std::string::npos) put(file, text.replace(at, what.size(), by));
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

// Lines of a file with their order, number or content changed.
Mutation change_lines(const fs::path& session, const std::string& file, Chance& chance) {
  std::vector<std::string> lines = lines_of(session / file);
  const bool list = file == "session.pvd";
  const std::size_t first = list ? 3 : 1;
  const std::size_t last = lines.size() - (list ? 2 : 0);
  const std::size_t at = first + pick(chance, last - first);
  std::string what;
  switch (pick(chance, 5)) {
    case 0:
      lines.insert(lines.begin() + static_cast<long>(at), lines[at]);
      what = "line doubled";
      break;
    case 1:
      lines.erase(lines.begin());
      what = "first line removed";
      break;
    case 2:
      lines[at] = lines[at].substr(0, lines[at].size() / 2);
      what = "line cut";
      break;
    case 3:
      lines[at].insert(pick(chance, lines[at].size()), std::string(1, '\0') + "\xFF");
      what = "zero byte in a line";
      break;
    default:
      lines.insert(lines.begin() + static_cast<long>(at), std::string(5000, 'x'));
      what = "a long strange line";
  }
  put(session / file, joined(lines));
  return {{file}, what + " in " + file};
}

// A row whose checksum is right and whose numbers can't be.
Mutation impossible_row(const fs::path& session, Chance& chance) {
  std::vector<std::string> lines = lines_of(session / "measurements.csv");
  const std::size_t at = 1 + pick(chance, lines.size() - 1);
  std::vector<std::string> cells;
  std::stringstream row(lines[at].substr(0, lines[at].rfind(',')));
  for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
  static const std::vector<std::pair<std::size_t, std::string>> kValues{
      {1, "nan"}, {1, "inf"}, {1, "-1e300"}, {0, "-5"},   {0, "99999999999999999999"}, {3, "7"}, {3, "-1"}, {2, "fly"},
      {9, "nan"}, {9, "inf"}, {0, "nan"},    {15, "-inf"}};
  const auto& [column, value] = one_of(chance, kValues);
  cells[column] = value;
  std::string text;
  for (const std::string& cell : cells) text += (text.empty() ? "" : ",") + cell;
  lines[at] = signed_row(text);
  put(session / "measurements.csv", joined(lines));
  return {{"measurements.csv"}, "column " + std::to_string(column) + " = " + value};
}

// The row in checksums.csv is made to agree: whoever changed the file knew of it.
void sign_file(const fs::path& session, const std::string& file) {
  const std::string content = text_of(session / file);
  std::vector<std::string> lines = lines_of(session / "checksums.csv");
  for (std::string& line : lines) {
    if (line.starts_with(file + ',')) {
      line = signed_row(file + ',' + std::to_string(content.size()) + ',' + crc32_text(crc32_of(content)));
    }
  }
  put(session / "checksums.csv", joined(lines));
}

Mutation change_part(const fs::path& session, const fs::path& other, Chance& chance) {
  static const std::vector<std::string> kParts{"surface/surface_00000001.vtp", "membranes/membranes_00000002.vtp",
                                               "tools/tools_00000000.vtp", "frames/frame_00000003.vti",
                                               "haptics/haptics_00000001.vtp"};
  const std::string& file = one_of(chance, kParts);
  const fs::path path = session / file;
  const std::string whole = text_of(path);
  std::string what;
  bool signed_too = chance() % 2 == 0;
  switch (pick(chance, 15)) {
    case 0:
      put(path, text_of(other / file));
      what = "another session's";
      signed_too = false;
      break;
    case 1:
      replace_once(path, "<FieldData>", repeated("<a>", 1 << (4 + pick(chance, 14))) + "<FieldData>");
      what = "deep XML";
      break;
    case 2:
      replace_once(path, file.ends_with("vti") ? "WholeExtent=\"0 5" : "NumberOfPoints=\"",
                   file.ends_with("vti") ? "WholeExtent=\"0 1099511627776" : "NumberOfPoints=\"10995116277");
      what = "huge count";
      break;
    case 3:
      replace_once(path, file.ends_with("vti") ? "WholeExtent=\"0 5" : "NumberOfPoints=\"",
                   file.ends_with("vti") ? "WholeExtent=\"0 -5" : "NumberOfPoints=\"-");
      what = "negative count";
      break;
    case 4:
      replace_once(path, "NumberOfComponents=\"", "NumberOfComponents=\"40000000");
      replace_once(path, "NumberOfTuples=\"", "NumberOfTuples=\"40000000");
      what = "huge components";
      break;
    case 5: {
      std::string text = whole;
      const std::size_t data = text.find('_', text.find("AppendedData")) + 1;
      std::fill_n(text.begin() + static_cast<long>(data), 4, one_of(chance, std::vector<char>{'\x7F', '\xFF', '\0'}));
      put(path, text);
      what = "block count";
      break;
    }
    case 6:
      fs::remove(path);
      EXPECT_EQ(mkfifo(path.c_str(), 0600), 0);
      what = "a pipe";
      signed_too = false;
      break;
    case 7:
      fs::rename(path, session.parent_path() / "theirs");
      fs::create_symlink(session.parent_path() / "theirs", path);
      what = "a link";
      signed_too = false;
      break;
    case 8:
      put(path, whole.substr(0, pick(chance, whole.size())));
      what = "cut";
      break;
    case 9:
      put(path, "");
      what = "empty";
      break;
    case 10:
      put(path, std::string(whole.size(), '\0'));
      what = "zeros";
      break;
    case 11:
      put(path, whole + whole);
      what = "doubled";
      signed_too = false;
      break;
    case 12:
      fs::remove(path);
      what = "removed";
      signed_too = false;
      break;
    case 13:
      fs::remove(path);
      fs::create_directories(path / "inside");
      what = "a folder";
      signed_too = false;
      break;
    default:
      replace_once(path, "offset=\"", "offset=\"" + one_of(chance, std::vector<std::string>{"9999", "-1", "1e9"}));
      what = "offset";
  }
  if (signed_too) sign_file(session, file);
  return {{file, file.substr(0, file.find('/'))}, file + ": " + what + (signed_too ? ", signed" : "")};
}

// NaN and infinity in a file whose checksum is right.
Mutation not_a_number(const fs::path& session, Chance& chance) {
  const std::string file = "membranes/membranes_00000001.vtp";
  const auto data = poly_from(text_of(session / file));
  double point[3];
  const vtkIdType id = static_cast<vtkIdType>(pick(chance, static_cast<std::size_t>(data->GetNumberOfPoints())));
  data->GetPoint(id, point);
  point[pick(chance, 3)] = chance() % 2 == 0 ? std::nan("") : INFINITY;
  data->GetPoints()->SetPoint(id, point);
  put(session / file, serialise(data));
  sign_file(session, file);
  return {{file}, "NaN or infinity in a contour"};
}

Mutation change_head(const fs::path& session, Chance& chance) {
  const fs::path file = session / "session.json";
  auto json = nlohmann::ordered_json::parse(text_of(file));
  json.erase("crc32");
  switch (pick(chance, 9)) {
    case 0:
      json["schema_version"] = 99;
      break;
    case 1:
      json["calibration"]["pixel_size_um"] = -1;
      break;
    case 2:
      json["counts"]["steps"] = -4;
      break;
    case 3:
      json["counts"]["surface"] = 1e18;
      break;
    case 4:
      json["source"]["width_px"] = 1e300;
      break;
    case 5:
      json["source"]["frame_rate_hz"] = 0;
      break;
    case 6:
      json["profile"] = "nothing";
      break;
    case 7:
      json["counts"] = nlohmann::json::array({1, 2});
      break;
    default:
      put(file, repeated("[", 100000));
      return {{"session.json"}, "deep JSON"};
  }
  put(file, json.dump(2));
  return {{"session.json"}, "session.json: " + json.dump().substr(0, 60)};
}

// A table, a list or a head that isn't a file any more.
Mutation no_file(const fs::path& session, Chance& chance) {
  static const std::vector<std::string> kOwn{"measurements.csv", "events.csv",  "checksums.csv",
                                             "session.json",     "session.pvd", "empty.vtp"};
  const std::string& file = one_of(chance, kOwn);
  const fs::path theirs = session.parent_path() / "theirs";
  switch (pick(chance, 4)) {
    case 0:
      fs::remove(session / file);
      EXPECT_EQ(mkfifo((session / file).c_str(), 0600), 0);
      return {{file}, file + ": a pipe"};
    case 1:
      fs::rename(session / file, theirs);
      fs::create_symlink(theirs, session / file);
      return {{file}, file + ": a link"};
    case 2:
      put(session / file, std::string(1000, '\0'));
      return {{file}, file + ": zeros"};
    default: {
      static const std::vector<std::string> kFolders{"surface", "membranes", "tools", "frames", "haptics"};
      const std::string& folder = one_of(chance, kFolders);
      fs::rename(session / folder, theirs);
      fs::create_directory_symlink(theirs, session / folder);
      return {{folder}, folder + ": a link"};
    }
  }
}

}  // namespace

// Every kind of file. `shift` makes another session of the same names.
void write_all_parts(const fs::path& folder, long shift) {
  SessionWriter writer(folder, make_info());
  for (long frame = 0; frame < 4; ++frame) {
    Scene scene = make_scene(frame);
    if (shift != 0) {
      scene.surface = Frozen(make_surface(frame + shift));
      scene.membranes = Frozen(make_membranes(make_observation(frame + shift)));
      scene.tools = Frozen(make_tools(make_observation(frame + shift)));
      scene.frame = Frozen(make_image(frame + shift));
      scene.measurement.contact_force_uN += 1.0;
    }
    writer.write(scene);
  }
  for (int block = 0; block < 2; ++block)
    writer.write_hand(hand_block(block), block + 0.5 * static_cast<double>(shift));
  for (int i = 0; i < 3; ++i) writer.event({0.02 * i, "note", "mutation " + std::to_string(i + shift)});
  writer.close();
}

std::vector<std::string> files_of(const fs::path& session) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(session)) {
    if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), session).string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Mutation mutate(const fs::path& session, const fs::path& other, Chance& chance) {
  switch (pick(chance, 8)) {
    case 0:
      return change_lines(session, one_of(chance, kTables), chance);
    case 1:
      return change_lines(session, "session.pvd", chance);
    case 2:
      return impossible_row(session, chance);
    case 3:
      return not_a_number(session, chance);
    case 4:
      return change_head(session, chance);
    case 5:
      return no_file(session, chance);
    default:
      return change_part(session, other, chance);
  }
}

Mutation flip(const fs::path& session, Chance& chance) {
  const std::string file = one_of(chance, files_of(session));
  std::string text = text_of(session / file);
  const std::size_t at = pick(chance, text.size());
  const int bit = static_cast<int>(pick(chance, 8));
  text[at] = static_cast<char>(text[at] ^ (1 << bit));
  put(session / file, text);
  return {{file}, file + ": bit " + std::to_string(bit) + " of byte " + std::to_string(at)};
}

}  // namespace pellucida::test
