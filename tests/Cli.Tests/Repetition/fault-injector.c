// Makes one file operation below a folder fail, as a disk or a file system does. It is preloaded, so that the calls of the .NET runtime
// come here, and the program under test loads it in the place of libc for its own calls. Operations are known by kind and path; the random
// part of the name of a temporary file is left out of the path.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

#define MAX_FILES 4096
#define LOG_SIZE (1 << 20)

enum { SURVIVES, DIES, VANISHES };

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static char root[PATH_MAX], wanted_kind[32], wanted_path[PATH_MAX], recorded[LOG_SIZE];
static size_t recorded_length;
static int is_on, wanted_number, wanted_error, ending, met, has_fired, is_dead, has_exchange = 1;
static char *files[MAX_FILES], is_read_only[MAX_FILES];

#define REAL(name) ({ static __typeof__(name) *real; if (!real) real = (__typeof__(name) *)dlsym(RTLD_NEXT, #name); real; })

static void shorten(const char *path, char *shortened) {
  const char *from = path;
  char *to = shortened, *end = shortened + PATH_MAX - 1;
  while (*from && to < end) {
    if (*from == '.' && strspn(from + 1, "0123456789abcdef") == 16 && !strncmp(from + 17, ".partial", 8)) {
      *to++ = '.';
      *to++ = '*';
      from += 17;
    } else {
      *to++ = *from++;
    }
  }
  *to = 0;
}

static int is_below(const char *path) { return path && !strncmp(path, root, strlen(root)); }

// Whether an operation is to fail. What was stopped by a kill does nothing any more, and a drive that has vanished opens nothing either.
static int fails(const char *kind, const char *path) {
  char name[PATH_MAX];
  int failing = 0;
  if (!is_on || !is_below(path)) return 0;
  pthread_mutex_lock(&lock);
  shorten(path[strlen(root)] ? path + strlen(root) : ".", name);
  if (is_dead) {
    errno = EIO;
    failing = ending == VANISHES || strcmp(kind, "open") != 0;
  } else {
    size_t length = strlen(kind) + strlen(name) + 2;
    if (recorded_length + length < LOG_SIZE) recorded_length += sprintf(recorded + recorded_length, "%s %s\n", kind, name);
    if (!has_fired && !strcmp(kind, wanted_kind) && !strcmp(name, wanted_path) && met++ == wanted_number) {
      has_fired = failing = 1;
      is_dead = ending != SURVIVES;
      errno = wanted_error;
    }
  }
  pthread_mutex_unlock(&lock);
  return failing;
}

static const char *file(int descriptor) { return descriptor >= 0 && descriptor < MAX_FILES ? files[descriptor] : NULL; }

static void remember(int descriptor, const char *path) {
  if (descriptor < 0 || descriptor >= MAX_FILES) return;
  free(files[descriptor]);
  files[descriptor] = path ? strdup(path) : NULL;
}

void fault_begin(const char *folder, const char *kind, const char *path, int number, int error, int how, int exchange) {
  snprintf(root, sizeof root, "%s/", folder);
  snprintf(wanted_kind, sizeof wanted_kind, "%s", kind);
  snprintf(wanted_path, sizeof wanted_path, "%s", path);
  wanted_number = number;
  wanted_error = error;
  ending = how;
  has_exchange = exchange;
  met = has_fired = is_dead = 0;
  recorded_length = 0;
  recorded[0] = 0;
  is_on = 1;
}

int fault_end(void) {
  is_on = is_dead = 0;
  has_exchange = 1;
  return has_fired;
}

const char *fault_operations(void) { return recorded; }

// The name of a folder ends with a slash.
static int opened(int descriptor, const char *path, int flags) {
  char name[PATH_MAX];
  struct stat status;
  if (descriptor < 0 || descriptor >= MAX_FILES) return descriptor;
  int is_folder = is_on && !fstat(descriptor, &status) && S_ISDIR(status.st_mode);
  snprintf(name, sizeof name, "%s%s", path, is_folder && path[strlen(path) - 1] != '/' ? "/" : "");
  remember(descriptor, is_on && is_below(name) ? name : NULL);
  is_read_only[descriptor] = (flags & O_ACCMODE) == O_RDONLY;
  return descriptor;
}

