package cga.grading.analysis

import cga.grading.findings.Check
import cga.grading.findings.Findings
import cga.grading.findings.Found
import cga.grading.findings.Measured
import cga.grading.findings.Mistake
import cga.grading.rubric.CheckState
import cga.grading.rubric.Grade
import cga.grading.rubric.Rubric
import cga.grading.rubric.spoiltBy
import cga.grading.sheet4.scene.SceneJudge
import cga.grading.sheet4.scene.SceneVerdict
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** How the two witnesses become one verdict. */
class VerdictTest {
    private fun found(
        mistake: Mistake,
        where: String = "",
        explains: Set<Check>? = null,
    ) = Found(mistake, 0.0, 1.0, where, explains = explains)

    /** What the study says: everything right but [errors], with the check of each mistake at 1. */
    private fun shading(vararg mistakes: Found, errors: Map<Check, Double?> = emptyMap()): ShadingVerdict {
        val wrong = mistakes.associate { it.mistake.check to 1.0 } + errors
        return ShadingVerdict(SHADERS.map { Measured(it, if (it in wrong) wrong[it] else 0.0, "study") }, mistakes.toList())
    }

    private fun scene(
        vararg mistakes: Found,
        errors: Map<Check, Double?> = emptyMap(),
        absent: Set<Check> = emptySet(),
        unlit: Set<String> = emptySet(),
        isReplaced: Boolean = false,
        spot: String? = null,
    ): SceneVerdict {
        val wrong = mistakes.associate { it.mistake.check to 1.0 } + absent.associateWith { 1.0 } + errors
        val checks = SceneJudge.CHECKS.map { Measured(it, if (it in wrong) wrong[it] else 0.0, "scene", it !in absent) }
        return SceneVerdict(checks, mistakes.toList(), emptyList(), unlit, isReplaced, spot)
    }

    private fun Verdict.names() = mistakes.map { it.mistake }

    private fun Verdict.grade() = Grade.of(Findings(checks, mistakes, emptyList(), emptyList(), emptyList()), RUBRIC)

    private fun Verdict.costs() = grade()
        .checks
        .filter { check ->
            check.points.let {
                it != null && it < check.maximum
            }
        }.map { it.check }
        .toSet()

    private fun Verdict.open() = grade().checks.filter { it.points == null }.map { it.check }.toSet()

    @Test
    fun `two contented witnesses make 100 points, and every check is there once`() {
        val verdict = Verdict.of(shading(), scene())
        assertEquals(Check.entries, verdict.checks.map { it.check })
        assertEquals(100.0 to emptyList<Mistake>(), verdict.grade().points to verdict.names())
    }

    @Test
    fun `a mistake that both see is one, at all the places that both name`() {
        val verdict = Verdict.of(shading(found(Mistake.VIEW_SCALED, "a")), scene(found(Mistake.VIEW_SCALED, "view matrix")))
        assertEquals(listOf("view matrix, a"), verdict.mistakes.map { it.where })
        assertEquals(setOf(Check.POINT_LIGHT_POSITION), verdict.costs())
    }

    @Test
    fun `two mistakes that have nothing to do with each other are both named and both charged`() {
        val verdict = Verdict.of(
            shading(found(Mistake.PHONG_LEFT, "a"), found(Mistake.CONE_INSIDE_OUT, "s")),
            scene(found(Mistake.MOUSE_FACTOR)),
        )
        assertEquals(setOf(Mistake.PHONG_LEFT, Mistake.CONE_INSIDE_OUT, Mistake.MOUSE_FACTOR), verdict.names().toSet())
        assertEquals(setOf(Check.HALF_VECTOR, Check.CONE, Check.ORBIT_FACTOR), verdict.costs())
    }

