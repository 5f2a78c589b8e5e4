# Wrong formulas of lib/waves, all in one executable: wrong_formula(name RIGHT text WRONG text CAUGHT_BY Suite.Name)
# puts `(chosen == n ? (WRONG) : (RIGHT))` for RIGHT, an expression that must stand in lib/waves/${source} exactly once,
# and adds the test `mutant.<source>.<name>`, which passes when, with n chosen, the test Suite.Name says that it failed.
# Wrong forms of one expression share RIGHT; expressions must not overlap otherwise.
function(wrong_formula name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "RIGHT;WRONG;CAUGHT_BY" "")
  set(file "${PROJECT_SOURCE_DIR}/lib/waves/${source}")
  if(NOT DEFINED "text_${source}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
    file(READ "${file}" text)
    list(APPEND sources ${source})
  else()
    set(text "${text_${source}}")
  endif()

  math(EXPR count "${count} + 1")
  set(right "/*right*/(${ARG_RIGHT})") # what later wrong forms of the same expression look for
  string(FIND "${text}" "${right}" first)
  if(first EQUAL -1)
    string(FIND "${text}" "${ARG_RIGHT}" first)
    string(FIND "${text}" "${ARG_RIGHT}" last REVERSE)
    if(first EQUAL -1 OR NOT first EQUAL last)
      message(FATAL_ERROR "${name}: '${ARG_RIGHT}' must stand in ${file} once and overlap no other wrong formula")
    endif()
    string(REPLACE "${ARG_RIGHT}" "(${right})" text "${text}")
  endif()
  string(REPLACE "${right}" "mutation::chosen == ${count} ? (${ARG_WRONG}) : ${right}" text "${text}")

  cmake_path(GET source STEM stem)
  add_test(NAME mutant.${stem}.${name} COMMAND mutants --gtest_filter=${ARG_CAUGHT_BY})
  string(REPLACE "." "\\." caught "${ARG_CAUGHT_BY}")
  set_tests_properties(mutant.${stem}.${name} PROPERTIES ENVIRONMENT PELAGIC_MUTANT=${count} TIMEOUT 600
                                                         PASS_REGULAR_EXPRESSION "\\[  FAILED  \\] ${caught}")
  list(APPEND filter ${ARG_CAUGHT_BY})
  foreach(variable count sources filter)
    set(${variable} "${${variable}}" PARENT_SCOPE)
  endforeach()
  set("text_${source}" "${text}" PARENT_SCOPE)
endfunction()
