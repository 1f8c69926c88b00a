// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/command_line.h"
#include "app/cli/console.h"
#include "app/gui_main.h"

#include "core/base/message.h"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {
namespace {

/// A word that is no file is most likely a misspelt subcommand.
int refuseMissing(const std::string &word)
{
    const std::string verb = similarVerb(word);
    if (!verb.empty())
        return report({ErrorKind::Usage,
            {DYNCAL_TEXT(
                 "core", "%1 is neither a subcommand nor a file; the nearest subcommand is %2."),
                {word, verb}},
            {}, 0});
    return report({ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core", "The file %1 does not exist."), {word}}, {}, 0});
}

int openWorkbench(int argc, char **argv)
{
    const std::vector<std::string> files(argv + 1, argv + argc);
    for (const std::string &file : files) {
        std::error_code ignored;
        if (!std::filesystem::exists(file, ignored))
            return refuseMissing(file);
    }
    if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY")
        && !std::getenv("QT_QPA_PLATFORM"))
        return report({ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The workbench needs a display and there is none; the subcommands work without, "
                 "see dyncal --help."),
                {}},
            {}, 0});
    return runGui(argc, argv, files);
}

} // namespace
} // namespace dyncal

int main(int argc, char **argv)
{
    if ((argc == 3 || argc == 4) && std::string_view(argv[1]) == "--screenshot-tour")
        return dyncal::runGui(argc, argv, {});
    return dyncal::isCommandLine(argc, argv) ? dyncal::runCommandLine(argc, argv)
                                             : dyncal::openWorkbench(argc, argv);
}
