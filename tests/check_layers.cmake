# SPDX-License-Identifier: GPL-3.0-or-later
#
# Run by ctest: cmake -D SOURCE_DIR=<root> -D PROGRAM=<path of touchdown> -P check_layers.cmake
# Fails when a file includes a file of a higher room, when the core includes Qt, when the command line links Qt, and
# when a folder or a file outgrows its limit.

cmake_minimum_required(VERSION 3.25)

# Lowest first: a file may include files of its own room and of those above it in this list.
set(rooms
    core/numerics
    core/physics/disk
    core/physics/slider
    core/physics/film
    core/physics/contact
    core/formats
    core/formats/surfaces
    core/case
    core/case_files/cml
    core/case_files
    core/simulation/recording
    core/simulation/static_state
    core/simulation/contact
    core/simulation/springs
    core/simulation/flight
    core/simulation/small_motions
    core/simulation/equilibria
    core/simulation
    core/results
    core/studies/study
    core/studies/lesson
    core/studies/runs
    core/studies/precision
    core/studies/stability
    core/studies/hysteresis
    core/studies/cycles
    core/studies/response
    core/studies/advice
    core/studies/convergence
    core/studies/design
    core/studies/statements
    core/studies
    ui/style
    ui/calculation
    ui/plot
    ui/slider
    ui/maps
    ui/case
    ui/lists
    ui/film
    ui/disk
    ui/studies
    ui/lesson
    ui/runs
    ui/window
    app/terminal
    app/commands
    app/workbench)
set(most_files 50)  # in a room
set(most_lines 400) # in a file
set(problems "")

foreach(room IN LISTS rooms)
    file(GLOB sources RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/${room}/*.h ${SOURCE_DIR}/${room}/*.cpp)
    list(LENGTH sources count)
    if(count EQUAL 0)
        list(APPEND problems "${room}: no source was found, so nothing was checked")
    elseif(count GREATER most_files)
        list(APPEND problems "${room}: holds ${count} files; at most ${most_files} are allowed")
    endif()
    list(FIND rooms ${room} place)
    foreach(source IN LISTS sources)
        file(STRINGS ${SOURCE_DIR}/${source} includes REGEX "^[ \t]*#[ \t]*include")
        foreach(include IN LISTS includes)
            string(REGEX REPLACE "^[^<\"]*[<\"]([^>\"]*)[>\"].*$" "\\1" path "${include}")
            if(path MATCHES "^(core|ui|app|tests)/")
                cmake_path(GET path PARENT_PATH included)
                list(FIND rooms "${included}" included_place)
                if(included_place EQUAL -1 OR included_place GREATER place)
                    list(APPEND problems "${source} includes ${path} of a higher room")
                endif()
            endif()
            if(path MATCHES "\\.\\./" OR (include MATCHES "\"" AND NOT path MATCHES "/|\\.moc$"))
                list(APPEND problems "${source} includes ${path}: write the path from the root of the sources")
            endif()
            if(room MATCHES "^core/" AND path MATCHES "^Q[A-Z]|^Qt")
                list(APPEND problems "${source} includes ${path}: the core has no Qt")
            endif()
        endforeach()
    endforeach()
endforeach()

# Every folder has its place in the list, and no file is too long.
file(GLOB_RECURSE sources RELATIVE ${SOURCE_DIR}
    ${SOURCE_DIR}/core/*.h ${SOURCE_DIR}/core/*.cpp ${SOURCE_DIR}/ui/*.h ${SOURCE_DIR}/ui/*.cpp
    ${SOURCE_DIR}/app/*.h ${SOURCE_DIR}/app/*.cpp)
foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH room)
    if(NOT room IN_LIST rooms)
        list(APPEND problems "${source}: its folder has no place in the list of rooms")
    endif()
    file(READ ${SOURCE_DIR}/${source} text)
    string(REGEX MATCHALL "\n" ends "${text}")
    list(LENGTH ends lines)
    if(lines GREATER most_lines)
        list(APPEND problems "${source}: has ${lines} lines; at most ${most_lines} are allowed")
    endif()
endforeach()

# ldd follows the libraries of the libraries, too.
execute_process(COMMAND ldd ${PROGRAM} OUTPUT_VARIABLE libraries RESULT_VARIABLE status)
if(NOT status EQUAL 0 OR NOT libraries MATCHES "libhdf5")
    list(APPEND problems "ldd did not list the libraries of ${PROGRAM}")
elseif(libraries MATCHES "libQt[^ \n]*")
    list(APPEND problems "${PROGRAM} links ${CMAKE_MATCH_0}")
endif()

if(problems)
    list(JOIN problems "\n  " text)
    message(FATAL_ERROR "Layers:\n  ${text}")
endif()
