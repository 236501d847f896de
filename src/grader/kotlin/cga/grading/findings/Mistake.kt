package cga.grading.findings

/**
 * The mistakes that have a name, with the check that each one costs. What is said to the student about them is in the message files, under
 * the same [id].
 */
public enum class Mistake(
    public val id: String,
    public val check: Check,
) {
    // 4.2
    VIEW_VECTOR_SIGN("view-vector-sign", Check.SPECULAR),
    NORMALIZED_IN_VERTEX_SHADER("normalized-in-vertex-shader", Check.INTERPOLATION),
    NORMAL_NOT_RENORMALIZED("normal-not-renormalized", Check.INTERPOLATION),
    NORMAL_MATRIX("normal-matrix", Check.NORMALS),
    TO_LIGHT_WORLD("to-light-in-world-space", Check.POINT_LIGHT_POSITION),
    VIEW_SCALED("view-space-scaled", Check.POINT_LIGHT_POSITION),
    CLAMP_MISSING("clamp-missing", Check.DIFFUSE),
    LIGHT_VECTOR_SIGN("light-vector-sign", Check.DIFFUSE),
    TO_LIGHT_NOT_NORMALIZED("to-light-not-normalized", Check.DIFFUSE),
    SPECULAR_CLAMP_MISSING("specular-clamp-missing", Check.SPECULAR),
    EXPONENT_FIXED("exponent-fixed", Check.SPECULAR),
    SPECULAR_MISSING("specular-missing", Check.SPECULAR),
    DIFFUSE_MISSING("diffuse-missing", Check.DIFFUSE),
    MAPS_SWAPPED("maps-swapped", Check.MATERIAL),
    SAMPLER_UNIT("sampler-left-at-unit-0", Check.MATERIAL),
    LIGHTS_AFTER_DRAWS("lights-bound-after-the-draws", Check.ORDER),
    UNIFORM_BEFORE_USE("uniform-set-before-use", Check.ORDER),
    UNIFORM_ABSENT("uniform-name-unknown", Check.POINT_LIGHT),
    LIGHT_MISSING("light-missing", Check.POINT_LIGHT),
    LIGHT_NOT_CHILD("light-not-child", Check.POINT_LIGHT_CHILD),
    LIGHT_POSITION_OVERWRITTEN("light-position-overwritten", Check.POINT_LIGHT_POSITION),
    LIGHT_IN_GROUND("light-in-the-ground", Check.POINT_LIGHT_CHILD),

    // 4.3
    SPOT_MISSING("spot-missing", Check.SPOT_LIGHT),
    SPOT_NOT_CHILD("spot-not-child", Check.SPOT_LIGHT_CHILD),
    CONE_INSIDE_OUT("cone-inside-out", Check.CONE),
    COSINE_OF_COSINE("cosine-of-cosine", Check.CONE),
    DEGREES_FOR_RADIANS("degrees-for-radians", Check.CONE),
    CONE_CLAMP_MISSING("cone-clamp-missing", Check.CONE),
    CONE_NEVER_SENT("cone-never-sent", Check.CONE),
    CONE_HARD_EDGE("cone-hard-edge", Check.CONE),
    SPOT_DIRECTION_WORLD("spot-direction-in-world-space", Check.SPOT_DIRECTION),
    SPOT_DIRECTION_LOCAL("spot-direction-in-local-space", Check.SPOT_DIRECTION),
    SPOT_DIRECTION_SIGN("spot-direction-sign", Check.SPOT_DIRECTION),
    SPECULAR_NOT_CONED("specular-not-limited-by-cone", Check.CONE_SPECULAR),

    // 4.3.4
    ATTENUATION_MISSING("attenuation-missing", Check.ATTENUATION_FORM),
    ATTENUATION_LINEAR("attenuation-linear", Check.ATTENUATION_FORM),
    ATTENUATION_ON_DIFFUSE_ONLY("attenuation-on-diffuse-only", Check.ATTENUATION_FORM),
    ATTENUATION_ONE_K("attenuation-one-k-for-all", Check.ATTENUATION_SPOT),
    ATTENUATION_LAST_K("attenuation-last-k-for-all", Check.ATTENUATION_POINT),
    ATTENUATION_OTHER_K("attenuation-other-k", Check.ATTENUATION_POINT),

    // 4.4
    EMISSION_MULTIPLIED("emission-multiplied", Check.EMISSION),
    EMISSION_COLOR_IGNORED("emission-colour-ignored", Check.EMISSION),
    EMISSION_COLOR_ADDED("emission-colour-added", Check.EMISSION),
    COLOR_ON_EVERYTHING("colour-on-everything", Check.EMISSION),
    EMISSION_MISSING("emission-missing", Check.EMISSION),
    COLOR_CONSTANT("colour-constant", Check.MOTORCYCLE_COLOR),
    LIGHT_COLOR_DIFFERS("light-colour-differs", Check.LIGHT_COLOR),

    // 4.5
    ORBIT_MISSING("orbit-missing", Check.ORBIT),
    ORBIT_OWN_AXIS("orbit-about-own-axis", Check.ORBIT_HORIZON),
    ORBIT_PIVOT("orbit-pivot-in-wrong-space", Check.ORBIT_PIVOT),
    MOUSE_FACTOR("mouse-factor", Check.ORBIT_FACTOR),
    MOUSE_JUMP("mouse-jump", Check.ORBIT_START),

    // 4.6
    MORE_LIGHTS_MISSING("more-lights-missing", Check.MORE_LIGHTS),
    MORE_LIGHTS_ALIKE("more-lights-alike", Check.MORE_LIGHTS),
    LATER_LIGHTS_FIRST_COSINE("later-lights-first-cosine", Check.MORE_LIGHTS_SHADING),
    LATER_LIGHTS_FIRST_COLOR("later-lights-first-colour", Check.MORE_LIGHTS_SHADING),

    // 4.7
    PHONG_LEFT("phong-left-in", Check.HALF_VECTOR),
    HALF_VECTOR_NOT_NORMALIZED("half-vector-not-normalized", Check.HALF_VECTOR),

    // Anywhere
    GAMMA_DIRECTION("gamma-wrong-direction", Check.MATERIAL),
    GLSL_DRIVER("glsl-only-some-drivers", Check.ORDER),
    SHADER_REFUSED("shader-refused", Check.ORDER),
    KOTLIN_REFUSED("kotlin-refused", Check.ORDER),
    UNKNOWN("unknown", Check.DIFFUSE),
}
