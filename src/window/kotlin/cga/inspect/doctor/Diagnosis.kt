package cga.inspect.doctor

import cga.framework.model.MeshData
import org.joml.Matrix4d
import org.joml.Vector3d

/** A likely cause of a black or unlit picture: what was found, and what helps. */
internal class Finding(
    val found: String,
    val cure: String,
)

/** Looks through [Evidence] for the causes that a course sees most, the root of others first. */
internal object Diagnosis {
    private val CAUSES: List<(Evidence) -> List<Finding>> =
        listOf(
            ::programNotInUse,
            Names::mismatches,
            ::noLight,
            ::lightNotSent,
            ::zeroAttenuation,
            ::zeroNormals,
            ::notNumbers,
            ::lightInGround,
            ::cameraInside,
            ::textureUnits,
        )

    /** What was found, the likeliest cause first; empty where everything looks as it should. */
    fun of(evidence: Evidence): List<Finding> {
        if (evidence.program == 0) return programNotInUse(evidence)
        return CAUSES.flatMap { it(evidence) }
    }

    private fun programNotInUse(evidence: Evidence): List<Finding> =
        finding(
            evidence.program == 0,
            "No shader program is in use when the scene is drawn.",
            "Call shaderProgram.use() first in render(): uniforms and draw calls go to the program in use.",
        )

    private fun noLight(evidence: Evidence): List<Finding> {
        if (!evidence.hasLights) {
            return listOf(
                Finding("No light shines at this step: only emission is seen.", "Choose step 4.2 or a later one (key 2)."),
            )
        }
        val colors = evidence.frame.lights.map { it.color }
        return finding(
            colors.all { it.x() == 0f && it.y() == 0f && it.z() == 0f },
            "Every light is black: its colour is (0, 0, 0).",
            "Give the lights a colour; the motorcycle's is |sin| of the time, which is black at t = 0.",
        )
    }

    private fun lightNotSent(evidence: Evidence): List<Finding> {
        if (!evidence.hasLights) return emptyList()
        val missing = Names.lightsNeverSent(evidence)
        return finding(
            evidence.uniforms.none { "light" in it.name.lowercase() },
            "The shader uses no light: no uniform of one has an effect.",
            "Add each light's share to the colour in main() of scene.frag.",
        ) +
            finding(
                missing.isNotEmpty(),
                "No light is bound: nobody sends ${several(missing)}.",
                "Call bind() of every light after use() and before the draws, with the name that the shader gives the light.",
            )
    }

    // What was never sent is another cause.
    private fun zeroAttenuation(evidence: Evidence): List<Finding> {
        val zero = evidence.uniforms.filter { it.isZero && it.name in evidence.sent && ATTENUATION.containsMatchIn(it.name) }
        return finding(
            zero.isNotEmpty(),
            "${several(zero.map { it.name })}: K is (0, 0, 0), and the attenuation divides by 0.",
            "Send K_c, K_l and K_q in bind(); Table 1 has their values.",
        )
    }

    private fun zeroNormals(evidence: Evidence): List<Finding> {
        val matrix = evidence.uniforms.filter { "normal" in it.name.lowercase() && it.isZero }
        val flat = evidence.frame.draws.indices.filter { draw -> normals(evidence.frame.draws[draw].vertices).all { it == 0f } }
        return finding(
            matrix.isNotEmpty(),
            "${matrix.firstOrNull()?.name} is 0: every normal becomes 0, and no angle is defined.",
            "Send the normal matrix of every object before its draw.",
        ) +
            finding(
                flat.isNotEmpty(),
                "All normals of mesh ${flat.joinToString()} are 0.",
                "Look at the vertex attributes: the normal is the third, three floats from byte 20 on; or export the model with normals.",
            )
    }

    private fun normals(vertices: FloatArray) =
        vertices.indices.asSequence().filter { it % MeshData.FLOATS_PER_VERTEX >= NORMAL }.map { vertices[it] }

    private fun notNumbers(evidence: Evidence): List<Finding> =
        evidence.uniforms.filterNot { it.isFinite }.map {
            Finding(
                "${it.name} is ${it.numbers.joinToString()}: not a number.",
                "Look for a division by 0, or a normalised vector of length 0, in what is sent.",
            )
        } +
            finding(
                evidence.notFinite > 0,
                "${evidence.notFinite} pixels of ${evidence.picture.width * evidence.picture.height} are NaN or infinite, which a screen shows as black or white.",
                "In the shader look for 0/0, pow of a negative number, normalize of a vector of length 0.",
            )

    private fun lightInGround(evidence: Evidence): List<Finding> {
        val around = Surroundings(evidence.frame)
        return evidence.frame.lights.withIndex().filter { around.isUnderGround(it.value.position) }.map { (i, light) ->
            val place = "(%.2f, %.2f, %.2f)".format(java.util.Locale.ROOT, light.position.x(), light.position.y(), light.position.z())
            Finding("light[$i] is in or under the ground, at $place.", "Move it up: what faces away from a light stays dark.")
        }
    }

    private fun cameraInside(evidence: Evidence): List<Finding> {
        val eye = Matrix4d(evidence.frame.view).invertAffine().getTranslation(Vector3d())
        return finding(
            Surroundings(evidence.frame).isInside(eye),
            "The camera is inside an object or under the ground: it sees only backs, which are not drawn.",
            "Move it out: it is a child of the motorcycle, turned down by 35° and then 4 back along its own z axis.",
        )
    }

    private fun textureUnits(evidence: Evidence): List<Finding> =
        evidence.samplers.groupBy { it.unit }.values.filter { it.size > 1 }.map { shared ->
            Finding(
                "${shared.joinToString(" and ") { it.name }} read the same texture unit, ${shared.first().unit}.",
                "Give each its own: bind(0), bind(1), bind(2), and send 0, 1 and 2.",
            )
        } +
            evidence.samplers.filter { it.problem != null }.map {
                Finding(
                    "${it.name} reads black: ${it.problem}.",
                    "Bind the texture to that unit before the draw, and set its filter to what it has.",
                )
            }

    private fun several(names: List<String>) = names.firstOrNull().orEmpty() + if (names.size > 1) " and ${names.size - 1} more" else ""

    private fun finding(
        isFound: Boolean,
        found: String,
        cure: String,
    ): List<Finding> = if (isFound) listOf(Finding(found, cure)) else emptyList()

    private val ATTENUATION = Regex("atten|k_?c", RegexOption.IGNORE_CASE)

    /** Where a vertex has its normal. */
    private const val NORMAL = 5
}
