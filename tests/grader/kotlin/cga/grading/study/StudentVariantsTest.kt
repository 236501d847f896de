package cga.grading.study

import cga.testing.Offscreen
import cga.testing.Slow
import cga.testing.assertNear
import org.joml.Matrix4d
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.TestFactory
import org.junit.jupiter.api.extension.ExtendWith

/** Correct shaders as students write them who do not follow the sheet's wording: none of this is a mistake. */
@ExtendWith(Offscreen::class)
@Slow
class StudentVariantsTest {
    private val scene = TestScene()

    private class Variant(
        val name: String,
        val vertex: String = CourseShaders.VERTEX,
        val fragment: String = CourseShaders.FRAGMENT,
        val sent: Map<String, Any> = emptyMap(),
    )

    private fun String.all(vararg edits: Pair<String, String>) = edits.fold(this) { text, (old, new) -> text.edited(old, new) }

    private fun fragment(
        name: String,
        vararg edits: Pair<String, String>,
        sent: Map<String, Any> = emptyMap(),
    ) = Variant(name, fragment = CourseShaders.FRAGMENT.all(*edits), sent = sent)

    private val variants =
        listOf(
            fragment(
                "nothing at all from behind, by an early return",
                "vec3 h = normalize(l + v);" to "if (cosAlpha <= 0.0) return vec3(0.0);\nvec3 h = normalize(l + v);",
            ),
            fragment(
                "colour and constants times two",
                sent = mapOf("spotLightColor" to Vector3d(4.0, 4.0, 3.6), "spotLightAttenuation" to Vector3d(1.0, 0.1, 0.02)),
            ),
            fragment(
                "nothing beyond a step",
                "return clamp((theta - outer) / (inner - outer), 0.0, 1.0);" to
                    "return step(outer, theta) * min((theta - outer) / (inner - outer), 1.0);",
            ),
            fragment(
                "the cone by questions",
                "return clamp((theta - outer) / (inner - outer), 0.0, 1.0);" to
                    "return theta > inner ? 1.0 : theta < outer ? 0.0 : (theta - outer) / (inner - outer);",
            ),
            fragment(
                "a whole number as the exponent",
                "uniform float shininess" to "uniform int shininess",
                sent = mapOf("shininess" to 60),
            ),
            fragment(
                "attenuation as three numbers",
                "float attenuate(float d, vec3 k) {\n    return 1.0 / (k.x + k.y * d + k.z * d * d);" to
                    "vec3 attenuate(float d, vec3 k) {\n    return vec3(1.0) / dot(k, vec3(1.0, d, d * d));",
            ),
            fragment(
                "holes in the picture",
                "vec3 result = emission;" to "if (texture(diff, vertexData.texCoord).a < 0.1) discard;\nvec3 result = emission;",
            ),
            fragment(
                "a colour sent as three numbers",
                "uniform vec3 pointLightColor;" to "uniform float lightR; uniform float lightG; uniform float lightB;",
                "* pointLightColor" to "* vec3(lightR, lightG, lightB)",
                sent = mapOf("lightR" to 0.9, "lightG" to 0.4, "lightB" to 0.7),
            ),
            fragment(
                "a colour computed from the time",
                "uniform vec3 pointLightColor;" to "uniform float t;",
                "vec3 result = emission;" to "vec3 result = emission; vec3 pointLightColor = abs(sin(t * vec3(1.0, 0.5, 0.25)));",
                sent = mapOf("t" to 1.2),
            ),
            fragment(
                "all colours as three numbers",
                "uniform vec3 pointLightColor;" to "uniform float c[9];",
                "uniform vec3 cornerLightColor;" to "",
                "uniform vec3 spotLightColor;" to "",
                "* pointLightColor" to "* vec3(c[0], c[1], c[2])",
                "* cornerLightColor" to "* vec3(c[3], c[4], c[5])",
                "* spotLightColor" to "* vec3(c[6], c[7], c[8])",
                sent = listOf(0.9, 0.4, 0.7, 3.0, 0.2, 1.0, 2.0, 2.0, 1.8).withIndex().associate { "c[${it.index}]" to it.value },
            ),
            Variant(
                "lights sent by their matrices",
                CourseShaders.VERTEX.all(
                    "uniform vec3 pointLightPos;" to "uniform mat4 pointLightMatrix;",
                    "vec4(pointLightPos, 1.0)" to "vec4(pointLightMatrix[3].xyz, 1.0)",
                    "uniform vec3 spotLightPos;" to "uniform mat4 spotLightMatrix;",
                    "view_matrix * vec4(spotLightPos, 1.0)" to "view_matrix * spotLightMatrix * vec4(0.0, 0.0, 0.0, 1.0)",
                ),
                sent =
                    mapOf(
                        "pointLightMatrix" to Matrix4d().translation(scene.pointPosition).rotateY(0.3),
                        "spotLightMatrix" to Matrix4d().translation(scene.spotPosition),
                    ),
            ),
            Variant(
                "the direction turned by the inverse of the inverse, and longer than 1",
                fragment =
                    CourseShaders.FRAGMENT.all(
                        "normalize(spotLightDirection)" to "normalize(mat3(transpose(inverse(view_matrix))) * spotLightDirection)",
                        "out vec4" to "uniform mat4 view_matrix; out vec4",
                    ),
                sent = mapOf("spotLightDirection" to Vector3d(scene.spotDirection).mul(2.5)),
            ),
            Variant(
                "vectors to lights in an array",
                CourseShaders.VERTEX.all(
                    "vec3 toPointLight;\n    vec3 toCornerLight;\n    vec3 toSpotLight;" to "vec3 toLight[3];",
                    "toPointLight =" to "toLight[0] =",
                    "toCornerLight =" to "toLight[1] =",
                    "toSpotLight =" to "toLight[2] =",
                ),
                CourseShaders.FRAGMENT.all(
                    "vec3 toPointLight;\n    vec3 toCornerLight;\n    vec3 toSpotLight;" to "vec3 toLight[3];",
                    "vertexData.toPointLight" to "vertexData.toLight[0]",
                    "vertexData.toCornerLight" to "vertexData.toLight[1]",
                    "vertexData.toSpotLight" to "vertexData.toLight[2]",
                ),
            ),
            Variant(
                "the normal in four numbers",
                CourseShaders.VERTEX.all(
                    "vec3 normal;\n    vec2 texCoord" to "vec4 normal;\n    vec2 texCoord",
                    "(inverse(transpose(modelView)) * vec4(normal, 0.0)).xyz" to "inverse(transpose(modelView)) * vec4(normal, 0.0)",
                ),
                CourseShaders.FRAGMENT.all(
                    "vec3 normal;\n    vec2 texCoord" to "vec4 normal;\n    vec2 texCoord",
                    "normalize(vertexData.normal)" to "normalize(vertexData.normal.xyz)",
                ),
            ),
            fragment(
                "gamma switched off",
                "out vec4" to "uniform float gamma; out vec4",
                "vec4(result" to "vec4(gamma > 0.0 ? pow(result, vec3(1.0 / gamma)) : result",
                sent = mapOf("gamma" to 0.0),
            ),
        )

