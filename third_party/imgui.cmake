# Dear ImGui
# Version: 1.86; 1.85 or newer
# Licence: MIT
# Why: panels drawn in the same GL context as the cloth; the package holds the GLFW and OpenGL 3 backends.
# The archive calls GLFW and the dynamic loader but names neither; both are linked after it.
nuno_find_module(imgui "imgui>=1.85" libimgui-dev)
if(imgui_FOUND)
    target_link_libraries(PkgConfig::imgui INTERFACE ${CMAKE_DL_LIBS})
    if(glfw_FOUND)
        target_link_libraries(PkgConfig::imgui INTERFACE PkgConfig::glfw)
    endif()
endif()
