# Writes ${OUT}: the texts of ${MAPS} as constants.
set(text "// Made from skeletons/*.map by CMake.\n#include \"body/ready_skeleton_maps.hpp\"\n\n")
string(APPEND text "namespace percussionist::body {\n\n")
string(APPEND text
       "const std::vector<std::pair<std::string_view, std::string_view>> kReadySkeletonMaps{\n")
foreach(map ${MAPS})
    get_filename_component(name ${map} NAME_WE)
    file(READ ${map} lines)
    string(APPEND text "    {\"${name}\", R\"map(${lines})map\"},\n")
endforeach()
string(APPEND text "};\n\n}  // namespace percussionist::body\n")
file(WRITE ${OUT} "${text}")
