package cga.reader.shader

/**
 * What an instruction of a [Shader] does with single numbers; vectors and matrices are taken apart.
 *
 * @property operands how many cells it reads.
 * @property isValue whether it makes a number of them, which a tape then keeps.
 */
public enum class Operation(
    public val operands: Int,
    public val isValue: Boolean = true,
) {
    ADD(2),
    SUB(2),
    MUL(2),
    DIV(2),
    NEG(1),
    ABS(1),
    MIN(2),
    MAX(2),
    SQRT(1),
    INVERSE_SQRT(1),
    POW(2),

    /** 1 where they are equal, otherwise 0; so do all comparisons. */
    EQUAL(2),
    NOT_EQUAL(2),
    LESS(2),
    LESS_EQUAL(2),
    AND(2),
    OR(2),
    NOT(1),

    /** The second where the first is true, otherwise the third. */
    SELECT(3),
    INT_ADD(2),

    /** x - y·floor(x/y): GLSL's `mod`. */
    MOD(2),

    /** x - y·trunc(x/y). */
    REM(2),
    SIGN(1),
    FLOOR(1),
    CEIL(1),
    TRUNC(1),

    /** To the nearest whole number, to the even one of two. */
    ROUND(1),
    FRACT(1),
    EXP(1),
    EXP2(1),
    LOG(1),
    LOG2(1),
    SIN(1),
    COS(1),
    TAN(1),
    ASIN(1),
    ACOS(1),
    ATAN(1),
    ATAN2(2),
    SINH(1),
    COSH(1),
    TANH(1),
    ASINH(1),
    ACOSH(1),
    ATANH(1),
    IS_NAN(1),
    IS_INF(1),
    INT_SUB(2),
    INT_MUL(2),
    INT_DIV(2),
    INT_REM(2),
    INT_MOD(2),
    INT_NEG(1),
    SHIFT_LEFT(2),
    SHIFT_RIGHT(2),
    SHIFT_RIGHT_LOGICAL(2),
    BIT_AND(2),
    BIT_OR(2),
    BIT_XOR(2),
    BIT_NOT(1),

    /** The same 32 bits as another kind of integer. */
    INT_CAST(1),

    /** A float cut off to an integer, and back. */
    FLOAT_TO_INT(1),
    INT_TO_FLOAT(1),

    /** The bits of a float as an integer, and back. */
    FLOAT_BITS(1),
    BITS_FLOAT(1),

    /** A component of what a texture has there; its operands are the sampler and where. */
    TEXTURE(1),

    /** An extent of a texture in texels; its operands are the sampler and the level. */
    TEXTURE_SIZE(1),
    DPDX(1),
    DPDY(1),

    /** A decision: its value is 1 where the condition is true, and of a `switch` what is switched on. */
    BRANCH(1),
    SWITCH(1),

    // The rest moves numbers or goes on elsewhere; a tape sees through it.
    MOVE(1, false),

    /** From a place that is computed. */
    LOAD(1, false),
    STORE(2, false),

    /** The place of an element, within its array whatever the index. */
    INDEX(1, false),
    OFFSET(2, false),
    JUMP(0, false),
    DISCARD(0, false),
    END(0, false),
}
