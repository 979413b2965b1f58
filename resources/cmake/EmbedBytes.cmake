# Writes the bytes of FILE (none where it is missing) as the C++ array NAME with its size NAMESize into OUTPUT.
set(bytes "")
if(FILE AND EXISTS "${FILE}")
  file(READ "${FILE}" hex HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
endif()
file(WRITE "${OUTPUT}" "#include <cstddef>\nnamespace pellucida {\nextern const unsigned char ${NAME}[];\n"
  "extern const std::size_t ${NAME}Size;\nconst unsigned char ${NAME}[] = {${bytes}0};\n"
  "const std::size_t ${NAME}Size = sizeof ${NAME};\n}  // namespace pellucida\n")
