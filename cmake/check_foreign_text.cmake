# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Checks that text of files, recipes and arguments reaches people through its outlets only:
# cmake -DROOT=... -P check_foreign_text.cmake
# Text is no HTML (ui/text/plain_text_rule.h); what is shown is made by shownText() or translated(),
# what is edited by rawText() (ui/text/shown_text.h); JSON is written by jsonText(), the terminal by
# the streams that app/cli/terminal_text.h guards.
set(errors "")

# Complains of every file of `files` that holds the pattern and is not among those named behind `why`.
function(complain pattern why)
    foreach(file IN LISTS files)
        list(FIND ARGN "${file}" allowed)
        file(READ "${ROOT}/${file}" text)
        if(allowed LESS 0 AND text MATCHES "${pattern}")
            list(APPEND errors "${file}: ${CMAKE_MATCH_0}: ${why}")
        endif()
    endforeach()
    set(errors "${errors}" PARENT_SCOPE)
endfunction()

function(glob result)
    set(patterns "")
    foreach(folder IN LISTS ARGN)
        list(APPEND patterns "${ROOT}/${folder}/*.h" "${ROOT}/${folder}/*.cpp")
    endforeach()
    file(GLOB_RECURSE found RELATIVE "${ROOT}" ${patterns})
    set(${result} "${found}" PARENT_SCOPE)
endfunction()

glob(files ui app)
complain("Qt::RichText|\"[^\"\n]*<(b|i|u|s|p|br|h[1-6]|a|img|table|tr|td|span|font|html)[ />'\\\"]"
    "rich text belongs to the help, which shows no data" ui/shell/help_dialogs.cpp
    ui/text/plain_text_rule.h)
complain("Qt::AutoText|Qt::mightBeRichText" "text is not guessed to be HTML"
    ui/text/plain_text_rule.cpp)
complain("setHtml|insertHtml|appendHtml|setMarkdown|Qt::MarkdownText|QTextDocument|QTextEdit|QTextBrowser|QGraphicsTextItem|QStaticText|QWebEngine|setWhatsThis|QWhatsThis"
    "it would read text as HTML")
# Of buttons and lists, which never read HTML.
complain("heightForWidth" "it would have a label lay its text out before the rule is there"
    ui/stages/frame/wrapped_controls.cpp ui/stages/frame/wrapped_controls.h)
complain("shownText\\([^;{}\\\"]*\\)\\)[ \n]*\\.arg\\("
    "a %1 in foreign text would be filled in by the next arg(); give both to one")

glob(files ui/stages ui/shell ui/plot ui/report)
complain("fromStdString" "shownText() for what is shown, rawText() for what is edited")
complain("(setToolTip|setWindowTitle|setTitle|showText|addTab|setPlaceholderText|setHeaderLabels|setStatusTip|QLabel|QListWidgetItem|QTableWidgetItem)\\([^;]*rawText\\("
    "what is shown goes through shownText()")

glob(files app core)
complain("std::(printf|fprintf|puts|fputs|perror|clog)|STDOUT_FILENO"
    "answers go through std::cout and std::cerr" app/cli/console.cpp
    app/cli/terminal_text.cpp)
complain("\\.dump\\(" "JSON is written by jsonText()" core/base/json_text.cpp
    core/project/json_codec.cpp core/project/json_codec.h core/shock/shock_velocity.cpp)

if(errors)
    list(JOIN errors "\n" text)
    message(FATAL_ERROR "Foreign text goes past its outlets:\n${text}")
endif()
message(STATUS "Foreign text goes through its outlets")
