# Warnings for Pelagic's own targets; system headers are exempt.
function(pelagic_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
  if(PELAGIC_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