    @TestFactory
    fun `a correct shader has no mistake and its lights are found`(): List<DynamicTest> =
        variants.map { dynamicTest(it.name) { check(it) } }

    private fun check(variant: Variant) {
        val capture = SceneCapture.of(variant.vertex, variant.fragment, scene) { scene.uniforms(it) + variant.sent }
        ShaderStudy.of(capture).use { study ->
            assertEquals("", study.notes.joinToString("\n"))
            assertEquals("", study.mistakes.joinToString("\n") { "${it.mistake} at ${it.where}: ${it.fit}, ${it.difference}" })
            // As in VariantsTest: the roundings of a highlight.
            for (check in study.checks) assertTrue((check.error ?: 0.0) < 2e-3) { "${check.check}: ${check.error} ${check.text}" }
            val lights = study.observe(capture.frames[0])?.lights ?: error("nothing was observed")
            assertEquals(3, lights.size)
            for (place in listOf(scene.pointPosition, scene.cornerPosition, scene.spotPosition)) {
                assertTrue(lights.any { it.position.distance(scene.viewed(place)) < 1e-3 }) { "no light at $place" }
            }
            val spot = lights.single { it.spot != null }
            assertNear(Vector3d(2.0, 2.0, 1.8), spot.color, 1e-3, "colour")
            assertNear(Vector3d(0.5, 0.05, 0.01), spot.k, 1e-4, "K")
            assertNear(scene.viewedDirection(scene.spotDirection), spot.spot?.direction ?: error("no cone"), 1e-4, "direction")
        }
    }
}
