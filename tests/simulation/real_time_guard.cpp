#include "tests/simulation/real_time_guard.h"

#include <atomic>
#include <cerrno>
#include <limits>

#include <dlfcn.h>
#include <pthread.h>

#if defined(BODKIN_ADDRESS_SANITIZER) || defined(BODKIN_THREAD_SANITIZER)
#define BODKIN_HOOKS 0
#else
#define BODKIN_HOOKS 1
#endif

namespace bodkin {

namespace {
thread_local bool armed = false;
thread_local std::size_t heap = 0;
thread_local std::size_t locks = 0;
std::atomic<std::size_t> too_large{std::numeric_limits<std::size_t>::max()};  // bytes
}  // namespace

ScarceMemory::ScarceMemory(std::size_t largest) noexcept {
  too_large.store(largest);
}
ScarceMemory::~ScarceMemory() {
  too_large.store(std::numeric_limits<std::size_t>::max());
}

RealTimeGuard::RealTimeGuard() noexcept {
  heap = locks = 0;
  armed = true;
}
RealTimeGuard::~RealTimeGuard() {
  armed = false;
}
std::size_t RealTimeGuard::heap_calls() noexcept {
  return heap;
}
std::size_t RealTimeGuard::lock_calls() noexcept {
  return locks;
}
bool RealTimeGuard::available() noexcept {
  return BODKIN_HOOKS != 0;
}

namespace {
#if BODKIN_HOOKS
void count_heap() noexcept {
  heap += armed ? 1 : 0;
}
bool is_refused(std::size_t size) noexcept {
  return size >= too_large.load(std::memory_order_relaxed);
}
void count_lock() noexcept {
  locks += armed ? 1 : 0;
}

// The definition that this program's own one hides.
template <typename Function>
Function next_function(const char* name) noexcept {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}
#endif
}  // namespace

}  // namespace bodkin

#if BODKIN_HOOKS
// What glibc itself calls behind the names that are replaced here.
extern "C" {
void* __libc_malloc(std::size_t size) noexcept;
void* __libc_calloc(std::size_t count, std::size_t size) noexcept;
void* __libc_realloc(void* block, std::size_t size) noexcept;
void* __libc_memalign(std::size_t alignment, std::size_t size) noexcept;
void __libc_free(void* block) noexcept;

void* malloc(std::size_t size) noexcept {
  bodkin::count_heap();
  return bodkin::is_refused(size) ? nullptr : __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  bodkin::count_heap();
  return bodkin::is_refused(count * size) ? nullptr : __libc_calloc(count, size);
}
void* realloc(void* block, std::size_t size) noexcept {
  bodkin::count_heap();
  return bodkin::is_refused(size) ? nullptr : __libc_realloc(block, size);
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
  bodkin::count_heap();
  return bodkin::is_refused(size) ? nullptr : __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  bodkin::count_heap();
  return bodkin::is_refused(size) ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
  bodkin::count_heap();
  *block = bodkin::is_refused(size) ? nullptr : __libc_memalign(alignment, size);
  return *block == nullptr ? ENOMEM : 0;
}
void free(void* block) noexcept {
  if (block != nullptr) bodkin::count_heap();
  __libc_free(block);
}
int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  bodkin::count_lock();
  static const auto next = bodkin::next_function<int (*)(pthread_mutex_t*)>("pthread_mutex_lock");
  return next(mutex);
}
int pthread_mutex_trylock(pthread_mutex_t* mutex) noexcept {
  bodkin::count_lock();
  static const auto next = bodkin::next_function<int (*)(pthread_mutex_t*)>("pthread_mutex_trylock");
  return next(mutex);
}
int pthread_rwlock_rdlock(pthread_rwlock_t* lock) noexcept {
  bodkin::count_lock();
  static const auto next = bodkin::next_function<int (*)(pthread_rwlock_t*)>("pthread_rwlock_rdlock");
  return next(lock);
}
int pthread_rwlock_wrlock(pthread_rwlock_t* lock) noexcept {
  bodkin::count_lock();
  static const auto next = bodkin::next_function<int (*)(pthread_rwlock_t*)>("pthread_rwlock_wrlock");
  return next(lock);
}
}
#endif
