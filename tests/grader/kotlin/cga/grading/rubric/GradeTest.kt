package cga.grading.rubric

import cga.grading.findings.Check
import cga.grading.findings.Findings
import cga.grading.findings.Found
import cga.grading.findings.Measured
import cga.grading.findings.Message
import cga.grading.findings.Mistake
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.EnumSource
import kotlin.random.Random

class GradeTest {
    private val rubric = Rubric.default()

    private fun grade(errors: Map<Check, Double> = emptyMap(), vararg mistakes: Found, without: Set<Check> = emptySet()) =
        Grade.of(
            Findings(
                (Check.entries - without).map { Measured(it, errors[it] ?: 0.0, "") },
                mistakes.toList(),
                emptyList(),
                emptyList(),
                emptyList(),
            ),
            rubric,
        )

    private fun Grade.of(check: Check) = checks.first { it.check == check }

    private fun found(mistake: Mistake, explains: Set<Check>? = null) = Found(mistake, 0.0, 1.0, "", explains = explains)

    @Test
    fun `everything right earns everything`() {
        val grade = grade()
        assertEquals(listOf(100.0, 100.0, 0.0), listOf(grade.points, grade.maximum, grade.open))
        assertEquals(setOf(CheckState.RIGHT), grade.checks.map { it.state }.toSet())
    }

    @ParameterizedTest
    @EnumSource(Mistake::class, names = ["UNKNOWN"], mode = EnumSource.Mode.EXCLUDE)
    fun `a mistake alone costs its own check and no other, even found twice and with all it disturbs wrong`(mistake: Mistake) {
        val errors = (disturbedBy(mistake) + mistake.check).associateWith { 5.0 }
        val grade = grade(errors, found(mistake), found(mistake))
        assertEquals(100 - rubric.rule(mistake.check).points * rubric.cost(mistake), grade.points, 1e-9)
        assertEquals(mistake, grade.of(mistake.check).cause)
        for (check in disturbedBy(mistake) - mistake.check) {
            assertEquals(CheckState.EXPLAINED to mistake, grade.of(check).state to grade.of(check).cause)
        }
    }

    @Test
    fun `other constants cost the light that has them, and only the first of two`() {
        val other = found(Mistake.ATTENUATION_OTHER_K)

        fun states(vararg wrong: Check) =
            grade(wrong.associateWith { 0.5 }, other).let { it.of(Check.ATTENUATION_POINT).state to it.of(Check.ATTENUATION_SPOT).state }
        assertEquals(CheckState.RIGHT to CheckState.MISTAKE, states(Check.ATTENUATION_SPOT))
        assertEquals(CheckState.MISTAKE to CheckState.EXPLAINED, states(Check.ATTENUATION_POINT, Check.ATTENUATION_SPOT))
    }

    @Test
    fun `a name that no program has costs what it was the name of`() {
        fun cost(vararg lost: Check) = grade(lost.associateWith { 1.0 }, found(Mistake.UNIFORM_ABSENT, lost.toSet()))
            .checks
            .single { it.state == CheckState.MISTAKE }
            .check
        assertEquals(Check.CONE, cost(Check.CONE, Check.CONE_SPECULAR))
        assertEquals(Check.MOTORCYCLE_COLOR, cost(Check.MOTORCYCLE_COLOR))
        assertEquals(Check.SPOT_LIGHT, cost(Check.CONE, Check.SPOT_LIGHT))
        assertEquals(Check.POINT_LIGHT, cost())
    }

    @Test
    fun `something unknown costs by its size, and what it is known to spoil is not charged again`() {
        val errors = mapOf(Check.SPECULAR to 1.0, Check.HALF_VECTOR to 1.0)
        val spoilt = grade(errors, found(Mistake.UNKNOWN, spoiltBy(Check.SPECULAR)))
        assertEquals(CheckState.INEXACT to CheckState.EXPLAINED, spoilt.of(Check.SPECULAR).state to spoilt.of(Check.HALF_VECTOR).state)
        assertEquals(CheckState.INEXACT, grade(errors, found(Mistake.UNKNOWN)).of(Check.HALF_VECTOR).state)
        val blind = grade(errors, found(Mistake.UNKNOWN, spoiltBy(Check.SPECULAR)), without = setOf(Check.HALF_VECTOR))
        assertEquals(CheckState.OPEN, blind.of(Check.HALF_VECTOR).state)
    }

    @Test
    fun `what the mistake does not disturb is charged by its size`() {
        val grade = grade(mapOf(Check.ORBIT_FACTOR to 0.26, Check.CONE to 2.0), found(Mistake.CONE_INSIDE_OUT))
        // Half-way between the tolerance 0.02 and the zero 0.5.
        assertEquals(CheckState.INEXACT to 1.0, grade.of(Check.ORBIT_FACTOR).let { it.state to it.points })
        assertEquals(93.0, grade.points)
    }