    @Test
    fun `the study's curve goes before the scene's angles, but not before a cosine of a cosine`() {
        val insideOut = shading(found(Mistake.CONE_INSIDE_OUT, "s"))
        assertEquals(listOf(Mistake.CONE_INSIDE_OUT), Verdict.of(insideOut, scene(found(Mistake.DEGREES_FOR_RADIANS, "s"))).names())
        assertEquals(listOf(Mistake.COSINE_OF_COSINE), Verdict.of(insideOut, scene(found(Mistake.COSINE_OF_COSINE, "s"))).names())
        val fine = Verdict.of(shading(), scene(found(Mistake.DEGREES_FOR_RADIANS, "s")))
        assertEquals(emptyList<Mistake>() to 100.0, fine.names() to fine.grade().points)
    }

    @Test
    fun `a cone whose numbers the scene saw was sent`() {
        val never = shading(found(Mistake.CONE_NEVER_SENT, "s"))
        val fine = Verdict.of(never, scene())
        assertEquals(emptyList<Mistake>() to 100.0, fine.names() to fine.grade().points)
        assertEquals(listOf(Mistake.CONE_NEVER_SENT), Verdict.of(never, scene(absent = setOf(Check.CONE, Check.SPOT_DIRECTION))).names())
        assertEquals(emptyList<Mistake>(), Verdict.of(never, scene(spot = "s")).names())
        // What the scene saw was another headlight's.
        assertEquals(listOf(Mistake.CONE_NEVER_SENT), Verdict.of(never, scene(spot = "first")).names())
    }

    @Test
    fun `what a shader makes of numbers of a cone that never arrive is no mistake of its own`() {
        val hard = shading(found(Mistake.CONE_HARD_EDGE, "s"))
        for (mistake in listOf(Mistake.UNIFORM_BEFORE_USE, Mistake.UNIFORM_ABSENT)) {
            val lost = scene(found(mistake, explains = setOf(Check.CONE)), errors = mapOf(Check.CONE to 1.0))
            assertEquals(listOf(mistake), Verdict.of(hard, lost).names())
            assertEquals(
                setOf(mistake, Mistake.CONE_HARD_EDGE),
                Verdict.of(hard, scene(found(mistake, explains = emptySet()))).names().toSet(),
            )
        }
    }

    @Test
    fun `numbers of a cone that are lost cost the cone, even where what is left of it is drawn as it should be`() {
        val lost = scene(
            found(Mistake.UNIFORM_ABSENT, explains = setOf(Check.CONE)),
            errors = mapOf(
                Check.CONE to 1.0,
                Check.POINT_LIGHT to 0.0,
            ),
        )
        assertEquals(setOf(Check.CONE), Verdict.of(shading(), lost).costs())
    }

    @Test
    fun `what is wrong and has no name is said to be unknown, once, and not where it is a matter of exactness`() {
        val verdict = Verdict.of(shading(), scene(errors = mapOf(Check.SPOT_DIRECTION to 1.0, Check.MORE_LIGHTS to 0.5)))
        assertEquals(listOf(Mistake.UNKNOWN), verdict.names())
        assertEquals(setOf(Check.SPOT_DIRECTION, Check.MORE_LIGHTS), verdict.costs())
        assertEquals(emptyList<Mistake>(), Verdict.of(shading(), scene(errors = mapOf(Check.SPOT_DIRECTION to 0.1))).names())
    }

    @Test
    fun `a light that shines backwards because its vector does is one mistake`() {
        val verdict = Verdict.of(shading(found(Mistake.LIGHT_VECTOR_SIGN, "a, s")), scene(found(Mistake.SPOT_DIRECTION_SIGN, "s")))
        assertEquals(listOf(Mistake.LIGHT_VECTOR_SIGN) to setOf(Check.DIFFUSE), verdict.names() to verdict.costs())
    }

    @Test
    fun `the direction is the scene's, unless it could not see it`() {
        val local = shading(found(Mistake.SPOT_DIRECTION_LOCAL, "s"))
        val world = scene(found(Mistake.SPOT_DIRECTION_WORLD, "s"))
        assertEquals(listOf(Mistake.SPOT_DIRECTION_WORLD), Verdict.of(local, world).names())
        assertEquals(listOf(Mistake.SPOT_DIRECTION_LOCAL), Verdict.of(local, scene(errors = mapOf(Check.SPOT_DIRECTION to null))).names())
    }

