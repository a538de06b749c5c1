/* SPDX-License-Identifier: MIT */
#if !defined(_XOPEN_SOURCE)
#define _XOPEN_SOURCE 700 /* fork, pipe, setrlimit with RLIMIT_AS, strsignal */
#endif
#include "apart.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static size_t chosen_seconds;

void apart_set_seconds(size_t seconds)
{
    chosen_seconds = seconds;
}

#if defined(__unix__) || defined(__APPLE__)

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

/* Sanitizers reserve more addresses than any limit. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define UNLIMITED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define UNLIMITED 1
#endif
#endif
#if !defined(UNLIMITED)
#define UNLIMITED 0
#endif

/* Before the parcel. */
typedef struct head {
    nkw_import_error error;
    size_t bytes, link_count;
} head;

#define MIB ((size_t)1 << 20)

static size_t seconds_of(const nkw_import_memory *memory)
{
    return chosen_seconds ? chosen_seconds : 10 + memory->bytes / MIB;
}

/* Bytes of a document, and of a child's addresses. A document of n bytes of files has less than 64 MiB + 64 n. */
static size_t most_bytes(const nkw_import_memory *memory)
{
    return memory->bytes < SIZE_MAX / 4 / 128 ? 2048 * MIB + 128 * memory->bytes : SIZE_MAX / 4;
}

int apart_possible(void)
{
    return 1;
}

/* ---- the child ---- */

static void limit(int resource, size_t most, size_t hard)
{
    struct rlimit l;
    if (getrlimit(resource, &l) != 0)
        return;
    const rlim_t last = l.rlim_max == RLIM_INFINITY || (rlim_t)hard < l.rlim_max ? (rlim_t)hard : l.rlim_max;
    l.rlim_cur = (rlim_t)most < last ? (rlim_t)most : last;
    l.rlim_max = last;
    setrlimit(resource, &l);
}

