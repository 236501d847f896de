package cga.grading.capture

import org.lwjgl.opengl.GL33C.*

/** Sizes and kinds of OpenGL's types, as far as a capture holds them. */
public object GlNumbers {
    /** The primitives that a draw may make. */
    public val modes: Set<Int> =
        setOf(GL_POINTS, GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN)

    /** The filters that read more than the largest level of a texture. */
    public val mipmapFilters: Set<Int> =
        setOf(GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_LINEAR)

    /** Bytes of an index of [type], null for what is none. */
    public fun indexBytes(type: Int): Int? =
        when (type) {
            GL_UNSIGNED_BYTE -> 1
            GL_UNSIGNED_SHORT -> 2
            GL_UNSIGNED_INT -> 4
            else -> null
        }

    /** Bytes of one component of a vertex attribute of [type], null for what a capture cannot hold. */
    public fun attributeBytes(type: Int): Int? =
        when (type) {
            GL_BYTE, GL_UNSIGNED_BYTE -> 1
            GL_SHORT, GL_UNSIGNED_SHORT, GL_HALF_FLOAT -> 2
            GL_INT, GL_UNSIGNED_INT, GL_FLOAT -> 4
            GL_DOUBLE -> 8
            else -> null
        }

    /** How many numbers a uniform of [type] has, null for a type that a capture cannot hold. */
    public fun components(type: Int): Int? =
        when (type) {
            GL_FLOAT, GL_INT, GL_UNSIGNED_INT, GL_BOOL, GL_SAMPLER_2D, GL_SAMPLER_CUBE -> 1
            GL_FLOAT_VEC2, GL_INT_VEC2, GL_UNSIGNED_INT_VEC2, GL_BOOL_VEC2 -> 2
            GL_FLOAT_VEC3, GL_INT_VEC3, GL_UNSIGNED_INT_VEC3, GL_BOOL_VEC3 -> 3
            GL_FLOAT_VEC4, GL_INT_VEC4, GL_UNSIGNED_INT_VEC4, GL_BOOL_VEC4, GL_FLOAT_MAT2 -> 4
            GL_FLOAT_MAT2x3, GL_FLOAT_MAT3x2 -> 6
            GL_FLOAT_MAT2x4, GL_FLOAT_MAT4x2 -> 8
            GL_FLOAT_MAT3 -> 9
            GL_FLOAT_MAT3x4, GL_FLOAT_MAT4x3 -> 12
            GL_FLOAT_MAT4 -> 16
            else -> null
        }

    /** How many of a uniform's numbers are one column: the rows of a matrix, all numbers of anything else. */
    public fun rows(type: Int): Int =
        when (type) {
            GL_FLOAT_MAT2, GL_FLOAT_MAT3x2, GL_FLOAT_MAT4x2 -> 2
            GL_FLOAT_MAT3, GL_FLOAT_MAT2x3, GL_FLOAT_MAT4x3 -> 3
            GL_FLOAT_MAT4, GL_FLOAT_MAT2x4, GL_FLOAT_MAT3x4 -> 4
            else -> components(type) ?: 0
        }

    /** Whether a uniform of [type] is made of whole numbers: samplers, booleans and integers. */
    public fun isWhole(type: Int): Boolean = !isUnsigned(type) && type in WHOLE

    /** Whether a uniform of [type] is made of unsigned whole numbers. */
    public fun isUnsigned(type: Int): Boolean =
        type in setOf(GL_UNSIGNED_INT, GL_UNSIGNED_INT_VEC2, GL_UNSIGNED_INT_VEC3, GL_UNSIGNED_INT_VEC4)

    private val WHOLE =
        setOf(
            GL_INT, GL_INT_VEC2, GL_INT_VEC3, GL_INT_VEC4, GL_BOOL, GL_BOOL_VEC2, GL_BOOL_VEC3, GL_BOOL_VEC4, GL_SAMPLER_2D,
            GL_SAMPLER_CUBE,
        )
}
