// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/write_problem.h"

#include <cerrno>
#include <cstring>

namespace dyncal {
namespace {

bool isPlace(int errorNumber)
{
    switch (errorNumber) {
    case EACCES:
    case ENOENT:
    case ENOTDIR:
    case EISDIR:
    case EROFS:
    case EPERM:
    case ENAMETOOLONG:
    case ELOOP:
    case EINVAL: // a name that the file system refuses
    case EILSEQ:
        return true;
    default:
        return false;
    }
}

const char *sentence(int errorNumber)
{
    switch (errorNumber) {
    case ENOSPC:
    case EDQUOT:
        return DYNCAL_TEXT("core", "%1 cannot be written: %2; make room and try again.");
    case EFBIG:
        return DYNCAL_TEXT("core",
            "%1 cannot be written: %2; raise the limit on the size of files or choose another place.");
    case EMFILE:
    case ENFILE:
        return DYNCAL_TEXT("core",
            "%1 cannot be written: %2; close other programs or raise the limit on open files (ulimit -n).");
    case ENAMETOOLONG:
        return DYNCAL_TEXT("core", "%1 cannot be written: %2; choose a shorter name.");
    case ENOENT:
    case ENOTDIR:
        return DYNCAL_TEXT("core", "%1 cannot be written: %2; check that its folder exists.");
    default:
        return DYNCAL_TEXT("core", "%1 cannot be written: %2; choose another place.");
    }
}

} // namespace

tl::unexpected<Error> cannotWrite(const std::string &path, int errorNumber)
{
    return fail(isPlace(errorNumber) ? ErrorKind::Usage : ErrorKind::Internal,
        {sentence(errorNumber), {path, std::strerror(errorNumber)}});
}

tl::unexpected<Error> cannotWrite(const std::string &path)
{
    return cannotWrite(path, errno);
}

tl::unexpected<Error> existsAlready(const std::string &path)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core", "%1 exists already and is not replaced; choose another name."),
            {path}});
}

tl::unexpected<Error> wasMoved(const std::string &path)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "%1 was renamed, moved or replaced while it was being written, so nothing was written into it; write again into the folder that you mean."),
            {path}});
}

tl::unexpected<Error> isBeingWritten(const std::string &path)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "%1 is being written by another program at this moment; wait until it has ended or choose another name."),
            {path}});
}

} // namespace dyncal
