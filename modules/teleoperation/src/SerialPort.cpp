#include "pellucida/teleoperation/SerialPort.h"

#include <grp.h>
#include <libserialport.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

/// Milliseconds for libserialport, where 0 would mean "for ever".
unsigned int milliseconds(double timeout_s) {
  return static_cast<unsigned int>(std::clamp(std::ceil(timeout_s * 1000.0), 1.0, 3.6e6));
}

std::string group_of(const std::string& path) {
  struct stat info {};
  if (stat(path.c_str(), &info) != 0) return "dialout";
  const group* owner = getgrgid(info.st_gid);
  return owner ? owner->gr_name : std::to_string(info.st_gid);
}

std::string no_permission(const std::string& path) {
  return "no permission to read and write " + path + "; add yourself to its group: sudo adduser \"$USER\" " +
         group_of(path) + ", and log in again";
}

/// libserialport's message of the last failure.
std::string last_message() {
  char* text = sp_last_error_message();
  const std::string message = text ? text : "unknown fault";
  sp_free_error_message(text);
  return message;
}

/// Why `path` can't be opened, as far as can be determined without opening it; empty when there is no objection.
std::string trouble_with(const std::string& path) {
  if (access(path.c_str(), F_OK) != 0) return "there is no " + path + "; plug the device in, or name another port";
  if (access(path.c_str(), R_OK | W_OK) != 0) return no_permission(path);
  return {};
}

}  // namespace

std::vector<SerialPortInfo> serial_ports() {
  std::vector<SerialPortInfo> found;
  sp_port** ports = nullptr;
  if (sp_list_ports(&ports) != SP_OK) return found;
  for (sp_port** port = ports; *port; ++port) {
    const char* description = sp_get_port_description(*port);
    const std::string path = sp_get_port_name(*port);
    found.push_back({path, description ? description : "", trouble_with(path)});
  }
  sp_free_port_list(ports);
  return found;
}

std::string serial_port_library_version() {
  return sp_get_package_version_string();
}

void SerialPort::Closer::operator()(sp_port* port) const noexcept {
  sp_close(port);
  sp_free_port(port);
}

SerialPort::SerialPort(const std::string& path, int baud) : path_(path) {
  if (const std::string trouble = trouble_with(path); !trouble.empty()) throw DeviceError("serial port: " + trouble);
  // A name below /dev/serial/by-id is a link; libserialport knows the port by its own name only.
  char* resolved = realpath(path.c_str(), nullptr);
  const std::string own_name = resolved ? resolved : path;
  std::free(resolved);
  sp_port* port = nullptr;
  if (sp_get_port_by_name(own_name.c_str(), &port) != SP_OK) {
    throw DeviceError("serial port: " + path + " is no serial port of this machine; pellucida devices lists them");
  }
  port_.reset(port);
  if (sp_open(port, SP_MODE_READ_WRITE) != SP_OK) {
    const bool busy = sp_last_error_code() == EBUSY;
    throw DeviceError("serial port: " + path + " can't be opened (" + last_message() + ")" +
                      (busy ? "; another program has it open: close that one" : ""));
  }
  const bool set = sp_set_baudrate(port, baud) == SP_OK && sp_set_bits(port, 8) == SP_OK &&
                   sp_set_parity(port, SP_PARITY_NONE) == SP_OK && sp_set_stopbits(port, 1) == SP_OK &&
                   sp_set_flowcontrol(port, SP_FLOWCONTROL_NONE) == SP_OK;
  if (!set) {
    throw DeviceError("serial port: " + path + " does not take " + std::to_string(baud) +
                      " baud, 8 data bits, no parity, 1 stop bit (" + last_message() + ")");
  }
}

void SerialPort::lost(const char* doing) const {
  throw DeviceError("serial port: " + path_ + " is gone, while " + doing + " (" + last_message() +
                    "); check cable and power");
}

void SerialPort::write(std::string_view bytes, double timeout_s) {
  const int written = sp_blocking_write(port_.get(), bytes.data(), bytes.size(), milliseconds(timeout_s));
  if (written < 0) lost("writing");
  if (static_cast<std::size_t>(written) < bytes.size()) {
    throw DeviceError("serial port: " + path_ + " took " + std::to_string(written) + " of " +
                      std::to_string(bytes.size()) + " bytes within " + std::to_string(timeout_s) +
                      " s; check cable and power");
  }
}

std::size_t SerialPort::read(char* into, std::size_t capacity, double timeout_s) {
  const int count = sp_blocking_read_next(port_.get(), into, capacity, milliseconds(timeout_s));
  if (count < 0) lost("reading");
  // A port pulled out may read as silence: asking how much waits reveals it.
  if (count == 0 && sp_input_waiting(port_.get()) < 0) lost("reading");
  return static_cast<std::size_t>(count);
}

void SerialPort::discard_input() noexcept {
  sp_flush(port_.get(), SP_BUF_INPUT);
}

}  // namespace pellucida
