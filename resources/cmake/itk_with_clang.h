// ITK as Debian packages it was configured with GCC and refuses every other compiler by name; clang compiles its
// headers as well. Included by force before the files that use ITK when clang compiles them (fuzzers, thread
// sanitizer).
#pragma once
#pragma push_macro("__clang__")
#pragma push_macro("__GNUC__")
#undef __clang__
#undef __GNUC__
#define __GNUC__ 12
#include <itk_compiler_detection.h>
#pragma pop_macro("__GNUC__")
#pragma pop_macro("__clang__")
