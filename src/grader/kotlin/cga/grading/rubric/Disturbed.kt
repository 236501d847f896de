package cga.grading.rubric

import cga.grading.findings.Check
import cga.grading.findings.Check.ATTENUATION_FORM
import cga.grading.findings.Check.ATTENUATION_POINT
import cga.grading.findings.Check.ATTENUATION_SPOT
import cga.grading.findings.Check.CONE
import cga.grading.findings.Check.CONE_SPECULAR
import cga.grading.findings.Check.DIFFUSE
import cga.grading.findings.Check.EMISSION
import cga.grading.findings.Check.GROUND_COLOR
import cga.grading.findings.Check.HALF_VECTOR
import cga.grading.findings.Check.INTERPOLATION
import cga.grading.findings.Check.LIGHT_COLOR
import cga.grading.findings.Check.MATERIAL
import cga.grading.findings.Check.MORE_LIGHTS
import cga.grading.findings.Check.MORE_LIGHTS_SHADING
import cga.grading.findings.Check.MOTORCYCLE_COLOR
import cga.grading.findings.Check.NORMALS
import cga.grading.findings.Check.ORBIT
import cga.grading.findings.Check.ORBIT_FACTOR
import cga.grading.findings.Check.ORBIT_HORIZON
import cga.grading.findings.Check.ORBIT_PIVOT
import cga.grading.findings.Check.ORBIT_START
import cga.grading.findings.Check.POINT_LIGHT
import cga.grading.findings.Check.POINT_LIGHT_CHILD
import cga.grading.findings.Check.POINT_LIGHT_POSITION
import cga.grading.findings.Check.SPECULAR
import cga.grading.findings.Check.SPOT_DIRECTION
import cga.grading.findings.Check.SPOT_LIGHT
import cga.grading.findings.Check.SPOT_LIGHT_CHILD
import cga.grading.findings.Found
import cga.grading.findings.Mistake

private val ATTENUATION = setOf(ATTENUATION_FORM, ATTENUATION_POINT, ATTENUATION_SPOT)

// Shading by the angle between normal and light, and by that of the highlight.
private val SURFACE = setOf(DIFFUSE, SPECULAR, NORMALS, INTERPOLATION, CONE_SPECULAR, MORE_LIGHTS_SHADING, HALF_VECTOR)
private val HIGHLIGHT = setOf(SPECULAR, CONE_SPECULAR, MORE_LIGHTS_SHADING, HALF_VECTOR)

// A light that stands elsewhere shines at other angles, from other distances, and does not move as it should.
private val PLACE = SURFACE + ATTENUATION + setOf(POINT_LIGHT, POINT_LIGHT_CHILD, POINT_LIGHT_POSITION)
private val SPOT = setOf(SPOT_LIGHT, SPOT_LIGHT_CHILD, SPOT_DIRECTION, CONE, CONE_SPECULAR)
private val ORBITING = setOf(ORBIT_PIVOT, ORBIT_HORIZON, ORBIT_FACTOR, ORBIT_START)

// What uniforms are sent for, beginning with what is there or is not.
private val SENT =
    listOf(
        POINT_LIGHT, SPOT_LIGHT, MORE_LIGHTS, POINT_LIGHT_POSITION, POINT_LIGHT_CHILD, SPOT_LIGHT_CHILD, SPOT_DIRECTION, CONE,
        ATTENUATION_POINT, ATTENUATION_SPOT, MOTORCYCLE_COLOR, SPECULAR,
    )

