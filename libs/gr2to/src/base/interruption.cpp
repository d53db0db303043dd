#include "gr2to/base/interruption.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <string>
#include <utility>

namespace gr2to
{
namespace
{
enum class SlotState : int
{
    Empty,
    Filling,
    Set
};

/** A path where a signal's handler may read it: fixed memory, and a flag that needs no lock. */
struct Slot
{
    std::atomic<SlotState> state{SlotState::Empty};
    std::array<char, 4096> path{};
};

std::array<Slot, 64> slots;
static_assert(std::atomic<SlotState>::is_always_lock_free, "a signal's handler must not wait for a lock");

/** Calls nothing but what a handler may call: unlink, rmdir, signal, raise. */
extern "C" void removeAllAndDie(int signal)
{
    for (auto slot = slots.rbegin(); slot != slots.rend(); ++slot)  // files before the folders made for them
        if (slot->state == SlotState::Set && ::unlink(slot->path.data()) != 0) ::rmdir(slot->path.data());
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}
}  // namespace

void removeUnfinishedOutputOnSignals()
{
    for (const int signal : {SIGHUP, SIGINT, SIGTERM})
        if (std::signal(signal, removeAllAndDie) == SIG_IGN) std::signal(signal, SIG_IGN);
}

UnfinishedOutput::UnfinishedOutput(const std::filesystem::path& path) : m_slot(-1)
{
    const std::string& name = path.native();
    for (std::size_t i = 0; i < slots.size() && name.size() < slots[i].path.size(); ++i) {
        SlotState expected = SlotState::Empty;
        if (!slots[i].state.compare_exchange_strong(expected, SlotState::Filling)) continue;
        slots[i].path[name.copy(slots[i].path.data(), name.size())] = '\0';
        slots[i].state = SlotState::Set;
        m_slot = static_cast<int>(i);
        return;
    }
}

UnfinishedOutput::UnfinishedOutput(UnfinishedOutput&& other) noexcept
    : m_slot(std::exchange(other.m_slot, -1))
{
}

UnfinishedOutput& UnfinishedOutput::operator=(UnfinishedOutput&& other) noexcept
{
    std::swap(m_slot, other.m_slot);
    return *this;
}

UnfinishedOutput::~UnfinishedOutput()
{
    if (m_slot >= 0) slots[static_cast<std::size_t>(m_slot)].state = SlotState::Empty;
}
}  // namespace gr2to
