#include "gr2to/base/ZeroedMemory.h"

#include <sys/mman.h>

#include <cstdlib>
#include <memory>
#include <new>

namespace gr2to
{
namespace
{
constexpr std::size_t kLargePage = std::size_t{2} << 20;  // of x86-64, and of others with small pages of 4 kB
}

void wishLargePages(void* from, std::size_t bytes)
{
#ifdef MADV_HUGEPAGE
    void* first = from;
    std::size_t space = bytes;
    if (std::align(kLargePage, kLargePage, first, space) != nullptr)
        ::madvise(first, space, MADV_HUGEPAGE);  // without large pages all works the same
#else
    static_cast<void>(from);
    static_cast<void>(bytes);
#endif
}

ZeroedMemory::ZeroedMemory(std::size_t bytes)
{
    if (bytes < 2 * kLargePage) {  // a few pages more or less do not matter, and the heap has used ones
        m_data = std::calloc(bytes, 1);
        if (m_data == nullptr && bytes > 0) throw std::bad_alloc();
        return;
    }
    m_mapped = bytes + kLargePage;  // room to start at a large page
    m_mapping = ::mmap(nullptr, m_mapped, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (m_mapping == MAP_FAILED) throw std::bad_alloc();
    std::size_t space = m_mapped;
    m_data = m_mapping;
    std::align(kLargePage, bytes, m_data, space);
    wishLargePages(m_data, bytes);
}

ZeroedMemory::~ZeroedMemory()
{
    if (m_mapping == nullptr)
        std::free(m_data);
    else
        ::munmap(m_mapping, m_mapped);
}
}  // namespace gr2to
