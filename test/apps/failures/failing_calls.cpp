// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// These functions replace those of the C library if they are loaded before it
// (LD_PRELOAD). They fail as environment variables say:
// - FULL_AT_WRITE=n: the disk has room for half of the n-th write, and is then full.
// - KILLED_AT_WRITE=n: the program is killed before its n-th write.
// - READ_ONLY=1: no file and no folder can be created.
// - THREADS_TO_START=n: only the first n threads can be started; n may be 0.
// Only writes to regular files count, from 1 on; standard output and error do not.

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

/** \brief The function of that name in the C library. */
template <typename Function>
Function*
original (const char* name)
{
  return reinterpret_cast<Function*> (::dlsym (RTLD_NEXT, name));
}

/** \brief The number in an environment variable; 0 if the variable is not set. */
long
numberIn (const char* variable)
{
  const char* const text = std::getenv (variable);
  return text == nullptr ? 0 : std::atol (text);
}

/** \brief Whether a descriptor is of a regular file and not of a standard stream, which
 * may be redirected to a file. */
bool
isFile (int descriptor)
{
  struct stat status {};
  return descriptor > STDERR_FILENO && ::fstat (descriptor, &status) == 0 &&
         S_ISREG (status.st_mode);
}

enum class Disk { HasRoom, GetsFull, IsFull };

/** \brief Counts one more write and returns the state of the disk for it. Kills the
 * program instead if that is the write of KILLED_AT_WRITE. */
Disk
diskAtNextWrite ()
{
  static std::atomic<long> writes{0};
  static const long filling_write = numberIn ("FULL_AT_WRITE"); // 0: none
  static const long fatal_write = numberIn ("KILLED_AT_WRITE"); // 0: none
  const long write = ++writes;
  if (write == fatal_write)
    ::raise (SIGKILL);
  if (filling_write == 0 || write < filling_write)
    return Disk::HasRoom;
  return write == filling_write ? Disk::GetsFull : Disk::IsFull;
}

/** \brief Writes all, half or none of the bytes (of write) or of the buffers (of
 * writev), by the state of the disk. Half of a single byte or buffer is none.
 * \param[in] call the function of the C library */
template <typename Call, typename Source, typename Count>
ssize_t
writeWhereThereIsRoom (Call* call, int descriptor, const Source* source, Count count)
{
  const Disk disk = isFile (descriptor) ? diskAtNextWrite() : Disk::HasRoom;
  if (disk == Disk::IsFull || (disk == Disk::GetsFull && count < 2)) {
    errno = ENOSPC;
    return -1;
  }
  return call (descriptor, source, disk == Disk::GetsFull ? count / 2 : count);
}

/** \brief Whether a call that creates a file or a folder has to fail: READ_ONLY is set
 * to another number than 0. If so, sets errno. */
bool
failsToCreate ()
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
writev (int descriptor, const struct iovec* buffers, int count)
{
  static auto* const call = original<decltype (writev)> ("writev");
  return writeWhereThereIsRoom (call, descriptor, buffers, count);
}

int
open (const char* path, int flags, ...)
{
  static auto* const call = original<int (const char*, int, ...)> ("open");
  va_list arguments;
  va_start (arguments, flags);
  const auto mode = (flags & O_CREAT) != 0 ? va_arg (arguments, mode_t) : 0;
  va_end (arguments);
  return (flags & O_CREAT) != 0 && failsToCreate() ? -1 : call (path, flags, mode);
}

int
mkdir (const char* path, mode_t mode)
{
  static auto* const call = original<decltype (mkdir)> ("mkdir");
  return failsToCreate() ? -1 : call (path, mode);
}

int
pthread_create (pthread_t* thread,
                const pthread_attr_t* attributes,
                void* (*run) (void*),
                void* argument)
{
  static auto* const call = original<decltype (pthread_create)> ("pthread_create");
  static const long max_threads = numberIn ("THREADS_TO_START");
  static std::atomic<long> started{0};
  if (std::getenv ("THREADS_TO_START") != nullptr && ++started > max_threads)
    return EAGAIN;
  return call (thread, attributes, run, argument);
}
}
