# relevo_embed_shaders(<out-sources> FILES a.glsl b.glsl ...)
#
# Embeds GLSL files as C strings named after the files. Their headers are in the current binary
# folder and private to the module.
include("${VTK_DIR}/vtkEncodeString.cmake")
function (relevo_embed_shaders out)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "FILES")
  set(sources)
  foreach (file IN LISTS arg_FILES)
    vtk_encode_string(INPUT "${file}" HEADER_OUTPUT header SOURCE_OUTPUT source)
    list(APPEND sources "${source}")
  endforeach ()
  set("${out}" "${sources}" PARENT_SCOPE)
endfunction ()
