# SPDX-License-Identifier: GPL-3.0-or-later
#
# Run by ctest: cmake -D SOURCE_DIR=<root> -D PROGRAM=<path of touchdown> -P check_layers.cmake
# Fails when a file includes a file of a higher room, when files of one room include each other in a circle, when two
# types have one name, when the core includes Qt, when the command line links Qt, when the window may show foreign text
# as HTML, when the parameters of a contact law are read where another may act, and when a folder, a file or a class
# outgrows its limit. tests/check_layers_finds.cmake shows that it finds each of these.

cmake_minimum_required(VERSION 3.25)

# Lowest first: a file may include files of its own room and of those above it in this list.
set(rooms
    core/work
    core/numerics
    core/physics/disk
    core/physics/slider
    core/physics/film/gaps
    core/physics/film
    core/physics/contact
    core/formats
    core/formats/surfaces
    core/case
    core/case_files/cml
    core/case_files
    core/simulation/recording
    core/simulation/contact
    core/simulation/static_state
    core/simulation/springs
    core/simulation/small_motions
    core/simulation/flight
    core/simulation/equilibria
    core/simulation
    core/results
    core/studies/study
    core/studies/lesson
    core/studies/runs
    core/studies/sweep
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
    core/studies/engine
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
    ui/runs
    ui/workbench
    ui/guides
    ui/sessions
    ui/window
    app/terminal
    app/commands
    app/workbench)
