# GLFW
# Version: 3.3.8; 3.3 or newer
# Licence: zlib
# Why: the smallest library that opens a window with an OpenGL 4.3 core context and gives input on every desktop.
nuno_find_module(glfw "glfw3>=3.3" libglfw3-dev)
if(glfw_FOUND)
    # glad declares OpenGL; GLFW must not bring the system's header as well.
    target_compile_definitions(PkgConfig::glfw INTERFACE GLFW_INCLUDE_NONE)
endif()
