# cmake -D BUILD_DIRECTORY=... -D CONSUMER=... -D CXX_COMPILER=... -D GENERATOR=... -P install_test.cmake
# Installs to a prefix that is far from the source tree, builds an outside project against it, and runs the installed
# program from another folder.
cmake_minimum_required(VERSION 3.25)

string(RANDOM LENGTH 12 name)
set(temporary /tmp)
if(DEFINED ENV{TMPDIR})
  set(temporary $ENV{TMPDIR})
endif()
set(place ${temporary}/millwright-install-${name})
file(MAKE_DIRECTORY ${place}/elsewhere)

function(fail message)
  file(REMOVE_RECURSE ${place})
  message(FATAL_ERROR "${message}")
endfunction()

# run(<folder> <command...>): standard output in `output`, exit code in `code`.
function(run folder)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${folder} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  set(code ${code} PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
  set(errors "${errors}" PARENT_SCOPE)
endfunction()

function(expect what expected_code expected_output)
  if(NOT code EQUAL expected_code OR NOT output MATCHES "${expected_output}")
    fail("${what}: exit code ${code}, expected ${expected_code}; output should match '${expected_output}':\n${output}${errors}")
  endif()
endfunction()

set(prefix ${place}/prefix)
run(${place} ${CMAKE_COMMAND} --install ${BUILD_DIRECTORY} --prefix ${prefix})
expect("install" 0 "")

# T = 6400 N 0.030 m/2 (0.008 + 0.08 pi 0.030)/(pi 0.030 - 0.08 0.008) = 96 N m 0.01553982/0.09360778 = 15.93696 N m
run(${place} ${CMAKE_COMMAND} -S ${CONSUMER} -B ${place}/consumer -G "${GENERATOR}" -DCMAKE_PREFIX_PATH=${prefix}
  -DCMAKE_CXX_COMPILER=${CXX_COMPILER} "-DCMAKE_CXX_FLAGS=-Wconversion")
expect("configure of an outside project" 0 "")
run(${place} ${CMAKE_COMMAND} --build ${place}/consumer)
expect("build of an outside project" 0 "")
run(${place} ${place}/consumer/consumer)
expect("run of an outside project" 0 "^15\\.93695[0-9]* 1 3\n$")

foreach(file IN ITEMS share/man/man1/millwright.1 share/man/man1/millwright-solve.1 share/doc/millwright/guide/index.html
    share/doc/millwright/guide/problem-file.html share/doc/millwright/problems/sander.toml share/millwright/millwright.schema.json)
  if(NOT EXISTS ${prefix}/${file})
    fail("${file} is not installed")
  endif()
endforeach()

set(ENV{MILLWRIGHT_CATALOGUES})  # the program has to find its catalogues by itself
set(program ${prefix}/bin/millwright)
run(${place}/elsewhere ${program} catalogue list)
expect("catalogue list from another folder" 0 "steppers")
file(RENAME ${prefix}/share/millwright/catalogues ${place}/hidden)
run(${place}/elsewhere ${program} catalogue list)
if(code EQUAL 0)
  fail("the installed program finds catalogues although its own are gone:\n${output}")
endif()
file(REMOVE_RECURSE ${place})
