// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace planum {

/// Memory for arrays of many megabytes that are written or read out of order: asks the system for pages of 2 MB, so
/// that it has to hand out, and the processor to look up, five hundred times fewer. Without such pages it is memory as
/// any other.
template<class T>
struct LargePages {
    using value_type = T;

    LargePages() = default;

    template<class U>
    LargePages(const LargePages<U>& /*other*/) noexcept {} // NOLINT(google-explicit-constructor): allocators convert

    [[nodiscard]] T* allocate(std::size_t count) {
        if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_alloc();
        const std::size_t bytes = count * sizeof(T);
        if (bytes < kFrom) return static_cast<T*>(::operator new(bytes));
        const std::size_t whole = (bytes + kPage - 1) / kPage * kPage;
        void* const memory = std::aligned_alloc(kPage, whole);
        if (memory == nullptr) throw std::bad_alloc();
#if defined(__linux__)
        static_cast<void>(::madvise(memory, whole, MADV_HUGEPAGE)); // only a wish
#endif
        return static_cast<T*>(memory);
    }

    void deallocate(T* memory, std::size_t count) noexcept {
        if (count * sizeof(T) < kFrom) {
            ::operator delete(memory);
        } else {
            std::free(memory); // NOLINT(cppcoreguidelines-no-malloc): from aligned_alloc
        }
    }

    friend bool operator==(const LargePages& /*a*/, const LargePages& /*b*/) noexcept { return true; }

  private:
    static constexpr std::size_t kPage = std::size_t{2} << 20U;
    static constexpr std::size_t kFrom = 2 * kPage; ///< smaller ones waste more than they win
};

template<class T>
using LargeVector = std::vector<T, LargePages<T>>;

} // namespace planum
