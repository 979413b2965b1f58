#pragma once
#include <span>
#include <string>

#include "pellucida/core/FieldTable.h"
#include "pellucida/core/Table.h"

namespace pellucida {

/// The names of a table of fields as a header of CSV, without line end.
template <class S>
std::string csv_header(std::span<const Field<S>> columns) {
  std::string header;
  for (const Field<S>& column : columns) {
    if (!header.empty()) header += ',';
    header += column.name;
  }
  return header;
}

/// One object as a row below that header, without line end; NaN is an empty cell.
template <class S>
std::string csv_row(std::span<const Field<S>> columns, const S& object) {
  struct Cell {
    std::string operator()(double value) const { return csv_number(value); }
    std::string operator()(int value) const { return std::to_string(value); }
    std::string operator()(std::uint64_t value) const { return std::to_string(value); }
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(const std::string& value) const { return csv_cell(value); }
  };
  std::string row;
  for (const Field<S>& column : columns) {
    if (&column != &columns.front()) row += ',';
    row += std::visit([&](auto member) { return Cell{}(object.*member); }, column.member);
  }
  return row;
}

}  // namespace pellucida
