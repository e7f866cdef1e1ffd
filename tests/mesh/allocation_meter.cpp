#include "allocation_meter.hpp"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t kPrefix = 16;  // keeps the alignment, holds the size
std::size_t allocated = 0;
std::size_t most = 0;

void* allocate(std::size_t size) {
  auto* block = static_cast<char*>(std::malloc(size + kPrefix));
  if (block == nullptr) std::abort();
  *reinterpret_cast<std::size_t*>(block) = size;
  allocated += size;
  most = std::max(most, allocated);
  return block + kPrefix;
}

void release(void* pointer) {
  if (pointer == nullptr) return;
  char* block = static_cast<char*>(pointer) - kPrefix;
  allocated -= *reinterpret_cast<std::size_t*>(block);
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void operator delete(void* pointer) noexcept { release(pointer); }
void operator delete[](void* pointer) noexcept { release(pointer); }
void operator delete(void* pointer, std::size_t) noexcept { release(pointer); }
void operator delete[](void* pointer, std::size_t) noexcept { release(pointer); }

namespace weft {

AllocationMeter::AllocationMeter() : before_(allocated) { most = allocated; }
std::size_t AllocationMeter::peak() const { return most - std::min(most, before_); }

}  // namespace weft
