// Memory between two pages that trap.
#ifndef PITBENCH_TESTS_GUARDED_MEMORY_H_
#define PITBENCH_TESTS_GUARDED_MEMORY_H_

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>
#include <new>

namespace pitbench {

// At least `bytes` of writable memory; reading or writing the bytes right
// before or right behind it ends the program.
class GuardedMemory {
 public:
  explicit GuardedMemory(std::size_t bytes)
      : page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))),
        usable_((bytes / page_ + 1) * page_),
        mapping_(static_cast<std::byte*>(
            mmap(nullptr, usable_ + 2 * page_, PROT_NONE,
                 MAP_PRIVATE | MAP_ANONYMOUS, -1, 0))) {
    if (mapping_ == MAP_FAILED ||
        mprotect(mapping_ + page_, usable_, PROT_READ | PROT_WRITE) != 0) {
      throw std::bad_alloc();
    }
  }
  ~GuardedMemory() { munmap(mapping_, usable_ + 2 * page_); }
  GuardedMemory(const GuardedMemory&) = delete;
  GuardedMemory& operator=(const GuardedMemory&) = delete;

  // Room for n elements that ends where the memory does.
  template <class T>
  T* AtEnd(std::size_t n) const {
    return reinterpret_cast<T*>(mapping_ + page_ + usable_ - n * sizeof(T));
  }
  // Room that begins where the memory does.
  template <class T>
  T* AtStart() const {
    return reinterpret_cast<T*>(mapping_ + page_);
  }
  void Fill(int byte) const { std::memset(mapping_ + page_, byte, usable_); }

 private:
  std::size_t page_;
  std::size_t usable_;
  std::byte* mapping_;
};

}  // namespace pitbench

#endif  // PITBENCH_TESTS_GUARDED_MEMORY_H_
