# SPDX-License-Identifier: GPL-3.0-or-later
#
# Run by ctest: cmake -D SOURCE_DIR=<root> -P check_readme.cmake
# Fails when a README names a file that does not exist, leaves out a room, or is too long.

cmake_minimum_required(VERSION 3.25)

set(readmes README.md CONTRIBUTING.md core/README.md ui/README.md app/README.md tests/bench/README.md)
set(most_lines 150) # of the first one
set(problems "")

# What is there of a path, from the root or from the folder of the README. A star stands for any text.
function(find_path_of path readme result)
    cmake_path(GET readme PARENT_PATH folder)
    string(REGEX REPLACE "/$" "" path "${path}")
    file(GLOB found ${SOURCE_DIR}/${path} ${SOURCE_DIR}/${folder}/${path})
    set(${result} "${found}" PARENT_SCOPE)
endfunction()

foreach(readme IN LISTS readmes)
    if(NOT EXISTS ${SOURCE_DIR}/${readme})
        list(APPEND problems "${readme} is missing")
        continue()
    endif()
    file(READ ${SOURCE_DIR}/${readme} text)
    # Brackets and semicolons have a meaning in lists of CMake. Fenced blocks hold commands, not paths.
    string(REPLACE ";" "," text "${text}")
    string(REGEX REPLACE "\\]\\(([^)]*)\\)" " {link:\\1} " text "${text}")
    string(REPLACE "[" "(" text "${text}")
    string(REPLACE "]" ")" text "${text}")
    string(REGEX REPLACE "```[^`]*```" "" text "${text}")

    set(paths "")
    string(REGEX MATCHALL "{link:[^}]*}" links "${text}")
    foreach(link IN LISTS links)
        string(REGEX REPLACE "{link:([^}#]*)[^}]*}" "\\1" path "${link}")
        if(NOT path MATCHES "^(https?:|mailto:|$)")
            list(APPEND paths "${path}")
        endif()
    endforeach()
    string(REGEX MATCHALL "`[^`]*`" words "${text}")
    foreach(word IN LISTS words)
        string(REGEX REPLACE "`(\\./)?([^`]*)`" "\\2" path "${word}")
        # A path has a slash or the ending of a source or a text. /fields is in an HDF5 file, build/ is made by the
        # build.
        if(path MATCHES "^[A-Za-z0-9_.*-]+(/[A-Za-z0-9_.*-]*)+$" OR
           path MATCHES "^[A-Za-z0-9_-]+\\.(h|cpp|md|cmake|py)$")
            if(NOT path MATCHES "^build/")
                list(APPEND paths "${path}")
            endif()
        endif()
    endforeach()
    list(REMOVE_DUPLICATES paths)
    foreach(path IN LISTS paths)
        find_path_of("${path}" ${readme} found)
        if(NOT found)
            list(APPEND problems "${readme} names ${path}, which does not exist")
        endif()
    endforeach()
    set(words_of_${readme} "${words}")
endforeach()

# Every room of the layers is named in the README of its part, from the root or from there.
file(READ ${SOURCE_DIR}/tests/check_layers.cmake layers)
if(NOT layers MATCHES "set\\(rooms([^)]*)\\)")
    message(FATAL_ERROR "tests/check_layers.cmake has no list of rooms")
endif()
string(REGEX MATCHALL "[a-z_/]+" rooms "${CMAKE_MATCH_1}")
foreach(room IN LISTS rooms)
    string(REGEX MATCH "^[^/]+" part "${room}")
    string(REPLACE "${part}/" "" name "${room}")
    set(named "${words_of_${part}/README.md}")
    if(NOT "`${room}`" IN_LIST named AND NOT "`${name}`" IN_LIST named)
        list(APPEND problems "${part}/README.md leaves out the room ${room}")
    endif()
endforeach()

file(READ ${SOURCE_DIR}/README.md text)
string(REGEX MATCHALL "\n" ends "${text}")
list(LENGTH ends count)
if(count GREATER most_lines)
    list(APPEND problems "README.md has ${count} lines, at most ${most_lines} are allowed")
endif()

if(problems)
    list(JOIN problems "\n  " text)
    message(FATAL_ERROR "READMEs:\n  ${text}")
endif()
