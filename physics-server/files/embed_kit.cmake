# Writes ${OUT}: the text of ${KIT} as a constant.
file(READ ${KIT} lines)
set(text "// Made from kits/standard.kit by CMake.\n#include \"files/kit_file.hpp\"\n\n")
string(APPEND text "namespace percussionist::files {\n\n")
string(APPEND text "std::string_view standard_kit_text() {\n    return R\"kit(${lines})kit\";\n}\n\n")
string(APPEND text "}  // namespace percussionist::files\n")
file(WRITE ${OUT} "${text}")
