# SPDX-License-Identifier: GPL-3.0-or-later
#
# Run by ctest: cmake -D SOURCE_DIR=<root> -D FOLDER=<a folder to write> -P check_layers_finds.cmake
# Writes sources with one fault of each kind that check_layers looks for, and fails where it does not report one, or
# reports what is allowed.

cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${FOLDER})

# A source of `lines` lines: `text`, which ends its last line, and empty lines.
function(write path lines text)
    string(REGEX MATCHALL "\n" ends "${text}")
    list(LENGTH ends count)
    math(EXPR missing "${lines} - ${count}")
    string(REPEAT "\n" ${missing} rest)
    file(WRITE ${FOLDER}/${path} "${text}${rest}")
endfunction()

set(inside "namespace touchdown {\n")
set(unnamed "namespace touchdown {\nnamespace {\n")

write(core/numerics/low.h 1 "#include \"core/case/case.h\"\n")
write(core/numerics/path.h 2 "#include \"../case/case.h\"\n#include \"near.h\"\n")
write(core/numerics/window.h 1 "#include <QWidget>\n")
write(core/elsewhere/lost.h 1 "")

# a -> b by a header, b -> c by a source, c -> a; leads_in and leads_out are not on the circle.
write(core/case/leads_in.h 1 "#include \"core/case/a.h\"\n")
write(core/case/a.h 2 "#include \"core/case/b.h\"\n#include \"core/case/leads_out.h\"\n")
write(core/case/b.h 1 "")
write(core/case/b.cpp 2 "#include \"core/case/b.h\"\n#include \"core/case/c.h\"\n")
write(core/case/c.h 1 "#include \"core/case/a.h\"\n")
write(core/case/leads_out.h 1 "")

# One name in two rooms; a declaration, a type of one source and a type inside another are no second type.
write(core/case/twin.h 4 "${inside}struct Twin {\n};\n} // namespace touchdown\n")
write(core/formats/twin.h 3 "${inside}enum class Twin : int { A };\n} // namespace touchdown\n")
write(core/case/single.h 4 "${inside}class Single final : public Twin {\n};\n} // namespace touchdown\n")
write(core/case/other.h 3 "${inside}class Single; // core/case/single.h\n} // namespace touchdown\n")
write(core/case/other.cpp 9 "${unnamed}struct Single {\n};\n} // namespace\n\nstruct Whole::Single {\n};\n\
} // namespace touchdown\n")

write(core/results/planned.cpp 400 "")
write(core/results/longer.cpp 401 "")
write(core/results/longest.cpp 440 "")
write(core/results/too_long.cpp 441 "")

# 100 + 400 + 400 lines are a whole class, one more is too much; the source of another class does not count.
foreach(extra 0 1)
    write(core/results/class${extra}.h 100 "${inside}class Large${extra} {\n};\n} // namespace touchdown\n")
    write(core/results/class${extra}.cpp 400 "${inside}void Large${extra}::begin()\n{\n}\n} // namespace touchdown\n")
    math(EXPR lines "400 + ${extra}")
    write(core/results/class${extra}_end.cpp ${lines}
        "${inside}Large${extra}::Part Large${extra}::end(int a)\n{\n}\n} // namespace touchdown\n")
    write(core/results/class${extra}_user.cpp 400 "${inside}const int a = f(Large${extra}::made());\nvoid Single::of(\n\
    Large${extra}::Part part)\n{\n}\n} // namespace touchdown\n")
endforeach()

# Foreign text that Qt would take for HTML, and what is allowed.
write(ui/film/tips.cpp 6 "a->setToolTip(name);\nb->setTabToolTip(0, \n tr(\"Notes; of %1\").arg(x));\n\
if (role == Qt::ToolTipRole) return name;\nc->setItemData(0, name, Qt::ToolTipRole);\n\
QToolTip::showText(at, words());\n")
write(ui/film/fine_tips.cpp 6 "a->setToolTip(tr(\"One; \"\n \"text\"));\nb->setToolTip({});\n\
c->setToolTip(plainTip(x));\n\
if (role == Qt::ToolTipRole) return htmlTip(row);\nemit dataChanged(i, i, {Qt::ToolTipRole});\n")
write(ui/film/document.cpp 1 "QTextDocument text;\n")
write(ui/film/browser.cpp 1 "auto* text = new QTextBrowser(this);\n")
write(ui/film/help.cpp 1 "button->setWhatsThis(name);\n")
write(ui/film/fine_document.cpp 2 "OwnDocument text;\nQTextDocument* document();\n")

