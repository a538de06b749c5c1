/* SPDX-License-Identifier: MIT */
#include "support/expect.h"

static void ok_is_zero(void **state)
{
    (void)state;
    assert_int_equal(NKW_OK, 0);
}

static void every_result_has_a_text_of_its_own(void **state)
{
    (void)state;
    for (int a = 0; a < NKW_RESULT_COUNT; a++) {
        assert_true(strlen(nkw_result_text((nkw_result)a)) > 3);
        for (int b = 0; b < a; b++)
            assert_string_not_equal(nkw_result_text((nkw_result)a), nkw_result_text((nkw_result)b));
    }
}

static void numbers_outside_the_list_are_unknown(void **state)
{
    (void)state;
    assert_string_equal(nkw_result_text(NKW_RESULT_COUNT), "unknown result");
    assert_string_equal(nkw_result_text((nkw_result)12345), "unknown result");
}

static void library_and_headers_have_the_same_version(void **state)
{
    (void)state;
    unsigned headers = NKW_VERSION_MAJOR * 10000u + NKW_VERSION_MINOR * 100u + NKW_VERSION_PATCH;
    assert_int_equal(nkw_version(), headers);
}

static void values_have_no_padding(void **state)
{
    (void)state;
    assert_int_equal(sizeof(nkw_vec3), 3 * sizeof(float));
    assert_int_equal(sizeof(nkw_quat), 4 * sizeof(float));
    assert_int_equal(sizeof(nkw_mat3), 9 * sizeof(float));
    assert_int_equal(sizeof(nkw_mat4), 16 * sizeof(float));
    assert_int_equal(sizeof(nkw_mat3x4), 12 * sizeof(float));
    assert_int_equal(sizeof(nkw_dual_quat), 8 * sizeof(float));
    assert_int_equal(sizeof(nkw_trs), 10 * sizeof(float));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ok_is_zero),
        cmocka_unit_test(every_result_has_a_text_of_its_own),
        cmocka_unit_test(numbers_outside_the_list_are_unknown),
        cmocka_unit_test(library_and_headers_have_the_same_version),
        cmocka_unit_test(values_have_no_padding),
    };
    return cmocka_run_group_tests_name("base", tests, NULL, NULL);
}
