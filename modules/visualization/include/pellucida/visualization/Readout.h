#pragma once
#include <string>

#include "pellucida/core/Measurement.h"

namespace pellucida {

/// The numbers of a measurement for display, UTF-8, with units. A dash ("–") means "not measured". Digits are chosen so
/// that a number neither jumps in width nor shows more than the measurement supports.
namespace readout {
/// "No cell", "Free", "Contact", "Punctured", "Lost".
/// A dash for a frame that was not measured.
std::string state(std::optional<CellState> state);
/// "23.4 µm"
std::string indentation(const Measurement& m);
/// "3.42 µN"
std::string force(const Measurement& m);
/// "3.10 – 3.75 µN", empty when there is no interval.
std::string force_interval(const Measurement& m);
/// "picture ±9 %, kind of cell ±46 %": the interval's two parts, standard deviations; empty without a force or parts.
std::string force_parts(const Measurement& m);
/// "152 Pa"
std::string pressure(const Measurement& m);
/// "97 %"
std::string confidence(const Measurement& m);
/// "12.40 s"
std::string time(double time_s);
/// "18 ms"
std::string milliseconds(double value_ms);
/// `value` with `decimals` digits after the point, or "–" for NaN.
std::string number(double value, int decimals);
/// A number with just the digits it needs: "0.05", "2", "2.5".
std::string plain(double value);
}  // namespace readout

}  // namespace pellucida
