package cga.grading.study

import cga.grading.findings.Mistake
import org.joml.Matrix4dc
import org.joml.Vector3d
import kotlin.math.cos

/** Shaders with mistakes in [scene], each with the mistakes to be named. */
internal class MistakeCases(private val scene: TestScene) {
    internal class Case(
        val name: String,
        val expected: Set<Mistake>,
        val vertex: String = CourseShaders.VERTEX,
        val fragment: String = CourseShaders.FRAGMENT,
        val sent: (Matrix4dc, Map<String, Any>) -> Map<String, Any> = { _, it -> it },
    )

    private fun vertex(
        mistake: Mistake,
        name: String,
        old: String,
        new: String,
    ) = Case(name, setOf(mistake), vertex = CourseShaders.VERTEX.edited(old, new))

    private fun fragment(
        mistake: Mistake?,
        name: String,
        vararg edits: Pair<String, String>,
    ) = Case(name, setOfNotNull(mistake), fragment = edits.fold(CourseShaders.FRAGMENT) { text, (old, new) -> text.edited(old, new) })

    private fun values(
        mistake: Mistake?,
        name: String,
        vararg replaced: Pair<String, Any>,
    ) = Case(name, setOfNotNull(mistake), sent = { _, it -> it + replaced })

    /** A direction of another length, which nobody normalises. */
    private fun axis(
        name: String,
        length: Double,
        inner: Double,
        outer: Double,
    ) = Case(
        name,
        setOf(Mistake.UNKNOWN),
        fragment = CourseShaders.FRAGMENT.edited("normalize(spotLightDirection)", "spotLightDirection"),
        sent = { _, it ->
            it + mapOf(
                "spotLightDirection" to scene.viewedDirection(scene.spotDirection).mul(length),
                "spotInner" to Math.toRadians(inner),
                "spotOuter" to Math.toRadians(outer),
            )
        },
    )

    /** Cosines of degrees, sent to a shader that compares cosines. */
    private fun degrees(
        name: String,
        inner: Double,
        outer: Double,
    ) = Case(
        name,
        setOf(Mistake.DEGREES_FOR_RADIANS),
        fragment = CourseShaders.FRAGMENT.edited("cos(spotInner)", "spotInner").edited("cos(spotOuter)", "spotOuter"),
        sent = { _, it -> it + mapOf("spotInner" to cos(inner), "spotOuter" to cos(outer)) },
    )

