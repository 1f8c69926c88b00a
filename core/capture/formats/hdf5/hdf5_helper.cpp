// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_helper.h"

#include "core/capture/formats/hdf5/hdf5_handle.h"
#include "core/capture/formats/hdf5/hdf5_warm_up.h"

#include <mutex>

namespace dyncal {

Result<void> runHdf5Helper(const std::string &path,
    const std::function<void(GuardedOutput &)> &work,
    const std::function<bool(std::span<const std::byte>)> &receive, const GuardedLimits &limits,
    const JobControl &control)
{
    const std::scoped_lock lock(hdf5Mutex());
    silenceHdf5();
    warmHdf5Up();
    switch (runGuarded(work, receive, limits, control.stop)) {
    case GuardedOutcome::Finished:
        return {};
    case GuardedOutcome::Stopped:
        return fail(
            ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Reading %1 was cancelled."), {path}});
    case GuardedOutcome::NotStarted:
        return fail(ErrorKind::Internal,
            {DYNCAL_TEXT("core",
                 "%1 was not read because the system could not start a helper process; close other programs."),
                {path}});
    case GuardedOutcome::Killed:
        return fail(ErrorKind::Internal,
            {DYNCAL_TEXT("core",
                 "%1 was not read because the system or another program ended the helper process that reads it, most likely for want of memory; close other programs and try again."),
                {path}});
    case GuardedOutcome::Died:
        break;
    }
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1 is damaged so badly that the HDF5 library fails on it; take another copy."),
            {path}},
        "CAP-018");
}

} // namespace dyncal
