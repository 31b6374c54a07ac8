/// \file
/// Preloaded into brdfplot: makes one call fail, or that call and all after it, as a machine does that has no memory or
/// no disk left. It counts from the start of the program's own code, static initialisers included.
///
/// BRDFPLOT_FAULT=KIND:N[+][:HOW] is the fault: KIND is alloc, open, read, write, fsync, close, rename, mkdir or
/// thread, N counts from 1, `+` means all from then on, HOW is ENOSPC, EIO (default), EINTR or `short` (half is
/// written). BRDFPLOT_FAULT_COUNTS=FILE gets a line "KIND CALLS" each at the end.

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace {

enum Kind : unsigned {
  alloc,
  open_file,
  read_file,
  write_file,
  sync_file,
  close_file,
  rename_file,
  make_folder,
  thread
};
constexpr std::array<const char*, 9> names = {"alloc", "open",   "read",  "write", "fsync",
                                              "close", "rename", "mkdir", "thread"};

std::array<std::atomic<long>, names.size()> counts{};
std::atomic<bool> counting{false};
Kind faulty = alloc;
long first = 0; ///< 0: no fault
bool all_after = false;
bool is_short = false;
int error = EIO;

bool fails(Kind kind) {
  if (!counting.load(std::memory_order_relaxed)) return false;
  const long call = ++counts[kind];
  if (first == 0 || kind != faulty || (all_after ? call < first : call != first)) return false;
  errno = kind == alloc ? ENOMEM : error;
  return true;
}

void read_request() {
  const char* text = std::getenv("BRDFPLOT_FAULT");
  if (text == nullptr) return;
  for (unsigned kind = 0; kind < names.size(); ++kind) {
    const std::size_t length = std::strlen(names[kind]);
    if (std::strncmp(text, names[kind], length) != 0 || text[length] != ':') continue;
    faulty = static_cast<Kind>(kind);
    char* end = nullptr;
    first = std::strtol(text + length + 1, &end, 10);
    all_after = *end == '+';
    const char* how = std::strrchr(text, ':') + 1;
    is_short = std::strcmp(how, "short") == 0;
    error = std::strcmp(how, "ENOSPC") == 0 ? ENOSPC : std::strcmp(how, "EINTR") == 0 ? EINTR : EIO;
  }
}

void write_counts() {
  counting = false;
  const char* path = std::getenv("BRDFPLOT_FAULT_COUNTS");
  if (path == nullptr) return;
  std::array<char, 512> text{};
  int length = 0;
  for (std::size_t kind = 0; kind < names.size(); ++kind)
    length += std::snprintf(text.data() + length, text.size() - static_cast<std::size_t>(length), "%s %ld\n",
                            names[kind], counts[kind].load());
  const long fd = syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (fd >= 0) syscall(SYS_write, fd, text.data(), length);
}

int opened(int folder, const char* path, int flags, va_list more) {
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(more, mode_t) : 0;
  if (fails(open_file)) return -1;
  return static_cast<int>(syscall(SYS_openat, folder, path, flags, mode));
}

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

using Main = int (*)(int, char**, char**);

} // namespace

extern "C" {

int __libc_start_main(Main main, int argc, char** argv, void (*init)(), void (*fini)(), void (*rtld)(), void* stack) {
  using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
  const auto start = next<Start>("__libc_start_main");
  read_request();
  std::atexit(write_counts);
  counting = true;
  return start(main, argc, argv, init, fini, rtld, stack);
}

void* malloc(std::size_t size) { return fails(alloc) ? nullptr : __libc_malloc(size); }
void* calloc(std::size_t count, std::size_t size) { return fails(alloc) ? nullptr : __libc_calloc(count, size); }
void* realloc(void* old, std::size_t size) { return fails(alloc) ? nullptr : __libc_realloc(old, size); }
void* memalign(std::size_t to, std::size_t size) { return fails(alloc) ? nullptr : __libc_memalign(to, size); }
void* aligned_alloc(std::size_t to, std::size_t size) { return fails(alloc) ? nullptr : __libc_memalign(to, size); }
int posix_memalign(void** out, std::size_t to, std::size_t size) {
  if (fails(alloc)) return ENOMEM;
  *out = __libc_memalign(to, size);
  return *out == nullptr ? ENOMEM : 0;
}

int open(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const int fd = opened(AT_FDCWD, path, flags, more);
  va_end(more);
  return fd;
}
int open64(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const int fd = opened(AT_FDCWD, path, flags, more);
  va_end(more);
  return fd;
}
int openat(int folder, const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const int fd = opened(folder, path, flags, more);
  va_end(more);
  return fd;
}

ssize_t read(int fd, void* to, std::size_t size) { return fails(read_file) ? -1 : syscall(SYS_read, fd, to, size); }

/// stderr is spared: what is looked at is how a failure is told.
ssize_t write(int fd, const void* from, std::size_t size) {
  if (fd != STDERR_FILENO && fails(write_file)) {
    if (!is_short) return -1;
    size = (size + 1) / 2;
  }
  return syscall(SYS_write, fd, from, size);
}

int fsync(int fd) { return fails(sync_file) ? -1 : static_cast<int>(syscall(SYS_fsync, fd)); }

/// The descriptor is gone all the same, as Linux does it.
int close(int fd) {
  const bool failed = fails(close_file);
  const int wrong = errno;
  const long result = syscall(SYS_close, fd);
  if (!failed) return static_cast<int>(result);
  errno = wrong;
  return -1;
}

int rename(const char* from, const char* to) {
  return fails(rename_file) ? -1 : static_cast<int>(syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

int mkdir(const char* path, mode_t mode) {
  return fails(make_folder) ? -1 : static_cast<int>(syscall(SYS_mkdirat, AT_FDCWD, path, mode));
}

int pthread_create(pthread_t* made, const pthread_attr_t* attributes, void* (*run)(void*), void* argument) {
  using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  static const auto create = next<Create>("pthread_create");
  return fails(thread) ? EAGAIN : create(made, attributes, run, argument);
}
}