/** The checks that measure something else than they should while [mistake] is in the picture, besides the one that it costs. */
internal fun disturbedBy(mistake: Mistake): Set<Check> =
    when (mistake) {
        Mistake.VIEW_VECTOR_SIGN, Mistake.SPECULAR_CLAMP_MISSING, Mistake.EXPONENT_FIXED, Mistake.SPECULAR_MISSING -> HIGHLIGHT
        Mistake.PHONG_LEFT, Mistake.HALF_VECTOR_NOT_NORMALIZED -> HIGHLIGHT
        Mistake.TO_LIGHT_NOT_NORMALIZED, Mistake.NORMALIZED_IN_VERTEX_SHADER -> SURFACE + ATTENUATION + setOf(CONE, POINT_LIGHT_POSITION)
        Mistake.NORMAL_NOT_RENORMALIZED, Mistake.NORMAL_MATRIX, Mistake.CLAMP_MISSING, Mistake.LIGHT_VECTOR_SIGN -> SURFACE
        Mistake.DIFFUSE_MISSING -> SURFACE + MATERIAL + ATTENUATION
        Mistake.TO_LIGHT_WORLD, Mistake.VIEW_SCALED -> PLACE + SPOT + setOf(ORBIT_PIVOT)
        Mistake.LIGHT_POSITION_OVERWRITTEN, Mistake.LIGHT_IN_GROUND -> PLACE + setOf(SPOT_LIGHT, SPOT_LIGHT_CHILD)
        // The colour that is multiplied with the emission is the same with any map.
        Mistake.MAPS_SWAPPED -> SURFACE + ATTENUATION + setOf(MATERIAL, EMISSION, CONE)
        Mistake.SAMPLER_UNIT, Mistake.GAMMA_DIRECTION ->
            SURFACE + ATTENUATION + setOf(MATERIAL, EMISSION, GROUND_COLOR, MOTORCYCLE_COLOR, LIGHT_COLOR, CONE)
        Mistake.LIGHTS_AFTER_DRAWS, Mistake.UNIFORM_BEFORE_USE ->
            SPOT + setOf(POINT_LIGHT, POINT_LIGHT_CHILD, POINT_LIGHT_POSITION, LIGHT_COLOR, MOTORCYCLE_COLOR, MORE_LIGHTS_SHADING)
        Mistake.UNIFORM_ABSENT -> PLACE + SPOT + setOf(LIGHT_COLOR, MOTORCYCLE_COLOR)
        Mistake.LIGHT_MISSING -> SURFACE + ATTENUATION + setOf(LIGHT_COLOR)
        Mistake.LIGHT_NOT_CHILD -> setOf(POINT_LIGHT_POSITION)
        Mistake.SPOT_MISSING -> setOf(ATTENUATION_SPOT)
        Mistake.SPOT_NOT_CHILD -> setOf(SPOT_DIRECTION)
        Mistake.CONE_INSIDE_OUT, Mistake.COSINE_OF_COSINE, Mistake.DEGREES_FOR_RADIANS, Mistake.CONE_CLAMP_MISSING,
        Mistake.CONE_NEVER_SENT, Mistake.CONE_HARD_EDGE,
        -> setOf(SPOT_LIGHT, CONE_SPECULAR, ATTENUATION_SPOT, POINT_LIGHT)
        Mistake.SPOT_DIRECTION_WORLD, Mistake.SPOT_DIRECTION_LOCAL, Mistake.SPOT_DIRECTION_SIGN ->
            setOf(SPOT_LIGHT, SPOT_LIGHT_CHILD, CONE, CONE_SPECULAR, ATTENUATION_SPOT)
        Mistake.SPECULAR_NOT_CONED -> setOf(CONE, SPECULAR)
        Mistake.ATTENUATION_MISSING, Mistake.ATTENUATION_LINEAR, Mistake.ATTENUATION_ON_DIFFUSE_ONLY ->
            setOf(ATTENUATION_POINT, ATTENUATION_SPOT, SPECULAR, CONE_SPECULAR, MORE_LIGHTS_SHADING)
        Mistake.ATTENUATION_ONE_K, Mistake.ATTENUATION_LAST_K, Mistake.ATTENUATION_OTHER_K ->
            setOf(ATTENUATION_POINT, ATTENUATION_SPOT)
        Mistake.EMISSION_MULTIPLIED, Mistake.EMISSION_COLOR_IGNORED, Mistake.EMISSION_COLOR_ADDED, Mistake.EMISSION_MISSING ->
            setOf(GROUND_COLOR, EMISSION, MOTORCYCLE_COLOR, MATERIAL)
        // Every light shines in the colour too.
        Mistake.COLOR_ON_EVERYTHING -> setOf(GROUND_COLOR, EMISSION, MOTORCYCLE_COLOR, MATERIAL, LIGHT_COLOR)
        Mistake.COLOR_CONSTANT -> setOf(LIGHT_COLOR)
        Mistake.LIGHT_COLOR_DIFFERS -> emptySet()
        Mistake.ORBIT_MISSING -> emptySet()
        Mistake.ORBIT_OWN_AXIS, Mistake.ORBIT_PIVOT -> ORBITING + ORBIT
        Mistake.MOUSE_FACTOR, Mistake.MOUSE_JUMP -> ORBITING
        Mistake.MORE_LIGHTS_MISSING, Mistake.MORE_LIGHTS_ALIKE -> emptySet()
        Mistake.LATER_LIGHTS_FIRST_COSINE -> SPOT + ATTENUATION + HALF_VECTOR
        Mistake.LATER_LIGHTS_FIRST_COLOR -> setOf(CONE_SPECULAR, HALF_VECTOR)
        Mistake.GLSL_DRIVER, Mistake.SHADER_REFUSED, Mistake.KOTLIN_REFUSED, Mistake.UNKNOWN -> emptySet()
    }

/** The checks that [found] may belong to, by what it has to do with; that of its nature first. */
internal fun homesOf(found: Found): List<Check> =
    when (found.mistake) {
        Mistake.ATTENUATION_OTHER_K -> listOf(ATTENUATION_POINT, ATTENUATION_SPOT)
        // What the name was of.
        Mistake.UNIFORM_ABSENT -> SENT.filter { it in (found.explains ?: SENT) }.ifEmpty { listOf(found.mistake.check) }
        else -> listOf(found.mistake.check)
    }

/** The checks that measure something else than they should where [check] is wrong in a way that has no name. */
internal fun spoiltBy(check: Check): Set<Check> =
    when (check) {
        DIFFUSE -> ATTENUATION + MORE_LIGHTS_SHADING
        SPECULAR -> HIGHLIGHT - SPECULAR
        CONE -> setOf(SPOT_LIGHT, CONE_SPECULAR, ATTENUATION_SPOT)
        ATTENUATION_FORM -> setOf(ATTENUATION_POINT, ATTENUATION_SPOT, CONE_SPECULAR, MORE_LIGHTS_SHADING)
        else -> emptySet()
    }
