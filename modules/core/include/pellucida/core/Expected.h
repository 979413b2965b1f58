#pragma once
#include <tl/expected.hpp>

namespace pellucida {

/// The result of a step that may fail in an expected, per-frame way (contour lost, no convergence).
/// Bad arguments, files and devices throw `Error` instead.
template <class T, class E>
using expected = tl::expected<T, E>;

template <class E>
using unexpected = tl::unexpected<E>;

}  // namespace pellucida