#define OPEN(name) \
  int name(const char *path, int flags, ...) { \
    va_list rest; \
    va_start(rest, flags); \
    mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(rest, mode_t) : 0; \
    va_end(rest); \
    if (fails(flags & O_CREAT ? "create" : "open", path)) return -1; \
    return opened(REAL(name)(path, flags, mode), path, flags); \
  }
OPEN(open)
OPEN(open64)

// A full disk takes a part of what is written.
#define WRITE(name, ...) \
  if (fails("write", file(descriptor))) { \
    int error = errno; \
    if (error == ENOSPC && count > 1) REAL(name)(descriptor, bytes, count / 2, ##__VA_ARGS__); \
    errno = error; \
    return -1; \
  } \
  return REAL(name)(descriptor, bytes, count, ##__VA_ARGS__);

ssize_t write(int descriptor, const void *bytes, size_t count) { WRITE(write) }
ssize_t pwrite64(int descriptor, const void *bytes, size_t count, off64_t at) { WRITE(pwrite64, at) }

ssize_t pwritev64(int descriptor, const struct iovec *parts, int count, off64_t at) {
  return fails("write", file(descriptor)) ? -1 : REAL(pwritev64)(descriptor, parts, count, at);
}

ssize_t sendfile64(int descriptor, int from, off64_t *at, size_t count) {
  static ssize_t (*real)(int, int, off64_t *, size_t);
  if (!real) real = (ssize_t (*)(int, int, off64_t *, size_t))dlsym(RTLD_NEXT, "sendfile64");
  return fails("write", file(descriptor)) ? -1 : real(descriptor, from, at, count);
}

int ftruncate64(int descriptor, off64_t length) {
  return fails("truncate", file(descriptor)) ? -1 : REAL(ftruncate64)(descriptor, length);
}

int fsync(int descriptor) { return fails("flush", file(descriptor)) ? -1 : REAL(fsync)(descriptor); }
int fdatasync(int descriptor) { return fails("flush", file(descriptor)) ? -1 : REAL(fdatasync)(descriptor); }

int dup(int descriptor) {
  int second = REAL(dup)(descriptor);
  if (second >= 0 && second < MAX_FILES && descriptor < MAX_FILES) {
    remember(second, file(descriptor));
    is_read_only[second] = is_read_only[descriptor];
  }
  return second;
}

// Nothing is lost when what was only read or flushed cannot be closed.
int close(int descriptor) {
  const char *path = file(descriptor);
  int failing = path && !is_read_only[descriptor] && fails("close", path), error = errno;
  remember(descriptor, NULL);
  int code = REAL(close)(descriptor);
  if (!failing) return code;
  errno = error;
  return -1;
}

int rename(const char *from, const char *to) { return fails("rename", to) ? -1 : REAL(rename)(from, to); }

int renameat2(int from_folder, const char *from, int to_folder, const char *to, unsigned flags) {
  if (is_on && !has_exchange) {
    errno = EINVAL;
    return -1;
  }
  return fails("exchange", to) ? -1 : REAL(renameat2)(from_folder, from, to_folder, to, flags);
}

int link(const char *from, const char *to) { return fails("link", to) ? -1 : REAL(link)(from, to); }
int symlink(const char *from, const char *to) { return fails("symlink", to) ? -1 : REAL(symlink)(from, to); }
int unlink(const char *path) { return fails("delete", path) ? -1 : REAL(unlink)(path); }
int rmdir(const char *path) { return fails("rmdir", path) ? -1 : REAL(rmdir)(path); }
int mkdir(const char *path, mode_t mode) { return fails("mkdir", path) ? -1 : REAL(mkdir)(path, mode); }
int chmod(const char *path, mode_t mode) { return fails("chmod", path) ? -1 : REAL(chmod)(path, mode); }
