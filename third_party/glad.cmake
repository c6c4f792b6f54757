# glad
# Version: 2.0.2; 2.0
# Licence: MIT (generator), public domain (output)
# Why: loads exactly the OpenGL 4.3 core functions and the extensions named here; generated at build time, so no generated code is kept.
find_program(NUNO_GLAD glad)
if(NUNO_GLAD)
    set(glad_dir ${PROJECT_BINARY_DIR}/glad)
    add_custom_command(
        OUTPUT ${glad_dir}/src/gl.c ${glad_dir}/include/glad/gl.h ${glad_dir}/include/KHR/khrplatform.h
        COMMAND ${NUNO_GLAD} --reproducible --quiet --api gl:core=4.3
            --extensions GL_KHR_debug,GL_KHR_robustness,GL_ARB_get_program_binary --out-path ${glad_dir} c
        COMMENT "Generating the OpenGL 4.3 loader"
        VERBATIM)
    add_library(third_party_glad STATIC ${glad_dir}/src/gl.c ${glad_dir}/include/glad/gl.h)
    target_include_directories(third_party_glad SYSTEM PUBLIC ${glad_dir}/include)
    add_library(third_party::glad ALIAS third_party_glad)
else()
    nuno_missing("glad" python3-glad)
endif()