    @Test
    fun `numbers of an attenuation that the shader does not use mean nothing`() {
        val other = scene(found(Mistake.ATTENUATION_OTHER_K, "a"))
        for (mistake in listOf(Mistake.ATTENUATION_MISSING, Mistake.ATTENUATION_LINEAR, Mistake.NORMALIZED_IN_VERTEX_SHADER)) {
            val verdict = Verdict.of(shading(found(mistake, "a")), other)
            assertEquals(listOf(mistake) to setOf(mistake.check), verdict.names() to verdict.costs())
        }
        assertEquals(listOf(Mistake.ATTENUATION_OTHER_K), Verdict.of(shading(), other).names())
        // The form is what the study measures.
        assertEquals(emptyList<Mistake>(), Verdict.of(shading(), scene(found(Mistake.ATTENUATION_MISSING, "a"))).names())
    }

    @Test
    fun `the K of a light that fades in an unknown way is nothing to name, that of another is`() {
        val errors = mapOf(Check.DIFFUSE to 0.0, Check.ATTENUATION_FORM to 1.0)
        val unknown = shading(found(Mistake.UNKNOWN, "a, b", spoiltBy(Check.ATTENUATION_FORM)), errors = errors)
        val same = Verdict.of(unknown, scene(found(Mistake.ATTENUATION_OTHER_K, "a")))
        assertEquals(listOf(Mistake.UNKNOWN) to setOf(Check.ATTENUATION_FORM), same.names() to same.costs())
        assertTrue(Mistake.ATTENUATION_OTHER_K in Verdict.of(unknown, scene(found(Mistake.ATTENUATION_OTHER_K, "a and c"))).names())
    }

    @Test
    fun `what the study says of a light that never shines is no mistake, and costs where the light is missing`() {
        val noise = arrayOf(found(Mistake.UNKNOWN, "bike"), found(Mistake.SPECULAR_MISSING, "bike"))
        val verdict = Verdict.of(shading(*noise, errors = mapOf(Check.ATTENUATION_FORM to 1.0)), missing(setOf("bike")))
        assertEquals(listOf(Mistake.LIGHT_MISSING) to setOf(Check.POINT_LIGHT), verdict.names() to verdict.costs())
        assertEquals(setOf(Check.SPECULAR), verdict.open())
        val other = Verdict.of(shading(found(Mistake.SPECULAR_MISSING, "bike, spot")), missing(setOf("bike")))
        assertEquals(setOf(Mistake.LIGHT_MISSING, Mistake.SPECULAR_MISSING), other.names().toSet())
    }

    @Test
    fun `a light that the shaders know costs once, one that nobody has written costs all of it`() {
        assertEquals(setOf(Check.POINT_LIGHT), Verdict.of(shading(), missing(setOf("bike"))).costs())
        assertEquals(POINT, Verdict.of(shading(), missing(emptySet())).costs())
        val both = scene(found(Mistake.LIGHT_MISSING), found(Mistake.SPOT_MISSING), absent = POINT + SPOT, unlit = setOf("bike"))
        assertEquals(POINT + SPOT - Check.CONE, Verdict.of(shading(), both).costs())
    }

    @Test
    fun `without any light and any shader for one there is nothing, not something unmeasured`() {
        val nothing = SHADERS.filter { it != Check.EMISSION }.associateWith { null }
        val mistakes = arrayOf(found(Mistake.LIGHT_MISSING), found(Mistake.SPOT_MISSING), found(Mistake.MORE_LIGHTS_MISSING))
        val grade = Verdict.of(shading(errors = nothing), scene(*mistakes, absent = POINT + SPOT + Check.MORE_LIGHTS)).grade()
        assertEquals(0.0, grade.open, grade.checks.filter { it.points == null }.joinToString { it.check.id })
        val seen = setOf(CheckState.NOT_FOUND, CheckState.MISTAKE)
        assertEquals(seen, grade.checks.filter { it.check in nothing || it.check in POINT + SPOT }.map { it.state }.toSet())
    }

