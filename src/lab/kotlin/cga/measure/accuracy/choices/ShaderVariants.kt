package cga.measure.accuracy.choices

import cga.measure.accuracy.choices.EditedHome.Companion.FRAGMENT
import cga.measure.accuracy.choices.EditedHome.Companion.LIGHTING
import cga.measure.accuracy.choices.EditedHome.Companion.VERTEX
import kotlin.math.sin

/** The shaders written in other ways, as edits of the scene's own. */
internal object ShaderVariants {
    /** All textures at their largest level: no choice of mip levels, which OpenGL leaves to the driver. */
    val firstLevel: List<ShaderEdit> =
        listOf(
            ShaderEdit(FRAGMENT, "= texture(material.", "= textureLod(material."),
            ShaderEdit(FRAGMENT, ", surfaceTexCoord).rgb", ", surfaceTexCoord, 0.0).rgb"),
        )

    /** A plain grey surface without emission in the place of all textures, so that what is left is the error of the lighting. */
    val plain: List<ShaderEdit> =
        listOf("emissive" to 0, "diffuse" to Truth.GREY, "specular" to Truth.GREY).map { (texture, value) ->
            ShaderEdit(FRAGMENT, "texture(material.$texture, surfaceTexCoord).rgb", "vec3($value.0 / 255.0)")
        }

    /** The vectors to the lights from the position of the fragment, instead of one interpolated vector for each light. */
    val toLightPerFragment: List<ShaderEdit> =
        listOf(
            ShaderEdit(VERTEX, "out vec3 toLightView", "vec3 toLightView"),
            ShaderEdit(FRAGMENT, "toLightView[i]", "(light[i].position + toCameraView)"),
        )

    /** As courses write it: cosines of the angles, sent as floats. */
    val cosines: List<ShaderEdit> =
        listOf(
            ShaderEdit(
                LIGHTING,
                """
                |    vec3 chord = fromLight - direction;
                |    float versine = 0.5 * dot(chord, chord);
                |    float width = cone.y - cone.x;
                |    if (width > 0.0) return clamp((cone.y - versine) / width, 0.0, 1.0);
                |    return versine <= cone.y ? 1.0 : 0.0;
                """.trimMargin(),
                """
                |    vec2 cosines = 1.0 - cone;
                |    return clamp((dot(fromLight, direction) - cosines.y) / (cosines.x - cosines.y), 0.0, 1.0);
                """.trimMargin(),
            ),
        )

    /** A cone of other angles than the scene's; a point light's stays. */
    fun cone(cone: Cone): List<ShaderEdit> =
        listOf(
            ShaderEdit(
                FRAGMENT,
                "light[i].cone)",
                "light[i].cone.x > 2.0 ? light[i].cone : vec2(${versine(cone.inner)}, ${versine(cone.outer)}))",
            ),
        )

    /** Per-vertex lighting (Gouraud 1971): both sums over the lights are computed at the vertices and interpolated. */
    fun lightPerVertex(): List<ShaderEdit> =
        listOf(
            ShaderEdit(VERTEX, "\nvoid main() {\n", "$VERTEX_DECLARATIONS\nvoid main() {\n"),
            ShaderEdit(VERTEX, "    gl_Position =", "$VERTEX_SUMS\n    gl_Position ="),
            ShaderEdit(FRAGMENT, "\nvoid main() {\n", "\nin vec3 diffuseLight;\nin vec3 specularLight;\n\nvoid main() {\n"),
            ShaderEdit(FRAGMENT, "i < LIGHTS", "i < 0"),
            ShaderEdit(FRAGMENT, "    fragColor =", "    color += diffuse * diffuseLight + specular * specularLight;\n    fragColor ="),
        )

    /** 1 − cos of degrees, as SpotLight computes it, as the float that it sends. */
    private fun versine(degrees: Double): Float = (2 * sin(Math.toRadians(degrees) / 2).let { it * it }).toFloat()

    private val VERTEX_DECLARATIONS =
        """

        #include "material.glsl"
        #include "lighting.glsl"
        out vec3 diffuseLight;
        out vec3 specularLight;
        """.trimIndent()

    private val VERTEX_SUMS =
        """
        vec3 n = normalizeOrZero(inRange(normalView));
        vec3 toCamera = normalizeOrZero(toCameraView);
        diffuseLight = vec3(0.0);
        specularLight = vec3(0.0);
        for (int i = 0; i < LIGHTS; i++) {
            vec3 l = normalizeOrZero(toLightView[i]);
            vec3 incident = attenuationFactor(toLightView[i], light[i].attenuation) * light[i].color
                * coneIntensity(-l, light[i].direction, light[i].cone);
            diffuseLight += diffuseFactor(n, l) * incident;
            specularLight += specularFactor(n, l, toCamera) * incident;
        }
        """.trimIndent().prependIndent("    ")
}

/** A cone by its angles from the axis, degrees. */
internal data class Cone(
    val inner: Double,
    val outer: Double,
)
