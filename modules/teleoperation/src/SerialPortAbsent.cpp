// In place of SerialPort.cpp where libserialport was left out of the build (PELLUCIDA_WITH_SERIALPORT=OFF). No port can
// be opened, so that nothing below the constructor is ever reached.
#include "NotInThisBuild.h"
#include "pellucida/core/Error.h"
#include "pellucida/teleoperation/SerialPort.h"

namespace pellucida {
namespace {

[[noreturn]] void refuse() {
  throw DeviceError("serial port: " + not_in_this_build("serial port", "libserialport", "PELLUCIDA_WITH_SERIALPORT",
                                                        "libserialport-dev"));
}

}  // namespace

std::vector<SerialPortInfo> serial_ports() {
  refuse();
}

std::string serial_port_library_version() {
  return {};
}

void SerialPort::Closer::operator()(sp_port*) const noexcept {}

SerialPort::SerialPort(const std::string& path, int) : path_(path) {
  refuse();
}

void SerialPort::write(std::string_view, double) {
  refuse();
}

std::size_t SerialPort::read(char*, std::size_t, double) {
  refuse();
}

void SerialPort::discard_input() noexcept {}

}  // namespace pellucida
