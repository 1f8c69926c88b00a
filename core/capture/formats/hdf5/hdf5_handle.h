// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#if __has_include(<hdf5.h>)
#include <hdf5.h>
#else // tests are built without the library's own folder
#include <hdf5/serial/hdf5.h>
#endif

#include <memory>
#include <mutex>
#include <utility>

namespace dyncal {

/// Owns one HDF5 identifier. The library reports a full disk only when an object is closed, so
/// writers call close() and check its result; the destructor is for the way out after a failure.
class Hdf5Handle
{
public:
    using CloseFunction = herr_t (*)(hid_t);

    Hdf5Handle() = default;
    Hdf5Handle(hid_t id, CloseFunction closeFunction)
        : m_id(id)
        , m_close(closeFunction)
    {
    }
    Hdf5Handle(Hdf5Handle &&other) noexcept
        : m_id(std::exchange(other.m_id, kNone))
        , m_close(other.m_close)
    {
    }
    Hdf5Handle &operator=(Hdf5Handle &&other) noexcept
    {
        std::swap(m_id, other.m_id);
        std::swap(m_close, other.m_close);
        return *this;
    }
    ~Hdf5Handle() { close(); }

    bool valid() const { return m_id >= 0; }
    hid_t id() const { return m_id; }

    /// Closes now; true if the library closed it without complaint. A second call is harmless.
    bool close()
    {
        const hid_t id = std::exchange(m_id, kNone);
        return id < 0 || m_close(id) >= 0;
    }

private:
    static constexpr hid_t kNone = -1;
    hid_t m_id = kNone;
    CloseFunction m_close = nullptr;
};

/// To be locked around every use of the library, which gains nothing from two threads (it has one
/// global lock). The process may be forked for a helper only while no other thread is inside.
inline std::mutex &hdf5Mutex()
{
    static std::mutex mutex;
    return mutex;
}

/// Keeps the library from printing its own error stack; we make sentences of our own. The setting
/// belongs to the calling thread, so every entry point switches it off for itself.
///
/// It also switches off the library's cleaning up at exit, which follows freed pointers if a file
/// could not be closed (a full disk). We close everything ourselves.
inline void silenceHdf5()
{
    // Where memory ends while it starts, the library follows a null pointer; std::bad_alloc
    // instead.
    [[maybe_unused]] static const bool hasRoom = [] {
        const auto room = std::make_unique<volatile char[]>(std::size_t{2} << 20U);
        return room[0] == 0; // a read, so that the room is not optimised away
    }();
    [[maybe_unused]] static const herr_t noExitHandler = H5dont_atexit(); // before any other call
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

} // namespace dyncal
