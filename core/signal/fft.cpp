// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/fft.h"

#include <fftw3.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <mutex>
#include <new>
#include <string_view>

/// FFTW calls this function of its own where it gets no memory, and then ends the program. Defined
/// here it is found first, and the lack is told like any other. The exception passes FFTW's frames,
/// which have unwind tables on every Debian port (tst_fft).
extern "C" [[noreturn]] void fftw_assertion_failed(const char *, int, const char *file)
{
    if (std::string_view(file).ends_with("alloc.c"))
        throw std::bad_alloc();
    std::abort(); // as FFTW itself
}

namespace dyncal {
namespace {

/// FFTW's planner has global state; only execution is thread-safe.
std::mutex &plannerMutex()
{
    static std::mutex mutex;
    return mutex;
}

/// Asks for what a plan needs, to have it thrown here, before the planner begins: an interrupted
/// one is not used again.
void requireMemory(Index length)
{
    constexpr std::size_t kTables = 2UL << 20; // of the planner
    const std::size_t bytes = kTables + 24UL * static_cast<std::size_t>(length);
    ::operator delete(::operator new(bytes)); // called by name: such a pair is never optimised away
}

/// Both plans of a length, all or none. `plan` runs under the mutex.
template <typename Plan>
void runPlanner(Index length, const Plan &plan)
{
    static bool isInterrupted = false;
    const std::lock_guard lock(plannerMutex());
    if (isInterrupted)
        throw std::bad_alloc();
    requireMemory(length);
    isInterrupted = true;
    plan();
    isInterrupted = false;
}

fftw_complex *fftwData(std::complex<double> *data)
{
    return reinterpret_cast<fftw_complex *>(data); // layout guaranteed by FFTW and by C++
}

/// Plans are made for aligned buffers (for unaligned ones FFTW would not use SIMD), so a buffer of
/// unknown alignment must be checked before a plan runs on it.
bool isAligned(const double *data)
{
    return fftw_alignment_of(const_cast<double *>(data)) == 0; // FFTW does not write through it
}

} // namespace

struct RealFft::Plans
{
    Index length = 0;
    fftw_plan forward = nullptr;
    fftw_plan inverse = nullptr;

    explicit Plans(Index n)
        : length(n)
    {
        eigen_assert(n >= 1 && n <= std::numeric_limits<int>::max());
        Eigen::VectorXd time(n); // ESTIMATE looks at their alignment only
        Eigen::VectorXcd spectrum(n / 2 + 1);
        const int size = static_cast<int>(n);
        runPlanner(n, [&] {
            forward = fftw_plan_dft_r2c_1d(
                size, time.data(), fftwData(spectrum.data()), FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
            inverse = fftw_plan_dft_c2r_1d(
                size, fftwData(spectrum.data()), time.data(), FFTW_ESTIMATE | FFTW_DESTROY_INPUT);
        });
        if (forward == nullptr || inverse == nullptr) {
            destroy();
            throw std::bad_alloc(); // the only way in which an ESTIMATE plan can fail
        }
    }
    ~Plans()
    {
        const std::lock_guard lock(plannerMutex());
        destroy();
    }
    Plans(const Plans &) = delete;
    Plans &operator=(const Plans &) = delete;

private:
    void destroy()
    {
        fftw_destroy_plan(forward); // accepts null
        fftw_destroy_plan(inverse);
    }
};

RealFft::RealFft(Index length)
    : m_plans(std::make_unique<Plans>(length))
{
}

RealFft::~RealFft() = default;
RealFft::RealFft(RealFft &&) noexcept = default;
RealFft &RealFft::operator=(RealFft &&) noexcept = default;

Index RealFft::length() const
{
    return m_plans->length;
}

Eigen::VectorXcd RealFft::forward(const Eigen::Ref<const Eigen::VectorXd> &time) const
{
    eigen_assert(time.size() <= length());
    Eigen::VectorXcd spectrum(length() / 2 + 1);
    if (time.size() == length() && isAligned(time.data())) {
        fftw_execute_dft_r2c(
            m_plans->forward, const_cast<double *>(time.data()), fftwData(spectrum.data()));
        return spectrum;
    }
    Eigen::VectorXd padded(length());
    padded << time, Eigen::VectorXd::Zero(length() - time.size());
    fftw_execute_dft_r2c(m_plans->forward, padded.data(), fftwData(spectrum.data()));
    return spectrum;
}

Eigen::VectorXd RealFft::inverse(const Eigen::Ref<const Eigen::VectorXcd> &spectrum) const
{
    eigen_assert(spectrum.size() == length() / 2 + 1);
    Eigen::VectorXcd scratch = spectrum / static_cast<double>(length()); // FFTW overwrites it
    Eigen::VectorXd time(length());
    fftw_execute_dft_c2r(m_plans->inverse, fftwData(scratch.data()), time.data());
    return time;
}

void RealFft::forward(const Eigen::VectorXd &time, Eigen::VectorXcd &spectrum) const
{
    eigen_assert(time.size() == length() && spectrum.size() == length() / 2 + 1);
    fftw_execute_dft_r2c(
        m_plans->forward, const_cast<double *>(time.data()), fftwData(spectrum.data()));
}

void RealFft::inverseUnscaled(Eigen::VectorXcd &spectrum, Eigen::VectorXd &time) const
{
    eigen_assert(time.size() == length() && spectrum.size() == length() / 2 + 1);
    fftw_execute_dft_c2r(m_plans->inverse, fftwData(spectrum.data()), time.data());
}

Index fastFftLength(Index n)
{
    Index best = 1;
    while (best < n)
        best *= 2;
    for (Index fives = 1; fives < best; fives *= 5) {
        for (Index odd = fives; odd < best; odd *= 3) {
            Index length = odd;
            while (length < n)
                length *= 2;
            best = std::min(best, length);
        }
    }
    return best;
}

} // namespace dyncal