# A further kind of study needs no line in the list of rooms, but no other study may include it.
write(core/studies/new/new.h 1 "#include \"core/studies/sweep/fine_sweep.h\"\n")
write(core/studies/sweep/fine_sweep.h 1 "")
write(core/studies/sweep/sweep.cpp 1 "#include \"core/studies/new/new.h\"\n")
write(core/studies/fine_plan.cpp 1 "#include \"core/studies/new/new.h\"\n")

# The parameters of one contact law.
write(ui/film/law.cpp 1 "const double height = run->value.onoYamane.takeOff;\n")
write(core/case/fine_law.cpp 1 "const double height = c.onoYamane.takeOff;\n")
write(ui/film/fine_law.cpp 1 "const auto law = characteristic(c); // not case.h's member\n")

foreach(number RANGE 1 51)
    write(app/terminal/file${number}.h 1 "")
endforeach()

execute_process(COMMAND ${CMAKE_COMMAND} -D SOURCE_DIR=${FOLDER} -D PROGRAM=${CMAKE_COMMAND}
    -P ${SOURCE_DIR}/tests/check_layers.cmake OUTPUT_VARIABLE text ERROR_VARIABLE text RESULT_VARIABLE status)

set(problems "")
if(status EQUAL 0)
    list(APPEND problems "check_layers passes")
endif()
foreach(expected
        "core/numerics/low.h includes core/case/case.h of a higher room"
        "core/numerics/path.h includes ../case/case.h: write"
        "core/numerics/path.h includes near.h: write"
        "core/numerics/window.h includes QWidget: the core has no Qt"
        "core/elsewhere/lost.h: its folder has no place"
        "core/case/a->core/case/b is part of a circle"
        "core/case/b->core/case/c is part of a circle"
        "core/case/c->core/case/a is part of a circle"
        "core/results/stored_values->core/results/steady_reader is no longer there"
        "core/formats/twin.h: the type Twin has its name from core/case/twin.h too"
        "core/results/longer.cpp: 401 lines"
        "core/results/longest.cpp: 440 lines"
        "core/results/too_long.cpp: has 441 lines, at most 440 are allowed"
        "class Large1: has 901 lines in 3 files, at most 900 are allowed"
        "ui/window: no source was found"
        "ui/film/tips.cpp: the tool tip setToolTip(name)"
        "ui/film/tips.cpp: the tool tip setTabToolTip(0, tr"
        "ui/film/tips.cpp: the tool tip  if (role == Qt::ToolTipRole) return name"
        "ui/film/tips.cpp: the tool tip  c->setItemData"
        "ui/film/tips.cpp: the tool tip QToolTip::showText(at, words())"
        "ui/film/document.cpp: a document of HTML"
        "ui/film/browser.cpp: a document of HTML"
        "ui/film/help.cpp: uses setWhatsThis"
        "core/studies/sweep/sweep.cpp includes core/studies/new/new.h of a higher room"
        "ui/film/law.cpp: reads the parameters of one contact law"
        "app/terminal: holds 51 files, at most 50 are allowed")
    string(FIND "${text}" "${expected}" place)
    if(place EQUAL -1)
        list(APPEND problems "not found: ${expected}")
    endif()
endforeach()
foreach(allowed "core/case/leads_in" "core/case/leads_out" "type Single" "planned.cpp" "longer.cpp: has"
        "longest.cpp: has" "class Large0" "fine_tips" "fine_document" "fine_law" "fine_sweep" "fine_plan")
    string(FIND "${text}" "${allowed}" place)
    if(NOT place EQUAL -1)
        list(APPEND problems "reported: ${allowed}")
    endif()
endforeach()

if(problems)
    list(JOIN problems "\n  " problems)
    message(FATAL_ERROR "check_layers:\n  ${problems}\nIt reports:\n${text}")
endif()
file(REMOVE_RECURSE ${FOLDER})
