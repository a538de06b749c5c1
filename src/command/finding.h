/* SPDX-License-Identifier: MIT */
/** @file The findings of `nakawari check`: where, what, how much. */
#ifndef FINDING_H
#define FINDING_H

#include <jansson.h>

#include "command.h"
#include "progress.h"

typedef enum severity { SEVERITY_NOTE, SEVERITY_WARNING, SEVERITY_ERROR, SEVERITIES } severity;

/** One finding. Members that do not apply are NULL or -1. */
typedef struct finding {
    severity level;
    const char *what; /**< a word: "not-unit" */
    const char *object; /**< "rotation" of a joint, "skin" ...; the part of the file */
    const char *joint; /**< the name of a joint, mesh or skin */
    long clip, number; /**< number: of the joint's node, or of the mesh or skin, in the file */
    long key, vertex; /**< where in the object */
    float time; /**< of the key */
    double amount; /**< how much */
    char detail[160]; /**< in words */
} finding;

/** A finding without a place. */
finding finding_of(severity level, const char *what);

/** The findings of one kind. */
typedef struct finding_kind {
    finding worst;
    size_t count;
} finding_kind;

enum { FINDING_KINDS = 48 };

/** Whether a word is a kind of finding. */
int finding_is_kind(const char *what, size_t length);

/**
 * Findings are printed as they come, or collected as JSON; of each kind and object at most `most`. With `sums_up` one is
 * printed for each kind, by findings_end.
 */
typedef struct findings {
    const nkw_document *document;
    json_t *list; /**< NULL: print lines */
    size_t counts[SEVERITIES];
    size_t repeated, most; /**< findings of the same kind and object one after another */
    const char *last_what, *last_object;
    long last_clip, last_number;
    const char *only; /**< NULL, or kinds, separated by commas: others are not counted */
    int hide_notes, sums_up;
    finding_kind kinds[FINDING_KINDS]; /**< one severity of one kind each */
    size_t kind_count;
    progress line; /**< of the checks: ended before a finding is printed */
    int failed; /**< no memory */
} findings;

void findings_add(findings *all, const finding *f);
/** Sorts the kinds: errors first, and those that are found most often; prints the worst of each if it sums up. */
void findings_end(findings *all);
/** The kinds as JSON. */
json_t *findings_kinds(const findings *all);

#endif