    @Test
    fun `a misspelt name explains all that it makes dark`() {
        val lost = POINT + SPOT + Check.CONE_SPECULAR + Check.MORE_LIGHTS + Check.MORE_LIGHTS_SHADING
        val absent = POINT + SPOT + Check.MORE_LIGHTS
        val scene = scene(found(Mistake.UNIFORM_ABSENT, "colour", lost), absent = absent, unlit = setOf("a", "s"))
        val verdict = Verdict.of(shading(found(Mistake.CONE_NEVER_SENT, "s"), found(Mistake.UNKNOWN, "a, b")), scene)
        assertEquals(listOf(Mistake.UNIFORM_ABSENT) to setOf(Check.POINT_LIGHT), verdict.names() to verdict.costs())
    }

    @Test
    fun `numbers that come a frame too late explain nothing that is missing`() {
        val scene = scene(found(Mistake.UNIFORM_BEFORE_USE, "glUniform3f"), found(Mistake.SPOT_MISSING), absent = SPOT)
        assertEquals(listOf(Mistake.UNIFORM_BEFORE_USE, Mistake.SPOT_MISSING), Verdict.of(shading(), scene).names())
    }

    @Test
    fun `lights that cannot be placed without a diffuse term are not missing`() {
        val unseen = listOf(Check.SPECULAR, Check.NORMALS, Check.INTERPOLATION, Check.CONE, Check.CONE_SPECULAR, Check.HALF_VECTOR)
            .associateWith {
                null
            }
        val missing = arrayOf(found(Mistake.LIGHT_MISSING), found(Mistake.SPOT_MISSING), found(Mistake.MORE_LIGHTS_MISSING))
        val verdict = Verdict.of(
            shading(found(Mistake.DIFFUSE_MISSING), errors = unseen),
            scene(
                *missing,
                absent =
                    POINT + SPOT + Check.MORE_LIGHTS,
            ),
        )
        assertEquals(listOf(Mistake.DIFFUSE_MISSING) to setOf(Check.DIFFUSE), verdict.names() to verdict.costs())
        // Nobody can tell whether what a missing diffuse term hides is right.
        assertEquals(unseen.keys - Check.CONE, verdict.open())
    }

    @Test
    fun `a cone that is lit outside seems to point backwards, and one that was never sent seems to be none`() {
        for (mistake in listOf(Mistake.CONE_INSIDE_OUT, Mistake.COSINE_OF_COSINE, Mistake.DEGREES_FOR_RADIANS)) {
            val verdict = Verdict.of(shading(found(mistake, "s")), scene(found(Mistake.SPOT_DIRECTION_SIGN, "s")))
            assertEquals(listOf(mistake) to setOf(Check.CONE), verdict.names() to verdict.costs())
        }
        val never = Verdict.of(shading(found(Mistake.CONE_NEVER_SENT, "s")), scene(found(Mistake.SPOT_MISSING), absent = SPOT))
        assertEquals(listOf(Mistake.CONE_NEVER_SENT) to setOf(Check.CONE), never.names() to never.costs())
    }