# The room of a further kind of study needs no line here: no other study includes it.
file(GLOB folders LIST_DIRECTORIES true RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/core/studies/*)
foreach(folder IN LISTS folders)
    if(IS_DIRECTORY ${SOURCE_DIR}/${folder} AND NOT folder IN_LIST rooms)
        list(FIND rooms core/studies place)
        list(INSERT rooms ${place} ${folder})
    endif()
endforeach()
set(most_files 50)          # in a room
set(planned_lines 400)      # in a file; a longer one is split by the next larger change
set(most_lines 440)         # in a file
set(most_lines_of_class 900) # in its header and all sources that define its members
# Larger classes, with their lines. Each may grow by most_growth lines until it is split.
set(large_classes MainWindow=1226 GasFilm=1346 LivePlots=945)
set(most_growth 50)

# Includes within a room that close a circle of files, a header and its source counted as one. A new one must not be
# added where a declaration or a file of its own avoids it.
set(known_arrows
    # The source of an interface makes its parts, which derive from the interface or fill in its structs.
    core/case/parameters->core/case/parameter_builders
    core/physics/film/gaps/film_gaps->core/physics/film/gaps/cut_rows
    core/physics/film/gaps/film_gaps->core/physics/film/gaps/gap_sampler
    core/simulation/contact/contact_model->core/simulation/contact/elastic_pad
    core/simulation/contact/slider_contact->core/simulation/contact/elastic_slider_contact
    core/simulation/contact/slider_contact->core/simulation/contact/gap_contact
    core/simulation/contact/slider_contact->core/simulation/contact/pad_contact
    ui/maps/field_sections->ui/maps/field_cursor_table
    ui/slider/slider_plan->ui/slider/plan_marks
    # A part takes a struct from the header of the file that uses the part: options, a result, a state.
    app/commands/study_command->app/commands/case_commands
    core/results/stored_values->core/results/results_reader
    core/results/stored_values->core/results/steady_reader
    core/studies/study/stored_report->core/studies/study/study_file_reader
    core/simulation/contact/contact_doubts->core/simulation/contact/contact_run
    core/simulation/flight/film_recorder->core/simulation/flight/film_run
    core/simulation/flight/film_scene->core/simulation/flight/film_run
    core/studies/advice/reduced_models->core/studies/advice/advisor_study
    core/studies/statements/statement_task->core/studies/statements/statements
    ui/plot/cursor_place->ui/plot/plot_widget
    ui/plot/curve_picture->ui/plot/plot_widget
    ui/plot/phase_picture->ui/plot/plot_widget
    ui/plot/plot_export->ui/plot/plot_widget
    ui/plot/plot_navigation->ui/plot/plot_widget
    ui/plot/plot_painter->ui/plot/plot_widget
    # The static state finds sensitivities, which need static states of changed cases.
    core/simulation/static_state/steady->core/simulation/static_state/sensitivity
    core/simulation/static_state/contact_rest->core/simulation/static_state/sensitivity)

set(problems "")

# The arrows of `arrows` ("from->to") that lie on a circle or between two circles: each pass removes the files that
# nothing leads to or that lead nowhere.
function(find_circles arrows result)
    set(before "")
    while(NOT arrows STREQUAL before)
        set(before "${arrows}")
        string(REGEX REPLACE "->[^;]*" "" starts "${arrows}")
        string(REGEX REPLACE "[^;]*->" "" ends "${arrows}")
        set(arrows "")
        foreach(start end IN ZIP_LISTS starts ends)
            if(start IN_LIST ends AND end IN_LIST starts)
                list(APPEND arrows "${start}->${end}")
            endif()
        endforeach()
    endwhile()
    set(${result} "${arrows}" PARENT_SCOPE)
endfunction()

set(found_arrows "") # known ones that are still there
foreach(room IN LISTS rooms)
    set(arrows "") # from one file of the room to another
    file(GLOB sources RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/${room}/*.h ${SOURCE_DIR}/${room}/*.cpp)
    list(LENGTH sources count)
    if(count EQUAL 0)
        list(APPEND problems "${room}: no source was found, so nothing was checked")
    elseif(count GREATER most_files)
        list(APPEND problems "${room}: holds ${count} files, at most ${most_files} are allowed")
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
            if(room STREQUAL included AND path MATCHES "^(core|ui|app)/")
                cmake_path(REMOVE_EXTENSION source OUTPUT_VARIABLE from)
                cmake_path(REMOVE_EXTENSION path OUTPUT_VARIABLE to)
                if("${from}->${to}" IN_LIST known_arrows)
                    list(APPEND found_arrows "${from}->${to}")
                elseif(NOT from STREQUAL to)
                    list(APPEND arrows "${from}->${to}")
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
    list(REMOVE_DUPLICATES arrows)
    find_circles("${arrows}" circle)
    foreach(arrow IN LISTS circle)
        list(APPEND problems "${arrow} is part of a circle of files that include each other")
    endforeach()
endforeach()
foreach(arrow IN LISTS known_arrows)
    if(NOT arrow IN_LIST found_arrows)
        list(APPEND problems "${arrow} is no longer there: remove it from known_arrows")
    endif()
endforeach()

# Every folder has its place in the list, no file is too long, and a name in the namespace touchdown has one type.
file(GLOB_RECURSE sources RELATIVE ${SOURCE_DIR}
    ${SOURCE_DIR}/core/*.h ${SOURCE_DIR}/core/*.cpp ${SOURCE_DIR}/ui/*.h ${SOURCE_DIR}/ui/*.cpp
    ${SOURCE_DIR}/app/*.h ${SOURCE_DIR}/app/*.cpp)
set(types "") # for each name of a type files_of_<name>: its header and the sources that define its members
set(long_files "")
foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH room)
    if(NOT room IN_LIST rooms)
        list(APPEND problems "${source}: its folder has no place in the list of rooms")
    endif()
    file(READ ${SOURCE_DIR}/${source} text)
    string(REGEX MATCHALL "\n" ends "${text}")
    list(LENGTH ends lines_of_${source})
    if(lines_of_${source} GREATER most_lines)
        list(APPEND problems "${source}: has ${lines_of_${source}} lines, at most ${most_lines} are allowed")
    elseif(lines_of_${source} GREATER planned_lines)
        list(APPEND long_files "${source}: ${lines_of_${source}} lines")
    endif()

    # clang-format sets what a namespace holds at the start of the line, and a comment at its end.
    file(STRINGS ${SOURCE_DIR}/${source} lines
        REGEX "^(namespace [^=]*{|} // namespace|(struct|class|enum|enum class|concept) )")
    set(namespaces "")
    foreach(line IN LISTS lines)
        if(line MATCHES "^namespace (.*){")
            list(APPEND namespaces ":${CMAKE_MATCH_1}")
        elseif(line MATCHES "^}")
            list(POP_BACK namespaces)
        elseif(namespaces STREQUAL ":touchdown " AND NOT line MATCHES "^[^{]*;" AND
               line MATCHES "^(enum class|[a-z]+) ([A-Za-z0-9_]+)( |$)")
            set(type ${CMAKE_MATCH_2})
            if(type IN_LIST types)
                list(APPEND problems "${source}: the type ${type} has its name from ${files_of_${type}} too")
            endif()
            list(APPEND types ${type})
            list(APPEND files_of_${type} ${source})
        endif()
    endforeach()
endforeach()
foreach(source IN LISTS sources)
    if(source MATCHES "\\.cpp$")
        # The last name before that of the member: `void GasFilm::assemble(`, `GasFilm::Part GasFilm::part(`.
        set(member "^([A-Za-z][^(=]*[^A-Za-z0-9_:(=])?([A-Za-z0-9_]+)::~?[A-Za-z0-9_]+\\(")
        file(STRINGS ${SOURCE_DIR}/${source} lines REGEX "${member}")
        foreach(line IN LISTS lines)
            if(line MATCHES "${member}")
                set(type ${CMAKE_MATCH_2})
                if(type IN_LIST types AND NOT source IN_LIST files_of_${type})
                    list(APPEND files_of_${type} ${source})
                endif()
            endif()
        endforeach()
    endif()
endforeach()
foreach(type IN LISTS types)
    set(lines 0)
    foreach(source IN LISTS files_of_${type})
        math(EXPR lines "${lines} + ${lines_of_${source}}")
    endforeach()
    set(most ${most_lines_of_class})
    if("${large_classes};" MATCHES "${type}=([0-9]+);")
        math(EXPR most "${CMAKE_MATCH_1} + ${most_growth}")
        if(lines LESS_EQUAL most_lines_of_class)
            list(APPEND problems "class ${type}: has ${lines} lines: remove it from large_classes")
        endif()
    endif()
    if(lines GREATER most)
        list(LENGTH files_of_${type} count)
        list(APPEND problems "class ${type}: has ${lines} lines in ${count} files, at most ${most} are allowed")
    endif()
endforeach()
if(long_files)
    list(JOIN long_files "\n  " text)
    message(WARNING "Longer than ${planned_lines} lines:\n  ${text}")
endif()

# The rules of ui/style/foreign_text.h. A tool tip is {}, a literal tr("..."), plainTip(...), or HTML of the program in
# a name that ends with htmlTip. Documents of HTML are those that read no file. Nothing else makes HTML of a text.
foreach(source IN LISTS sources)
    if(NOT source MATCHES "^(ui|app)/" OR source MATCHES "^ui/style/foreign_text")
        continue()
    endif()
    file(READ ${SOURCE_DIR}/${source} text)
    string(REGEX REPLACE "\\\\." "" text "${text}") # escapes within literals
    string(REGEX REPLACE "\"[^\"\n]*\"" "\"\"" text "${text}")
    string(REGEX REPLACE "//[^\n]*" "" text "${text}")
    string(REGEX REPLACE "[][]" " " text "${text}") # would join elements of a list
    string(REGEX REPLACE "[ \n]+" " " text "${text}")
    string(REPLACE ";" "$" text "${text}")
    string(REGEX MATCHALL "(set[a-zA-Z]*ToolTip|QToolTip::showText)\\([^$]+\\)|[^\${}]*ToolTipRole[^$]*" tips "${text}")
    foreach(tip IN LISTS tips)
        if(NOT tip MATCHES "^[a-zA-Z]+\\( ?(tr\\( ?(\"\" ?)+\\)|{})\\)$|plainTip\\(|[hH]tmlTip|^Qt::ToolTipRole}")
            list(APPEND problems "${source}: the tool tip ${tip} is no literal, plainTip() or htmlTip")
        endif()
    endforeach()
    if(text MATCHES "(new QTextBrowser|public QTextBrowser|<QTextDocument>\\(|QTextDocument [a-z]+ ?[$({])")
        list(APPEND problems "${source}: a document of HTML is an OwnDocument or an OwnTextBrowser")
    endif()
    if(text MATCHES "(Qt::AutoText|QErrorMessage|QStaticText|QSplashScreen|setWhatsThis|setMarkdown)")
        list(APPEND problems "${source}: uses ${CMAKE_MATCH_1}, which makes HTML from any text")
    endif()
endforeach()

# The parameters of Ono and Yamane belong to one law: who needs them asks characteristic() in core/case/contact_law.h,
# which gives none under another law.
foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH room)
    if(room MATCHES "^core/case(_files)?(/|$)")
        continue()
    endif()
    file(STRINGS ${SOURCE_DIR}/${source} lines REGEX "[.>]onoYamane")
    if(lines)
        list(APPEND problems "${source}: reads the parameters of one contact law: ask characteristic()")
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
