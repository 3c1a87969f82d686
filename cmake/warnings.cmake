# SPDX-License-Identifier: MIT
add_library(vitrine_flags INTERFACE)
target_compile_options(vitrine_flags INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor)
if(VITRINE_WERROR)
    target_compile_options(vitrine_flags INTERFACE -Werror)
endif()
if(VITRINE_SANITIZE)
    target_compile_options(vitrine_flags INTERFACE
        -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(vitrine_flags INTERFACE -fsanitize=address,undefined)
endif()
