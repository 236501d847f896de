package cga.grading.study

import org.joml.Matrix3d
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d

/** Correct shaders in [scene], written in many ways. */
internal class VariantCases(private val scene: TestScene) {
    internal class Variant(
        val name: String,
        val vertex: String = CourseShaders.VERTEX,
        val fragment: String = CourseShaders.FRAGMENT,
        val lights: Int = 3,
        val sent: (Matrix4dc, Map<String, Any>) -> Map<String, Any> = { _, it -> it },
    )

    private fun String.all(vararg edits: Pair<String, String>) = edits.fold(this) { text, (old, new) -> text.edited(old, new) }

    /** The same shaders with every name of the submission's own replaced by one that says nothing. */
    private fun shuffled(
        source: String,
    ): String = NAMES.foldIndexed(source) { i, text, name -> text.replace(Regex("\\b$name\\b"), "q${(i * 7) % 31}x$i") }

    private fun shuffledName(name: String) = NAMES.indexOf(name).let { if (it < 0) name else "q${(it * 7) % 31}x$it" }

    val all: List<Variant> =
        listOf(
            Variant("as the course has it"),
            Variant("names shuffled", shuffled(CourseShaders.VERTEX), shuffled(CourseShaders.FRAGMENT), sent = {
                _,
                u,
                ->
                u.mapKeys { shuffledName(it.key) }
            }),
            // The motorcycle's tint has the 0.5 of the headlight's K_c, in a uniform whose name is more like that of its colour.
            Variant(
                "a colour that has one of the numbers of K",
                fragment = CourseShaders.FRAGMENT.edited(
                    "sceneColour",
                    "spotLightColoured",
                ),
                sent = {
                    _,
                    u,
                    ->
                    u.mapKeys { if (it.key == "sceneColour") "spotLightColoured" else it.key }
                },
            ),
            Variant(
                "lights sent in view space",
                CourseShaders.VERTEX.all(
                    "(view_matrix * vec4(pointLightPos, 1.0)).xyz" to "pointLightPos",
                    "(view_matrix * vec4(cornerLightPos, 1.0)).xyz" to "cornerLightPos",
                    "(view_matrix * vec4(spotLightPos, 1.0)).xyz" to "spotLightPos",
                ),
                sent = { _, u ->
                    u + mapOf(
                        "pointLightPos" to scene.viewed(scene.pointPosition),
                        "cornerLightPos" to scene.viewed(scene.cornerPosition),
                        "spotLightPos" to scene.viewed(scene.spotPosition),
                    )
                },
            ),
            Variant(
                "model-view composed on the CPU",
                CourseShaders.VERTEX.all("uniform mat4 model_matrix;" to "uniform mat4 mv;", "view_matrix * model_matrix" to "mv"),
                sent = { m, u -> u + ("mv" to Matrix4d(scene.view).mul(m)) },
            ),
            Variant(
                "normals by mat3 of the model-view",
                CourseShaders.VERTEX.all("(inverse(transpose(modelView)) * vec4(normal, 0.0)).xyz" to "mat3(modelView) * normal"),
            ),
            Variant(
                "a normal matrix sent",
                CourseShaders.VERTEX.all(
                    "(inverse(transpose(modelView)) * vec4(normal, 0.0)).xyz" to "nm * normal",
                    "uniform vec2 tcM" to "uniform mat3 nm; uniform vec2 tcM",
                ),
                sent = { m, u -> u + ("nm" to Matrix3d(Matrix4d(scene.view).mul(m)).invert().transpose()) },
            ),
            Variant(
                "cosines sent",
                fragment = CourseShaders.FRAGMENT.all("cos(spotInner)" to "spotInner", "cos(spotOuter)" to "spotOuter"),
                sent = { _, u -> u + mapOf("spotInner" to Math.cos(scene.inner), "spotOuter" to Math.cos(scene.outer)) },
            ),
            Variant(
                "degrees turned in the shader",
                fragment = CourseShaders.FRAGMENT.all(
                    "cos(spotInner)" to "cos(radians(spotInner))",
                    "cos(spotOuter)" to "cos(radians(spotOuter))",
                ),
                sent = { _, u -> u + mapOf("spotInner" to 12.5, "spotOuter" to 25.0) },
            ),
            Variant(
                "the other sign of the direction",
                fragment = CourseShaders.FRAGMENT.all("dot(-l, normalize(spotLightDirection))" to "dot(l, normalize(spotLightDirection))"),
                sent = { _, u -> u + ("spotLightDirection" to scene.viewedDirection(scene.spotDirection).negate()) },
            ),
            Variant(
                "direction to view space in the shader",
                fragment = CourseShaders.FRAGMENT.all(
                    "normalize(spotLightDirection)" to "normalize(mat3(view_matrix) * spotLightDirection)",
                    "out vec4" to "uniform mat4 view_matrix; out vec4",
                ),
                sent = { _, u -> u + ("spotLightDirection" to scene.spotDirection) },
            ),
            Variant(
                "specular gated by n·l",
                fragment = CourseShaders.FRAGMENT.all(
                    "specular * pow(cosBeta, shininess)" to "(cosAlpha > 0.0 ? specular * pow(cosBeta, shininess) : vec3(0.0))",
                ),
            ),
            Variant(
                "the exponent in a vector",
                fragment = CourseShaders.FRAGMENT.all("uniform float shininess" to "uniform vec3 surface", "shininess)" to "surface.z)"),
                sent = { _, u -> u + ("surface" to Vector3d(1.0, 2.0, 60.0)) },
            ),
            Variant(
                "ambient light",
                fragment = CourseShaders.FRAGMENT.all("vec3 result = emission" to "vec3 result = emission + diffuse * vec3(0.05)"),
            ),
            Variant(
                "ambient of every light",
                fragment = CourseShaders.FRAGMENT.all("diffuse * cosAlpha +" to "diffuse * (0.1 + cosAlpha) +"),
            ),
            Variant(
                "attenuation on the colour",
                fragment = CourseShaders.FRAGMENT.all(
                    "shade(n, lp, v, diffuse, specular) * pointLightColor * attenuate(dp, pointLightAttenuation)" to
                        "shade(n, lp, v, diffuse, specular) * (pointLightColor * attenuate(dp, pointLightAttenuation))",
                ),
            ),
            Variant(
                "toLight in the fragment shader",
                CourseShaders.VERTEX.all(
                    "vertexData.toPointLight = (view_matrix * vec4(pointLightPos, 1.0)).xyz - pos.xyz" to
                        "vertexData.toPointLight = pos.xyz",
                ),
                CourseShaders.FRAGMENT.all(
                    "normalize(vertexData.toPointLight)" to "normalize(pl)",
                    "length(vertexData.toPointLight)" to "length(pl)",
                    "vec3 n = normalize(" to
                        "vec3 pl = (view_matrix * vec4(pointLightPos, 1.0)).xyz - vertexData.toPointLight; vec3 n = normalize(",
                    "out vec4" to "uniform mat4 view_matrix; uniform vec3 pointLightPos; out vec4",
                ),
            ),
            Variant("clamped at the end", fragment = CourseShaders.FRAGMENT.all("vec4(result" to "vec4(clamp(result, 0.0, 1.0)")),
            Variant(
                "gamma",
                fragment = CourseShaders.FRAGMENT.all("vec4(result" to "vec4(pow(result, vec3(1.0 / 2.2))"),
            ),
            Variant(
                "fog with a beginning and an end",
                fragment = CourseShaders.FRAGMENT.all(
                    "vec4(result" to "vec4(mix(result, fogColor, clamp((length(vertexData.toCamera) - fog.x) / (fog.y - fog.x), 0.0, 1.0))",
                    "out vec4" to "uniform vec2 fog; uniform vec3 fogColor; out vec4",
                ),
                sent = { _, u -> u + mapOf("fog" to floatArrayOf(3f, 60f), "fogColor" to Vector3d(0.2, 0.3, 0.5)) },
            ),
            Variant(
                "exponential fog by depth, under a gamma",
                fragment = CourseShaders.FRAGMENT.all(
                    "vec4(result" to
                        "vec4(pow(mix(vec3(0.1, 0.0, 0.2), result, exp(-0.04 * abs(vertexData.toCamera.z))), vec3(1.0 / 2.2))",
                ),
            ),
            Variant(
                "an intensity beside the colour",
                fragment = CourseShaders.FRAGMENT.all(
                    "* spotLightColor" to "* spotLightColor * power",
                    "out vec4" to "uniform float power; out vec4",
                ),
                sent = { _, u -> u + mapOf("power" to 2.5) },
            ),
            Variant(
                "all lighting in world space",
                CourseShaders.VERTEX.all(
                    "vertexData.normal = (inverse(transpose(modelView))" to
                        "vec4 w = model_matrix * vec4(position, 1.0); vertexData.normal = (inverse(transpose(model_matrix))",
                    "toCamera = -pos.xyz" to "toCamera = inverse(view_matrix)[3].xyz - w.xyz",
                    "(view_matrix * vec4(pointLightPos, 1.0)).xyz - pos.xyz" to "pointLightPos - w.xyz",
                    "(view_matrix * vec4(cornerLightPos, 1.0)).xyz - pos.xyz" to "cornerLightPos - w.xyz",
                    "(view_matrix * vec4(spotLightPos, 1.0)).xyz - pos.xyz" to "spotLightPos - w.xyz",
                ),
                sent = { _, u -> u + ("spotLightDirection" to scene.spotDirection) },
            ),
            Variant(
                "all constants in the shader",
                CourseShaders.VERTEX.all(
                    "uniform vec3 pointLightPos;" to "const vec3 pointLightPos = vec3(${scene.pointPosition.glsl()});",
                    "uniform vec3 cornerLightPos;" to "const vec3 cornerLightPos = vec3(${scene.cornerPosition.glsl()});",
                    "uniform vec3 spotLightPos;" to "const vec3 spotLightPos = vec3(${scene.spotPosition.glsl()});",
                ),
                CourseShaders.FRAGMENT.all(
                    "uniform vec3 pointLightColor;" to "const vec3 pointLightColor = vec3(0.9, 0.4, 0.7);",
                    "uniform vec3 pointLightAttenuation;" to "const vec3 pointLightAttenuation = vec3(1.0, 0.5, 0.1);",
                    "uniform vec3 cornerLightColor;" to "const vec3 cornerLightColor = vec3(3, 0, 1);",
                    "uniform vec3 cornerLightAttenuation;" to "#define cornerLightAttenuation vec3(1.0, 0.5, 0.1)",
                    "uniform vec3 spotLightColor;" to "const vec3 spotLightColor = vec3(2.0, 2.0, 1.8);",
                    "uniform vec3 spotLightAttenuation;" to "const vec3 spotLightAttenuation = vec3(0.5, 0.05, 0.01);",
                    "uniform float spotInner;" to "const float spotInner = radians(12.5);",
                    "uniform float spotOuter;" to "const float spotOuter = radians(25.0);",
                ),
            ),
        )

    private fun Vector3d.glsl() = "${x.toFloat()}, ${y.toFloat()}, ${z.toFloat()}"

    private companion object {
        val NAMES =
            listOf(
                "model_matrix", "view_matrix", "projection_matrix", "tcMultiplier", "pointLightPos", "cornerLightPos",
                "spotLightPos", "emit", "diff", "spec", "shininess", "sceneColour", "pointLightColor",
                "pointLightAttenuation", "cornerLightColor", "cornerLightAttenuation", "spotLightColor",
                "spotLightAttenuation", "spotLightDirection", "spotInner", "spotOuter", "vertexData", "toCamera",
                "toPointLight", "toCornerLight", "toSpotLight",
            )
    }
}
