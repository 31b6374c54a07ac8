/// \file
/// C++ exceptions on WebAssembly's own. Debian builds libc++abi for WASI without them, so what the compiler calls
/// stands here: memory for what is thrown, the throw, which catch clause takes it (from the table that the compiler
/// lays down, in the form of the Itanium C++ ABI's exception handling tables), and the stack of what is being handled.
/// There is one thread.

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <typeinfo>

namespace __cxxabiv1 {

/// As libc++abi declares it: whether a clause for this type takes what was thrown, and at which address.
class __shim_type_info : public std::type_info {
public:
  virtual ~__shim_type_info();
  virtual void noop1() const;
  virtual void noop2() const;
  virtual bool can_catch(const __shim_type_info* thrown, void*& adjusted) const = 0;
};

} // namespace __cxxabiv1

namespace {

using Destructor = void* (*)(void*); ///< on WebAssembly they return the object

/// Stands before each thrown object.
struct alignas(16) Header {
  const std::type_info* type = nullptr;
  Destructor destroy = nullptr;
  int owners = 1;
  int handlers = 0;
  void* adjusted = nullptr; ///< the address of the part that the clause catches
  Header* outer = nullptr;  ///< caught before, and still being handled
};

Header* handled = nullptr;
int thrown_and_not_caught = 0;

Header* header(void* object) { return static_cast<Header*>(object) - 1; }
void* object(Header* one) { return one + 1; }

void release(Header* one) {
  if (--one->owners > 0) return;
  if (one->destroy != nullptr) one->destroy(object(one));
  std::free(one);
}

std::uintptr_t read_unsigned(const std::uint8_t*& at) {
  std::uintptr_t value = 0;
  for (unsigned shift = 0;; shift += 7) {
    const std::uint8_t byte = *at++;
    value |= static_cast<std::uintptr_t>(byte & 0x7FU) << shift;
    if ((byte & 0x80U) == 0) return value;
  }
}

std::intptr_t read_signed(const std::uint8_t*& at) {
  std::uintptr_t value = 0;
  for (unsigned shift = 0;;) {
    const std::uint8_t byte = *at++;
    value |= static_cast<std::uintptr_t>(byte & 0x7FU) << shift;
    shift += 7;
    if ((byte & 0x80U) != 0) continue;
    if ((byte & 0x40U) != 0 && shift < 32) value |= ~std::uintptr_t{0} << shift;
    return static_cast<std::intptr_t>(value);
  }
}

constexpr std::uint8_t omitted = 0xFF;

} // namespace

extern "C" {

/// What a landing pad tells of itself, and is told: the number of the clause's type, 0 for none.
struct Landing {
  std::uintptr_t pad;
  const std::uint8_t* table;
  std::uintptr_t selector;
};
Landing __wasm_lpad_context;

void* __cxa_allocate_exception(std::size_t size) noexcept {
  void* const memory = std::calloc(1, sizeof(Header) + size);
  if (memory == nullptr) std::abort();
  return object(new (memory) Header);
}

void __cxa_free_exception(void* thrown) noexcept { std::free(header(thrown)); }

[[noreturn]] void __cxa_throw(void* thrown, std::type_info* type, Destructor destroy) {
  header(thrown)->type = type;
  header(thrown)->destroy = destroy;
  ++thrown_and_not_caught;
  __builtin_wasm_throw(0, thrown);
}

int _Unwind_CallPersonality(void* thrown) {
  Landing& landing = __wasm_lpad_context;
  landing.selector = 0;
  const std::uint8_t* at = landing.table;
  if (*at++ != omitted) read_unsigned(at); // where landing pads start: means nothing here
  const std::uint8_t encoding = *at++;
  if (encoding == omitted) return 0;
  const std::uintptr_t to_types = read_unsigned(at);
  const std::uint8_t* const types = at + to_types;
  ++at; // encoding of the call sites: WebAssembly's are pairs of numbers
  const std::uintptr_t length = read_unsigned(at);
  const std::uint8_t* const actions = at + length;
  std::uintptr_t action = 0;
  for (std::uintptr_t k = 0; k <= landing.pad; ++k) {
    read_unsigned(at);
    action = read_unsigned(at);
  }
  if (action == 0) return 0;
  for (at = actions + (action - 1);;) {
    const std::intptr_t clause = read_signed(at);
    const std::uint8_t* const next = at;
    const std::intptr_t step = read_signed(at);
    if (clause > 0) {
      const __cxxabiv1::__shim_type_info* wanted = nullptr;
      std::memcpy(&wanted, types - static_cast<std::size_t>(clause) * sizeof wanted, sizeof wanted);
      void* adjusted = thrown;
      if (wanted == nullptr ||
          wanted->can_catch(static_cast<const __cxxabiv1::__shim_type_info*>(header(thrown)->type), adjusted)) {
        header(thrown)->adjusted = adjusted;
        landing.selector = static_cast<std::uintptr_t>(clause);
        return 0;
      }
    }
    if (step == 0) return 0;
    at = next + step;
  }
}

void* __cxa_get_exception_ptr(void* thrown) noexcept { return header(thrown)->adjusted; }

void* __cxa_begin_catch(void* thrown) noexcept {
  Header* const one = header(thrown);
  if (one->adjusted == nullptr) one->adjusted = thrown;
  one->handlers = one->handlers < 0 ? -one->handlers + 1 : one->handlers + 1;
  --thrown_and_not_caught;
  if (handled != one) {
    one->outer = handled;
    handled = one;
  }
  return one->adjusted;
}

void __cxa_end_catch() {
  Header* const one = handled;
  if (one == nullptr) return;
  if (one->handlers < 0) { // thrown again: who catches it next ends it
    if (++one->handlers == 0) handled = one->outer;
    return;
  }
  if (--one->handlers > 0) return;
  handled = one->outer;
  one->adjusted = nullptr;
  release(one);
}

[[noreturn]] void __cxa_rethrow() {
  if (handled == nullptr) std::abort();
  handled->handlers = -handled->handlers;
  ++thrown_and_not_caught;
  __builtin_wasm_throw(0, object(handled));
}

void __cxa_increment_exception_refcount(void* thrown) noexcept {
  if (thrown != nullptr) ++header(thrown)->owners;
}

void __cxa_decrement_exception_refcount(void* thrown) noexcept {
  if (thrown != nullptr) release(header(thrown));
}

void* __cxa_current_primary_exception() noexcept {
  if (handled == nullptr) return nullptr;
  ++handled->owners;
  return object(handled);
}

void __cxa_rethrow_primary_exception(void* thrown) {
  if (thrown == nullptr) return;
  ++header(thrown)->owners;
  ++thrown_and_not_caught;
  __builtin_wasm_throw(0, thrown);
}

bool __cxa_uncaught_exception() noexcept { return thrown_and_not_caught > 0; }
unsigned int __cxa_uncaught_exceptions() noexcept { return static_cast<unsigned>(thrown_and_not_caught); }

/// What is of the one thread lives as long as the page.
int __cxa_thread_atexit(Destructor, void*, void*) noexcept { return 0; }

} // extern "C"
