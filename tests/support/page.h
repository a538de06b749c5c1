/* SPDX-License-Identifier: MIT */
/* Numbers on pages: a test computes them and prints the words of the page around them. */
#ifndef NAKAWARI_TESTS_PAGE_H
#define NAKAWARI_TESTS_PAGE_H

/*
 * Fails unless the page, a path below docs, has the text that the format prints. All white space is one space; commas
 * between digits, and a zero that begins an exponent, are left out on both sides.
 */
#define expect_page(page, ...) expect_page_at(__FILE__, __LINE__, (page), __VA_ARGS__)

void expect_page_at(const char *file, int line, const char *page, const char *format, ...);

#endif