    val all: List<Case> =
        listOf(
            fragment(Mistake.UNKNOWN, "highlights in the diffuse colour", "texture(spec," to "texture(diff,"),
            fragment(
                Mistake.UNKNOWN,
                "highlights without a texture",
                "vec3 specular = texture(spec, vertexData.texCoord).rgb" to "vec3 specular = vec3(0.5)",
            ),
            fragment(Mistake.UNKNOWN, "the headlight a second time without its cone", "* cone(ls);" to "* (1.0 + cone(ls));"),
            fragment(
                Mistake.ATTENUATION_LINEAR,
                "a distance that is not squared, in a fog",
                "k.z * d * d" to "k.z * d",
                "vec4(result, 1.0)" to "vec4(mix(vec3(0.4), result, exp(-0.05 * length(vertexData.toCamera))), 1.0)",
            ),
            fragment(
                Mistake.UNKNOWN,
                "the emission times the diffuse texture",
                "result = emission;" to "result = emission * diffuse;",
            ),
            fragment(
                Mistake.UNKNOWN,
                "the emission added after the gamma",
                "result = emission;" to "result = vec3(0.0);",
                "vec4(result, 1.0)" to "vec4(pow(result, vec3(1.0 / 2.2)) + emission, 1.0)",
            ),
            fragment(
                Mistake.UNKNOWN,
                "a texture decoded twice, under a gamma",
                "diffuse * cosAlpha" to "pow(diffuse, vec3(4.84)) * cosAlpha",
                "vec4(result, 1.0)" to "vec4(pow(result, vec3(1.0 / 2.2)), 1.0)",
            ),
            fragment(
                Mistake.UNKNOWN,
                "the headlight with the point light's factor",
                "attenuate(ds, spotLightAttenuation)" to "attenuate(dp, pointLightAttenuation)",
            ),
            fragment(
                Mistake.TO_LIGHT_WORLD,
                "the distance from a place in the world to a point in view space",
                "attenuate(dp," to "attenuate(distance(pointLightPos, -vertexData.toCamera),",
                "out vec4" to "uniform vec3 pointLightPos; out vec4",
            ),
            vertex(
                Mistake.NORMAL_MATRIX,
                "normals by model and view in the wrong order",
                "inverse(transpose(modelView))",
                "inverse(transpose(model_matrix * view_matrix))",
            ),
            fragment(
                Mistake.CONE_CLAMP_MISSING,
                "a cone that takes light away, under a gamma",
                "clamp((theta - outer) / (inner - outer), 0.0, 1.0)" to "min((theta - outer) / (inner - outer), 1.0)",
                "vec4(result, 1.0)" to "vec4(pow(result, vec3(1.0 / 2.2)), 1.0)",
            ),
            fragment(
                Mistake.COSINE_OF_COSINE,
                "the cosine of the cosine between axis and light",
                "dot(-l, normalize(spotLightDirection))" to "cos(dot(-l, normalize(spotLightDirection)))",
            ),
            fragment(
                Mistake.DEGREES_FOR_RADIANS,
                "radians made of radians",
                "cos(spotInner)" to "cos(radians(spotInner))",
                "cos(spotOuter)" to "cos(radians(spotOuter))",
            ),
            fragment(Mistake.VIEW_VECTOR_SIGN, "view vector sign", "normalize(vertexData.toCamera)" to "normalize(-vertexData.toCamera)"),
            vertex(Mistake.VIEW_VECTOR_SIGN, "view vector sign in the vertex shader", "toCamera = -pos.xyz", "toCamera = pos.xyz"),
            vertex(
                Mistake.NORMALIZED_IN_VERTEX_SHADER,
                "toLight normalised in the vertex shader",
                "(view_matrix * vec4(pointLightPos, 1.0)).xyz - pos.xyz",
                "normalize((view_matrix * vec4(pointLightPos, 1.0)).xyz - pos.xyz)",
            ),
            vertex(Mistake.NORMALIZED_IN_VERTEX_SHADER, "toCamera normalised in the vertex shader", "-pos.xyz;", "normalize(-pos.xyz);"),
            fragment(Mistake.NORMAL_NOT_RENORMALIZED, "normal not renormalised", "normalize(vertexData.normal)" to "vertexData.normal"),
            vertex(
                Mistake.NORMAL_MATRIX,
                "normals by the model matrix",
                "(inverse(transpose(modelView)) * vec4(normal, 0.0)).xyz",
                "mat3(model_matrix) * normal",
            ),
            vertex(Mistake.NORMAL_MATRIX, "normals untransformed", "(inverse(transpose(modelView)) * vec4(normal, 0.0)).xyz", "normal"),
            vertex(Mistake.NORMAL_MATRIX, "normals by the view matrix only", "inverse(transpose(modelView))", "view_matrix"),
            vertex(
                Mistake.NORMAL_MATRIX,
                "normals moved with the model",
                "inverse(transpose(modelView)) * vec4(normal, 0.0)",
                "modelView * vec4(normal, 1.0)",
            ),
            vertex(Mistake.NORMAL_MATRIX, "normals by the inverse", "inverse(transpose(modelView))", "inverse(modelView)"),
            vertex(
                Mistake.NORMAL_MATRIX,
                "normals by the model's inverse and the view",
                "inverse(transpose(modelView))",
                "view_matrix * inverse(model_matrix)",
            ),
            fragment(
                Mistake.UNKNOWN,
                "a cone to the front and one to the back",
                "dot(-l, normalize(spotLightDirection))" to "abs(dot(-l, normalize(spotLightDirection)))",
            ),
            fragment(
                Mistake.UNKNOWN,
                "a highlight of the angle between half vector and view",
                "max(dot(n, h), 0.0)" to "max(dot(v, h), 0.0)",
            ),
            vertex(
                Mistake.TO_LIGHT_WORLD,
                "toLight in world space",
                "(view_matrix * vec4(pointLightPos, 1.0)).xyz - pos.xyz",
                "pointLightPos - (model_matrix * vec4(position, 1.0)).xyz",
            ),
            vertex(Mistake.TO_LIGHT_WORLD, "lights through the model matrix", "(view_matrix * vec4(", "(model_matrix * vec4("),
            vertex(Mistake.TO_LIGHT_WORLD, "lights through model and view", "(view_matrix * vec4(", "(modelView * vec4("),
            Case(
                "normals in view space, all else in world space",
                setOf(Mistake.NORMAL_MATRIX),
                vertex =
                    CourseShaders.VERTEX
                        .edited("pos = modelView *", "pos = model_matrix *")
                        .edited("projection_matrix * pos", "projection_matrix * view_matrix * pos")
                        .edited("-pos.xyz;", "inverse(view_matrix)[3].xyz - pos.xyz;")
                        .edited("(view_matrix * vec4(", "(vec4("),
                sent = { _, it -> it + ("spotLightDirection" to scene.spotDirection) },
            ),
            vertex(Mistake.TO_LIGHT_WORLD, "lights through the view twice", "(view_matrix * vec4(", "(view_matrix * view_matrix * vec4("),
            vertex(Mistake.TO_LIGHT_WORLD, "lights through the camera's matrix", "(view_matrix * vec4(", "(inverse(view_matrix) * vec4("),
            fragment(Mistake.CLAMP_MISSING, "diffuse clamp missing", "max(dot(n, l), 0.0)" to "dot(n, l)"),
            fragment(Mistake.SPECULAR_CLAMP_MISSING, "specular clamp missing", "max(dot(n, h), 0.0)" to "dot(n, h)"),
            fragment(Mistake.EXPONENT_FIXED, "exponent fixed", "pow(cosBeta, shininess)" to "pow(cosBeta, 32.0)"),
            Case(
                "the exponent at the diffuse cosine",
                setOf(Mistake.EXPONENT_FIXED, Mistake.UNKNOWN),
                fragment = CourseShaders.FRAGMENT.edited(
                    "diffuse * cosAlpha + specular * pow(cosBeta, shininess)",
                    "diffuse * pow(cosAlpha, shininess) + specular * cosBeta",
                ),
            ),
            fragment(Mistake.SPECULAR_MISSING, "specular missing", " + specular * pow(cosBeta, shininess)" to ""),
            fragment(Mistake.DIFFUSE_MISSING, "diffuse missing", "diffuse * cosAlpha + " to ""),
            fragment(
                Mistake.MAPS_SWAPPED,
                "maps swapped",
                "texture(diff," to "texture(spec,",
                "specular = texture(spec," to "specular = texture(diff,",
            ),
            fragment(
                Mistake.MAPS_SWAPPED,
                "emission and diffuse map swapped",
                "texture(emit," to "texture(diff,",
                "diffuse = texture(diff," to "diffuse = texture(emit,",
            ),
            fragment(
                Mistake.MAPS_SWAPPED,
                "all three maps at the next one's place",
                "texture(emit," to "texture(first,",
                "texture(diff," to "texture(spec,",
                "specular = texture(spec," to "specular = texture(emit,",
                "texture(first," to "texture(diff,",
            ),
            values(Mistake.SAMPLER_UNIT, "sampler left at unit 0", "spec" to 0),
            fragment(
                Mistake.CONE_INSIDE_OUT,
                "cone by the sheet's letters",
                "(theta - outer) / (inner - outer)" to "(theta - inner) / (outer - inner)",
            ),
            values(Mistake.CONE_INSIDE_OUT, "inner and outer swapped", "spotInner" to scene.outer, "spotOuter" to scene.inner),
            values(
                Mistake.COSINE_OF_COSINE,
                "cosines sent as angles",
                "spotInner" to Math.cos(scene.inner),
                "spotOuter" to Math.cos(scene.outer),
            ),
            fragment(
                Mistake.COSINE_OF_COSINE,
                "cosine twice",
                "cos(spotInner)" to "cos(cos(spotInner))",
                "cos(spotOuter)" to "cos(cos(spotOuter))",
            ),
            fragment(
                Mistake.COSINE_OF_COSINE,
                "cosines written into the shader as angles",
                "cos(spotInner)" to "cos(cos(radians(12.0)))",
                "cos(spotOuter)" to "cos(cos(radians(25.0)))",
            ),
            fragment(
                Mistake.UNKNOWN,
                "a cone by smoothstep",
                "clamp((theta - outer) / (inner - outer), 0.0, 1.0)" to "smoothstep(outer, inner, theta)",
            ),
            values(Mistake.DEGREES_FOR_RADIANS, "degrees sent", "spotInner" to 12.5, "spotOuter" to 25.0),
            values(Mistake.DEGREES_FOR_RADIANS, "other degrees sent", "spotInner" to 20.0, "spotOuter" to 30.0),
            fragment(
                Mistake.DEGREES_FOR_RADIANS,
                "degrees written into the shader",
                "cos(spotInner)" to "cos(15.0)",
                "cos(spotOuter)" to "cos(30.0)",
            ),
            fragment(
                Mistake.CONE_CLAMP_MISSING,
                "cone clamp missing",
                "clamp((theta - outer) / (inner - outer), 0.0, 1.0)" to "(theta - outer) / (inner - outer)",
            ),
            fragment(
                Mistake.CONE_CLAMP_MISSING,
                "cone clamped below only",
                "clamp((theta - outer) / (inner - outer), 0.0, 1.0)" to "max((theta - outer) / (inner - outer), 0.0)",
            ),
            fragment(
                Mistake.CONE_CLAMP_MISSING,
                "cone clamped above only",
                "clamp((theta - outer) / (inner - outer), 0.0, 1.0)" to "min((theta - outer) / (inner - outer), 1.0)",
            ),
            fragment(
                Mistake.CONE_HARD_EDGE,
                "cone with a hard edge",
                "clamp((theta - outer) / (inner - outer), 0.0, 1.0)" to "theta > outer ? 1.0 : 0.0",
            ),
            fragment(
                Mistake.SPECULAR_NOT_CONED,
                "specular not limited by the cone",
                "shade(n, ls, v, diffuse, specular) * spotLightColor * attenuate(ds, spotLightAttenuation) * cone(ls)" to
                    "(shade(n, ls, v, diffuse, vec3(0)) * cone(ls) + shade(n, ls, v, vec3(0), specular)) * spotLightColor * attenuate(ds, spotLightAttenuation)",
            ),
            fragment(Mistake.ATTENUATION_MISSING, "attenuation missing", "return 1.0 / (k.x + k.y * d + k.z * d * d)" to "return 1.0"),
            fragment(Mistake.ATTENUATION_LINEAR, "attenuation linear", " + k.z * d * d" to ""),
            fragment(
                Mistake.ATTENUATION_ON_DIFFUSE_ONLY,
                "attenuation on diffuse only",
                "vec3 shade(vec3 n, vec3 l, vec3 v, vec3 diffuse, vec3 specular)" to
                    "vec3 shade(vec3 n, vec3 l, vec3 v, vec3 diffuse, vec3 specular, float f)",
                "diffuse * cosAlpha" to "f * diffuse * cosAlpha",
                "shade(n, lp, v, diffuse, specular) * pointLightColor * attenuate(dp, pointLightAttenuation)" to
                    "shade(n, lp, v, diffuse, specular, attenuate(dp, pointLightAttenuation)) * pointLightColor",
                "shade(n, lc, v, diffuse, specular) * cornerLightColor * attenuate(dc, cornerLightAttenuation)" to
                    "shade(n, lc, v, diffuse, specular, attenuate(dc, cornerLightAttenuation)) * cornerLightColor",
                "shade(n, ls, v, diffuse, specular) * spotLightColor * attenuate(ds, spotLightAttenuation)" to
                    "shade(n, ls, v, diffuse, specular, attenuate(ds, spotLightAttenuation)) * spotLightColor",
            ),
            fragment(
                Mistake.EMISSION_MULTIPLIED,
                "emission multiplied",
                "color = vec4(result" to "color = vec4((result - emission) * emission",
            ),
            fragment(
                Mistake.EMISSION_MULTIPLIED,
                "emission in the light's bracket",
                "vec3 result = emission" to "vec3 result = vec3(0.0)",
                "shade(n, lp, v, diffuse, specular) *" to "(emission + shade(n, lp, v, diffuse, specular)) *",
                "shade(n, lc, v, diffuse, specular) *" to "(emission + shade(n, lc, v, diffuse, specular)) *",
                "shade(n, ls, v, diffuse, specular) *" to "(emission + shade(n, ls, v, diffuse, specular)) *",
            ),
            fragment(
                Mistake.EMISSION_MULTIPLIED,
                "emission beside the diffuse texture",
                "vec3 result = emission" to "diffuse += emission; vec3 result = vec3(0.0)",
            ),
            fragment(
                Mistake.NORMAL_NOT_RENORMALIZED,
                "normals as they come, stretched by the model's scale, in cosines that are cut off at 1",
                "normalize(vertexData.normal)" to "vertexData.normal",
                "max(dot(n, l), 0.0)" to "clamp(dot(n, l), 0.0, 1.0)",
                "max(dot(n, h), 0.0)" to "clamp(dot(n, h), 0.0, 1.0)",
            ),
            fragment(Mistake.EMISSION_COLOR_IGNORED, "emission colour ignored", " * sceneColour" to ""),
            fragment(Mistake.EMISSION_COLOR_ADDED, "emission colour added", ".rgb * sceneColour" to ".rgb + sceneColour"),
            fragment(
                Mistake.COLOR_ON_EVERYTHING,
                "the colour on everything",
                " * sceneColour" to "",
                "vec4(result, 1.0)" to "vec4(result * sceneColour, 1.0)",
            ),
            fragment(
                Mistake.UNKNOWN,
                "the emission with each light",
                "vec3 result = emission" to "vec3 result = vec3(0.0)",
                "result += " to "result += emission + ",
            ),
            fragment(null, "the emission half as bright again", "vec3 result = emission" to "vec3 result = 1.5 * emission"),
            fragment(Mistake.EMISSION_MISSING, "emission missing", "vec3 result = emission" to "vec3 result = vec3(0.0)"),
            fragment(Mistake.LATER_LIGHTS_FIRST_COSINE, "later light with the first one's cosine", "shade(n, lc, v" to "shade(n, lp, v"),
            fragment(Mistake.LATER_LIGHTS_FIRST_COSINE, "the spotlight with the first one's cosine", "shade(n, ls, v" to "shade(n, lp, v"),
            fragment(
                Mistake.LATER_LIGHTS_FIRST_COLOR,
                "later light with the first one's colour",
                "* cornerLightColor" to "* pointLightColor",
            ),
            fragment(
                Mistake.UNKNOWN,
                "the cone twice",
                "return clamp((theta - outer) / (inner - outer), 0.0, 1.0);" to
                    "return pow(clamp((theta - outer) / (inner - outer), 0.0, 1.0), 2.0);",
            ),
            fragment(
                Mistake.UNKNOWN,
                "F twice",
                "return 1.0 / (k.x + k.y * d + k.z * d * d);" to "return pow(k.x + k.y * d + k.z * d * d, -2.0);",
            ),
            axis("an axis that is too short for full light", 0.95, 12.5, 25.0),
            axis("an axis that is too long", 1.05, 30.0, 50.0),
            degrees("cosines of degrees", 15.0, 28.0),
            fragment(Mistake.UNKNOWN, "a later light with the first one's distance", "attenuate(dc," to "attenuate(dp,"),
            fragment(
                Mistake.UNKNOWN,
                "point lights that fade with the camera's distance",
                "float dp = length(vertexData.toPointLight);" to "float dp = length(vertexData.toCamera);",
                "float dc = length(vertexData.toCornerLight);" to "float dc = length(vertexData.toCamera);",
            ),
            fragment(Mistake.PHONG_LEFT, "Phong", "dot(n, h)" to "dot(reflect(-l, n), v)"),
            fragment(Mistake.HALF_VECTOR_NOT_NORMALIZED, "half vector not normalised", "normalize(l + v)" to "l + v"),
            fragment(Mistake.HALF_VECTOR_NOT_NORMALIZED, "half vector as the mean", "normalize(l + v)" to "(l + v) / 2.0"),
            fragment(Mistake.GAMMA_DIRECTION, "gamma in the wrong direction", "vec4(result" to "vec4(pow(result, vec3(2.2))"),
            Case(
                "normals in world space by a matrix of their own, beside the product of model and view",
                setOf(Mistake.NORMAL_MATRIX),
                vertex = CourseShaders.VERTEX
                    .edited("mat4 modelView = view_matrix * model_matrix;", "")
                    .edited(
                        "uniform mat4 model_matrix;",
                        "uniform mat4 modelView;",
                    ).edited("uniform mat4 view_matrix;", "uniform mat4 normals;")
                    .edited(
                        "inverse(transpose(modelView))",
                        "normals",
                    ).replace(Regex("""\(view_matrix \* vec4\((\w+), 1.0\)\).xyz"""), "$1"),
                sent = { model, it ->
                    it + mapOf(
                        "modelView" to scene.view.mul(model, org.joml.Matrix4d()),
                        "normals" to model.invert(org.joml.Matrix4d()).transpose(),
                        "pointLightPos" to scene.viewed(scene.pointPosition),
                        "cornerLightPos" to scene.viewed(scene.cornerPosition),
                        "spotLightPos" to scene.viewed(scene.spotPosition),
                    )
                },
            ),
            fragment(
                Mistake.LATER_LIGHTS_FIRST_COLOR,
                "one colour for all, the headlight's as well",
                "* cornerLightColor *" to "* pointLightColor *",
                "* spotLightColor *" to "* pointLightColor *",
            ),
            Case("view space scaled", setOf(Mistake.VIEW_SCALED), sent = { _, it ->
                it +
                    ("view_matrix" to org.joml.Matrix4d().scale(1.25).mul(scene.view))
            }),
            values(Mistake.CONE_NEVER_SENT, "only the direction never sent", "spotLightDirection" to Vector3d()),
            Case(
                "cosines never sent",
                setOf(Mistake.CONE_NEVER_SENT),
                fragment = CourseShaders.FRAGMENT.edited("cos(spotInner)", "spotInner").edited("cos(spotOuter)", "spotOuter"),
                sent = { _, it -> it + mapOf("spotInner" to 0.0, "spotOuter" to 0.0) },
            ),
            values(Mistake.CONE_NEVER_SENT, "cone never sent", "spotInner" to 0.0, "spotOuter" to 0.0, "spotLightDirection" to Vector3d()),
        )
}
