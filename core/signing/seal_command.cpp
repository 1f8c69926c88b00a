// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/seal_command.h"

#include "core/base/file_descriptor.h"
#include "core/signing/cms_signature.h"

#include <csignal>
#include <optional>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

namespace dyncal {
namespace {

constexpr int kInput = 0, kOutput = 1; ///< of every program

/// A command that runs; it is ended and awaited with this.
class RunningCommand
{
public:
    RunningCommand(pid_t process, FileDescriptor output)
        : m_process(process)
        , m_output(std::move(output))
    {
    }
    RunningCommand(const RunningCommand &) = delete;
    RunningCommand &operator=(const RunningCommand &) = delete;
    ~RunningCommand()
    {
        if (m_process > 0) {
            ::kill(m_process, SIGKILL);
            wait(0);
        }
    }

    int output() const { return m_output.get(); }

    /// Its end within the time; 0 is success.
    Awaited end(const AnswerClock &clock, int &status)
    {
        while (m_process > 0) {
            if (const Awaited now = clock.standing(); now != Awaited::Whole)
                return now;
            status = wait(WNOHANG);
            if (m_process > 0)
                ::usleep(1000);
        }
        return Awaited::Whole;
    }

private:
    int wait(int options)
    {
        int status = 0;
        if (::waitpid(m_process, &status, options) != 0)
            m_process = -1;
        return status;
    }

    pid_t m_process;
    FileDescriptor m_output;
};

/// A descriptor from which these bytes can be read.
FileDescriptor memoryWith(const std::string &bytes)
{
    FileDescriptor memory(::memfd_create("hash", MFD_CLOEXEC));
    if (!memory.valid()
        || ::write(memory.get(), bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())
        || ::lseek(memory.get(), 0, SEEK_SET) != 0)
        return FileDescriptor();
    return memory;
}

/// Spawns with standard input and output, and no signal blocked or ignored as they are here.
bool spawn(const std::vector<std::string> &words, int input, int output, pid_t &process)
{
    std::vector<char *> arguments;
    for (const std::string &word : words)
        arguments.push_back(const_cast<char *>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawnattr_t how;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawnattr_init(&how);
    ::posix_spawn_file_actions_adddup2(&files, input, kInput);
    ::posix_spawn_file_actions_adddup2(&files, output, kOutput);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    ::posix_spawnattr_setsigmask(&how, &none);
    ::posix_spawnattr_setsigdefault(&how, &all);
    ::posix_spawnattr_setflags(&how, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    const int failed
        = ::posix_spawnp(&process, arguments.front(), &files, &how, arguments.data(), environ);
    ::posix_spawnattr_destroy(&how);
    ::posix_spawn_file_actions_destroy(&files);
    return failed == 0;
}

/// The command with the hash on its standard input; empty where the system cannot start it.
std::unique_ptr<RunningCommand> start(
    const std::vector<std::string> &words, const std::string &sha256)
{
    int ends[2];
    const FileDescriptor input = memoryWith(sha256 + '\n');
    if (!input.valid() || ::pipe2(ends, O_CLOEXEC) != 0)
        return {};
    FileDescriptor output(ends[0]);
    const FileDescriptor theirs(ends[1]);
    pid_t process = -1;
    if (!spawn(words, input.get(), theirs.get(), process))
        return {};
    return std::make_unique<RunningCommand>(process, std::move(output));
}

tl::unexpected<Error> didNot(const std::string &program, const AnswerLimits &limits, Awaited end)
{
    if (end == Awaited::Stopped)
        return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Stopped on request."), {}});
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "The seal command %1 did not give a signature: it must be startable, end with exit code 0 within %2 s and write at most %3 bytes; try it by itself."),
            {program, std::to_string(limits.time.count() / 1000), std::to_string(limits.bytes)}});
}

/// Words of a command, letter by letter.
class CommandWords
{
public:
    void take(char c)
    {
        if (m_quote != 0 && c == m_quote) {
            m_quote = 0;
        } else if (m_quote == 0 && (c == '\'' || c == '"')) {
            m_quote = c;
            m_isOpen = true; // "" is a word too
        } else if (m_quote == 0 && (c == ' ' || c == '\t')) {
            close();
        } else {
            m_word += c;
            m_isOpen = true;
        }
    }
    void close()
    {
        if (m_isOpen)
            words.push_back(std::move(m_word));
        m_word.clear();
        m_isOpen = false;
    }
    bool isQuoteOpen() const { return m_quote != 0; }

    std::vector<std::string> words;

private:
    std::string m_word;
    char m_quote = 0;
    bool m_isOpen = false;
};

} // namespace

Result<std::vector<std::string>> wordsOfCommand(const std::string &command)
{
    CommandWords taken;
    for (const char c : command)
        taken.take(c);
    taken.close();
    const bool isFit = !taken.isQuoteOpen() && !taken.words.empty() && !taken.words.front().empty()
        && command.find('\0') == std::string::npos;
    if (isFit)
        return std::move(taken.words);
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "“%1” is no command to seal with: it needs a program, and quotes that are closed."),
            {command}});
}

Result<std::string> sealedBy(const std::string &command, const std::string &sha256,
    const std::stop_token &stop, const AnswerLimits &limits)
{
    const Result<std::vector<std::string>> words = wordsOfCommand(command);
    if (!words)
        return tl::unexpected<Error>(words.error());
    const AnswerClock clock(limits, stop);
    const std::unique_ptr<RunningCommand> running = start(*words, sha256);
    if (!running)
        return didNot(words->front(), limits, Awaited::Broken);
    std::string cms;
    int status = -1;
    Awaited end = readToEnd(running->output(), limits, clock, cms);
    if (end == Awaited::Whole)
        end = running->end(clock, status);
    if (end != Awaited::Whole || status != 0 || cms.empty())
        return didNot(words->front(), limits, end);
    if (const std::optional<Message> fault = faultOfCms(cms, sha256)) {
        Message message{
            DYNCAL_TEXT("core",
                "The seal command %1 answered, but not with a signature over the hash that it was given; see its contract in docs/signatures.md."),
            {words->front()}};
        message.below.push_back(*fault);
        return fail(ErrorKind::DataBlocked, std::move(message));
    }
    return cms;
}

} // namespace dyncal
