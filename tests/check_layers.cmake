# SPDX-License-Identifier: GPL-3.0-or-later
#
# Run by ctest: cmake -D SOURCE_DIR=<root> -D PROGRAM=<path of touchdown> -P check_layers.cmake
# Fails when an include points to a higher layer, when the core includes Qt, or when the command line links Qt.

cmake_minimum_required(VERSION 3.25)
set(layers app ui core/studies core/simulation core/physics core/numerics) # highest first
set(problems "")

set(higher tests)
foreach(layer IN LISTS layers)
    file(GLOB_RECURSE sources RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/${layer}/*.h ${SOURCE_DIR}/${layer}/*.cpp)
    if(NOT sources)
        list(APPEND problems "${layer}: no source was found, so nothing was checked")
    endif()
    foreach(source IN LISTS sources)
        file(STRINGS ${SOURCE_DIR}/${source} includes REGEX "^[ \t]*#[ \t]*include")
        foreach(include IN LISTS includes)
            string(REGEX REPLACE "^[^<\"]*[<\"]([^>\"]*)[>\"].*$" "\\1" path "${include}")
            foreach(folder IN LISTS higher)
                if(path MATCHES "^${folder}/")
                    list(APPEND problems "${source} includes ${path} of a higher layer")
                endif()
            endforeach()
            if(path MATCHES "\\.\\./" OR (include MATCHES "\"" AND NOT path MATCHES "/|\\.moc$"))
                list(APPEND problems "${source} includes ${path}: write the path from the root of the sources")
            endif()
            if(layer MATCHES "^core/" AND path MATCHES "^Q[A-Z]|^Qt")
                list(APPEND problems "${source} includes ${path}: the core has no Qt")
            endif()
        endforeach()
    endforeach()
    list(APPEND higher ${layer})
endforeach()

# Every folder of the core has its place in the order.
file(GLOB folders RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/core/*)
foreach(folder IN LISTS folders)
    if(IS_DIRECTORY ${SOURCE_DIR}/${folder} AND NOT folder IN_LIST layers)
        list(APPEND problems "${folder}: has no place in the order of the layers")
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