    @Test
    fun `a colour that was sent and is not used costs once, one that nobody sent costs all of its task`() {
        val colors = setOf(Check.GROUND_COLOR, Check.MOTORCYCLE_COLOR)
        val ignored = shading(found(Mistake.EMISSION_COLOR_IGNORED))
        val sent = Verdict.of(ignored, scene(found(Mistake.EMISSION_COLOR_IGNORED, explains = colors), absent = colors))
        assertEquals(setOf(Check.EMISSION), sent.costs())
        val nothing = Verdict.of(ignored, scene(found(Mistake.EMISSION_COLOR_IGNORED, explains = emptySet()), absent = colors))
        assertEquals(colors + Check.EMISSION, nothing.costs())
        val multiplied = Verdict.of(
            shading(found(Mistake.EMISSION_MULTIPLIED)),
            scene(found(Mistake.EMISSION_COLOR_IGNORED), absent = colors),
        )
        assertEquals(listOf(Mistake.EMISSION_MULTIPLIED) to setOf(Check.EMISSION), multiplied.names() to multiplied.costs())
    }

    @Test
    fun `an ignored colour of the emission makes it constant, too`() {
        val verdict = Verdict.of(shading(found(Mistake.EMISSION_COLOR_IGNORED)), scene(found(Mistake.COLOR_CONSTANT, "motorcycle")))
        assertEquals(listOf(Mistake.EMISSION_COLOR_IGNORED) to setOf(Check.EMISSION), verdict.names() to verdict.costs())
    }

    @Test
    fun `of a shader that stands in for another nothing is said, of the scene what it shows`() {
        val noise = shading(found(Mistake.EMISSION_MISSING), found(Mistake.DIFFUSE_MISSING))
        val open = mapOf<Check, Double?>(Check.CONE to null, Check.SPOT_DIRECTION to null)
        val verdict = Verdict.of(noise, scene(found(Mistake.SHADER_REFUSED, "0:1: error"), errors = open, isReplaced = true))
        assertEquals(listOf(Mistake.SHADER_REFUSED), verdict.names())
        val grade = verdict.grade()
        val (seen, unseen) = grade.checks.filter { it.check != Check.ORDER }.partition { it.check in SceneJudge.CHECKS - open.keys }
        assertTrue(seen.all { it.state == CheckState.RIGHT })
        assertTrue(unseen.all { it.state == CheckState.OPEN })
    }

    @Test
    fun `no two mistakes are traces of each other, or both would be lost`() {
        val all = Mistake.entries.map { found(it, explains = setOf(Check.ORDER)) }
        val circles = all.flatMap { a ->
            all.filter { b -> VerdictTraces.isTrace(a, b) && VerdictTraces.isTrace(b, a) }.map {
                a.mistake to
                    it.mistake
            }
        }
        assertEquals(emptyList<Any>(), circles)
    }

    @Test
    fun `an unknown difference is kept where nothing else is said, and dropped where it is`() {
        val unknown = found(Mistake.UNKNOWN, "a")
        assertEquals(listOf(Mistake.UNKNOWN), Verdict.of(shading(unknown), scene()).names())
        assertEquals(listOf(Mistake.PHONG_LEFT), Verdict.of(shading(unknown, found(Mistake.PHONG_LEFT, "a")), scene()).names())
        assertEquals(emptySet<Check>(), Verdict.of(shading(unknown), scene()).mistakes.single().explains.orEmpty())
    }

    private fun missing(unlit: Set<String>) = scene(found(Mistake.LIGHT_MISSING), absent = POINT, unlit = unlit)

    private companion object {
        val RUBRIC = Rubric.default()
        val POINT =
            setOf(Check.POINT_LIGHT, Check.POINT_LIGHT_CHILD, Check.POINT_LIGHT_POSITION, Check.ATTENUATION_POINT, Check.LIGHT_COLOR)
        val SPOT = setOf(Check.SPOT_LIGHT, Check.SPOT_LIGHT_CHILD, Check.SPOT_DIRECTION, Check.CONE, Check.ATTENUATION_SPOT)
        val SHADERS =
            setOf(
                Check.DIFFUSE, Check.SPECULAR, Check.NORMALS, Check.INTERPOLATION, Check.MATERIAL, Check.CONE, Check.CONE_SPECULAR,
                Check.ATTENUATION_FORM, Check.EMISSION, Check.MORE_LIGHTS_SHADING, Check.HALF_VECTOR,
            )
    }
}
