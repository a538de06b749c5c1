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

/** Prints findings as they come, or collects them. Of each kind and object at most `most` are printed. */
typedef struct findings {
    const nkw_document *document;
    json_t *list; /**< NULL: print lines */
    size_t counts[SEVERITIES];
    size_t repeated, most; /**< findings of the same kind and object one after another */
    const char *last_what, *last_object;
    long last_clip, last_number;
    int hide_notes;
    progress line; /**< of the checks: ended before a finding is printed */
    int failed; /**< no memory */
} findings;

void findings_add(findings *all, const finding *f);

#endif
