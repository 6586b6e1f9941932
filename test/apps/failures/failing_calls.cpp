// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// Loaded in front of the C library (LD_PRELOAD), these calls fail where the environment
// says so. What programs print is not counted.

#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdlib>

namespace {

template <typename Function>
Function*
original (const char* name)
{
  return reinterpret_cast<Function*> (::dlsym (RTLD_NEXT, name));
}

/** \brief The number in an environment variable; 0 if it is not set. */
long
numberIn (const char* variable)
{
  const char* const text = std::getenv (variable);
  return text == nullptr ? 0 : std::atol (text);
}

bool
isFile (int descriptor)
{
  struct stat status {};
  return descriptor > STDERR_FILENO && ::fstat (descriptor, &status) == 0 &&
         S_ISREG (status.st_mode);
}

enum class Disk { HasRoom, GetsFull, IsFull };

/** \brief State of the disk at the next write; the n-th still has room for a part. */
Disk
diskAtNextWrite ()
{
  static std::atomic<long> writes{0};
  static const long last = numberIn ("FULL_AT_WRITE"),
                    fatal = numberIn ("KILLED_AT_WRITE");
  const long write = ++writes;
  if (write == fatal)
    ::raise (SIGKILL);
  if (last == 0 || write < last)
    return Disk::HasRoom;
  return write == last ? Disk::GetsFull : Disk::IsFull;
}

/** \brief Writes all, half or none of a number of bytes or parts. */
template <typename Call, typename What, typename Count>
ssize_t
writeWhereThereIsRoom (Call* call, int descriptor, const What* what, Count count)
{
  const Disk disk = isFile (descriptor) ? diskAtNextWrite() : Disk::HasRoom;
  if (disk == Disk::IsFull || (disk == Disk::GetsFull && count < 2)) {
    errno = ENOSPC;
    return -1;
  }
  return call (descriptor, what, disk == Disk::GetsFull ? count / 2 : count);
}

bool
isReadOnly ()
{
  static const bool is_set = numberIn ("READ_ONLY") != 0;
  errno = is_set ? EROFS : errno;
  return is_set;
}

} // namespace

extern "C" {

ssize_t
write (int descriptor, const void* bytes, std::size_t count)
{
  static auto* const call = original<decltype (write)> ("write");
  return writeWhereThereIsRoom (call, descriptor, bytes, count);
}

ssize_t
writev (int descriptor, const struct iovec* parts, int count)
{
  static auto* const call = original<decltype (writev)> ("writev");
  return writeWhereThereIsRoom (call, descriptor, parts, count);
}

int
open (const char* path, int flags, ...)
{
  static auto* const call = original<int (const char*, int, ...)> ("open");
  va_list arguments;
  va_start (arguments, flags);
  const auto mode = (flags & O_CREAT) != 0 ? va_arg (arguments, mode_t) : 0;
  va_end (arguments);
  return (flags & O_CREAT) != 0 && isReadOnly() ? -1 : call (path, flags, mode);
}

int
mkdir (const char* path, mode_t mode)
{
  static auto* const call = original<decltype (mkdir)> ("mkdir");
  return isReadOnly() ? -1 : call (path, mode);
}

int
pthread_create (pthread_t* thread,
                const pthread_attr_t* attributes,
                void* (*run) (void*),
                void* argument)
{
  static auto* const call = original<decltype (pthread_create)> ("pthread_create");
  static const long most = numberIn ("THREADS_TO_START");
  static std::atomic<long> started{0};
  if (std::getenv ("THREADS_TO_START") != nullptr && ++started > most)
    return EAGAIN;
  return call (thread, attributes, run, argument);
}
}