    @Test
    fun `what the analysis determined goes before what is so by nature`() {
        val errors = mapOf(Check.CONE to 2.0, Check.CONE_SPECULAR to 2.0, Check.ORBIT to 2.0)
        val grade = grade(errors, found(Mistake.CONE_INSIDE_OUT, setOf(Check.ORBIT)))
        assertEquals(CheckState.INEXACT, grade.of(Check.CONE_SPECULAR).state)
        assertEquals(CheckState.EXPLAINED, grade.of(Check.ORBIT).state)
    }

    @Test
    fun `what is not there earns nothing, unless the analysis says that it is there and why it is not seen`() {
        val checks = Check.entries.map { Measured(it, if (it.task == "4.6") null else 0.0, "", found = it.task != "4.6") }

        fun points(vararg mistakes: Found) = Grade.of(Findings(checks, mistakes.toList(), emptyList(), emptyList(), emptyList()), rubric)
        assertEquals(92.0, points().points)
        assertEquals(CheckState.NOT_FOUND, points().of(Check.MORE_LIGHTS).state)
        assertEquals(96.0, points(found(Mistake.UNIFORM_ABSENT, setOf(Check.MORE_LIGHTS, Check.MORE_LIGHTS_SHADING))).points)
        assertEquals(92.0, points(found(Mistake.CONE_INSIDE_OUT)).points + rubric.rule(Check.CONE).points)
    }

    @Test
    fun `what was not measured is open and never silently 0`() {
        val grade = grade(without = setOf(Check.CONE))
        assertEquals(listOf(94.0, 6.0), listOf(grade.points, grade.open))
        assertEquals(CheckState.OPEN to null, grade.of(Check.CONE).let { it.state to it.points })
        val noted = Grade.of(Findings(listOf(Measured(Check.CONE, null, "")), emptyList(), emptyList(), emptyList(), emptyList()), rubric)
        assertEquals(listOf(0.0, 100.0), listOf(noted.points, noted.open))
    }

    @Test
    fun `a mistake makes nothing of what was not measured`() {
        val grade =
            grade(mistakes = arrayOf(found(Mistake.CONE_INSIDE_OUT, setOf(Check.CONE_SPECULAR))), without = setOf(Check.CONE_SPECULAR))
        assertEquals(CheckState.OPEN, grade.of(Check.CONE_SPECULAR).state)
    }

    /** Findings drawn at random, and the same with one thing taken away: a check that is no longer there, or a mistake more. */
    @Test
    fun `less work never earns more`() {
        val random = Random(4)
        repeat(2000) {
            val checks = Check.entries.map { check -> random(check, random) }
            val mistakes = List(random.nextInt(4)) { found(Mistake.entries.random(random), explained(random)) }
            val before = points(checks, mistakes)
            val lost = random.nextInt(checks.size)
            val fewer = checks.mapIndexed { i, check -> if (i == lost) Measured.absent(check.check, Message.NONE) else check }
            assertTrue(points(fewer, mistakes) <= before) { "without ${checks[lost].check}" }
            val worse = checks.mapIndexed { i, check ->
                if (i ==
                    lost
                ) {
                    Measured.of(check.check, (check.error ?: 0.0) + 0.1, Message.NONE)
                } else {
                    check
                }
            }
            if (checks[lost].error != null) assertTrue(points(worse, mistakes) <= before) { "worse ${checks[lost].check}" }
        }
    }

    private fun random(check: Check, random: Random) =
        when (random.nextInt(4)) {
            0 -> Measured.absent(check, Message.NONE)
            1 -> Measured.open(check, Message.NONE)
            else -> Measured.of(check, random.nextDouble(), Message.NONE)
        }

    private fun explained(random: Random) = if (random.nextBoolean()) null else Check.entries.filter { random.nextInt(4) == 0 }.toSet()

    /** With those that are open counted as if a person gave them. */
    private fun points(checks: List<Measured>, mistakes: List<Found>) =
        Grade.of(Findings(checks, mistakes, emptyList(), emptyList(), emptyList()), rubric).run { points + open }

    @Test
    fun `the unknown is no name and neither costs nor explains`() {
        val grade = grade(mapOf(Check.DIFFUSE to 9.0, Check.NORMALS to 9.0), found(Mistake.UNKNOWN))
        assertEquals(93.0, grade.points)
        assertEquals(100.0, grade(emptyMap(), found(Mistake.UNKNOWN)).points)
    }

    @Test
    fun `of mistakes that draw the same picture only the first is charged`() {
        val found = Found(Mistake.ATTENUATION_ONE_K, 0.0, 1.0, "", listOf(Mistake.ATTENUATION_LAST_K), explains = emptySet())
        val grade = grade(mapOf(Check.ATTENUATION_SPOT to 1.0, Check.ATTENUATION_POINT to 1.0), found)
        assertEquals(97.0, grade.points)
    }

    @Test
    fun `a mistake that the rubric halves costs half`() {
        assertEquals(98.0, grade(emptyMap(), found(Mistake.ATTENUATION_OTHER_K)).points)
    }

    @Test
    fun `no mistake disturbs all, or it would hide every other`() {
        for (mistake in Mistake.entries) assertFalse(disturbedBy(mistake).size > Check.entries.size * 2 / 3, mistake.name)
    }
}