/* What foreign code prints belongs to no output of the program. */
static void silence(void)
{
    const int nothing = open("/dev/null", O_WRONLY);
    if (nothing < 0)
        return;
    dup2(nothing, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
}

static int write_all(int to, const void *data, size_t bytes)
{
    const char *at = data;
    while (bytes > 0) {
        const ssize_t put = write(to, at, bytes < MIB ? bytes : MIB);
        if (put < 0 && errno != EINTR)
            return 0;
        at += put > 0 ? put : 0;
        bytes -= put > 0 ? (size_t)put : 0;
    }
    return 1;
}

static int send(const nkw_import_memory *memory, apart_reader read_file, int to)
{
    head h;
    parcel p;
    memset(&h, 0, sizeof h);
    memset(&p, 0, sizeof p);
    nkw_document *d = read_file(memory, &h.error);
    if (d && !parcel_pack(&p, d)) {
        h.error.code = NKW_IMPORT_NO_MEMORY;
        strcpy(h.error.reason, "no memory for the document");
    }
    h.bytes = h.error.code == NKW_IMPORT_OK ? p.bytes : 0;
    h.link_count = h.bytes ? p.link_count : 0;
    return write_all(to, &h, sizeof h) && write_all(to, p.links, h.link_count * sizeof *p.links) &&
           write_all(to, p.data, h.bytes);
}

/* _exit: the buffers of the parent's streams are not written twice, and no memory is freed. */
static void be_child(const nkw_import_memory *memory, apart_reader read_file, int to)
{
    const size_t seconds = seconds_of(memory), bytes = most_bytes(memory);
    signal(SIGPIPE, SIG_DFL);
    signal(SIGXCPU, SIG_DFL);
    limit(RLIMIT_CORE, 0, 0);
    limit(RLIMIT_FSIZE, 0, 0);
    limit(RLIMIT_CPU, seconds, seconds + 1);
    if (!UNLIMITED)
        limit(RLIMIT_AS, bytes, bytes);
    silence();
    _exit(send(memory, read_file, to) ? 0 : 1);
}

/* ---- the parent ---- */

static int read_all(int from, void *data, size_t bytes)
{
    char *at = data;
    while (bytes > 0) {
        const ssize_t got = read(from, at, bytes < MIB ? bytes : MIB);
        if (got == 0 || (got < 0 && errno != EINTR))
            return 0;
        at += got > 0 ? got : 0;
        bytes -= got > 0 ? (size_t)got : 0;
    }
    return 1;
}

static int no_memory(nkw_import_error *error)
{
    error->code = NKW_IMPORT_NO_MEMORY;
    strcpy(error->reason, "no memory for the document");
    return 0;
}

/* Whether a whole parcel, or the child's error, was read; otherwise the child ended early, or there is no memory. */
static int receive(int from, size_t most, parcel *p, nkw_import_error *error)
{
    head h;
    if (!read_all(from, &h, sizeof h))
        return 0;
    if (h.error.code != NKW_IMPORT_OK) {
        *error = h.error;
        return 1;
    }
    if (h.bytes > most || h.link_count > h.bytes / sizeof *p->links)
        return 0;
    p->links = malloc(h.link_count * sizeof *p->links + 1);
    p->data = malloc(h.bytes + 1);
    p->bytes = h.bytes;
    p->link_count = h.link_count;
    if (!p->links || !p->data)
        return no_memory(error);
    return read_all(from, p->links, h.link_count * sizeof *p->links) && read_all(from, p->data, h.bytes);
}

/* A child that ended without a document. SIGKILL is the end of a child that does not end at SIGXCPU. */
static void explain(const nkw_import_memory *memory, int status, nkw_import_error *error)
{
    error->code = NKW_IMPORT_INVALID;
    if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)) {
        error->code = NKW_IMPORT_TOO_LARGE;
        snprintf(error->reason, sizeof error->reason,
                 "its reader was ended by signal %d after at most %zu s of CPU time, the limit: see --read-limit",
                 WTERMSIG(status), seconds_of(memory));
    } else if (WIFSIGNALED(status))
        snprintf(error->reason, sizeof error->reason, "its reader ended by signal %d (%s): the file is damaged, or %s",
                 WTERMSIG(status), strsignal(WTERMSIG(status)), "a fault of the reader");
    else
        strcpy(error->reason, "its reader ended without a document");
}

static int wait_for(pid_t child)
{
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            return 0;
    return status;
}

nkw_document *apart_read(const nkw_import_memory *memory, apart_reader read_file, parcel *p, nkw_import_error *error)
{
    int ends[2] = {-1, -1};
    memset(p, 0, sizeof *p);
    memset(error, 0, sizeof *error);
    snprintf(error->file, sizeof error->file, "%s", memory->file);
    const pid_t child = pipe(ends) == 0 ? fork() : -1;
    if (child < 0) {
        error->code = NKW_IMPORT_UNREADABLE;
        snprintf(error->reason, sizeof error->reason, "no process for its reader: %s", strerror(errno));
        if (ends[0] >= 0)
            close(ends[0]), close(ends[1]);
        return NULL;
    }
    if (child == 0) {
        close(ends[0]);
        be_child(memory, read_file, ends[1]);
    }
    close(ends[1]);
    const int whole = receive(ends[0], most_bytes(memory), p, error);
    close(ends[0]);
    const int status = wait_for(child);
    if (!whole && error->code == NKW_IMPORT_OK)
        explain(memory, status, error);
    nkw_document *d = error->code == NKW_IMPORT_OK ? parcel_open(p) : NULL;
    if (!d && error->code == NKW_IMPORT_OK)
        explain(memory, 0, error);
    return d;
}

#else

int apart_possible(void)
{
    return 0;
}

nkw_document *apart_read(const nkw_import_memory *memory, apart_reader read_file, parcel *p, nkw_import_error *error)
{
    memset(p, 0, sizeof *p);
    return read_file(memory, error);
}

#endif
