package cga.grading.pipeline

import cga.grading.findings.Check
import cga.grading.findings.Findings
import cga.grading.findings.Found
import cga.grading.findings.Measured
import cga.grading.findings.Message
import cga.grading.findings.Mistake

/** Files of a submission that did not compile and were replaced: what they are there for is not the submission's work. */
internal class ReplacedFiles(private val names: List<String>) {
    private val checks: Set<Check> = names.flatMap { WORK[it.substringAfterLast('/').removeSuffix(".kt").lowercase()].orEmpty() }.toSet()

    /** [findings] without what is the reference's: not found, and no mistake of the submission's. */
    fun applied(findings: Findings): Findings {
        if (names.isEmpty()) return findings
        val refused = Found(Mistake.KOTLIN_REFUSED, 0.0, 0.0, names.joinToString(), explains = emptySet())
        return Findings(
            findings.checks.map { if (it.check in checks) Measured.absent(it.check, REPLACED) else it },
            listOf(refused) + findings.mistakes.filterNot { it.mistake.check in checks },
            findings.plots.filterNot { it.check in checks },
            findings.pictures,
            findings.notes,
            findings.proof,
        )
    }

    internal companion object {
        val REPLACED: Message = Message.of("said.file-replaced")

        private val POINT = setOf(Check.POINT_LIGHT, Check.POINT_LIGHT_POSITION, Check.ATTENUATION_POINT)
        private val SPOT = setOf(Check.SPOT_LIGHT, Check.SPOT_DIRECTION, Check.ATTENUATION_SPOT)
        private val COLORS = setOf(Check.GROUND_COLOR, Check.MOTORCYCLE_COLOR, Check.LIGHT_COLOR)
        private val ORBIT = setOf(Check.ORBIT, Check.ORBIT_PIVOT, Check.ORBIT_HORIZON, Check.ORBIT_FACTOR, Check.ORBIT_START)
        private val SCENE = POINT + SPOT + COLORS + ORBIT +
            setOf(Check.ORDER, Check.POINT_LIGHT_CHILD, Check.SPOT_LIGHT_CHILD, Check.MORE_LIGHTS)

        /**
         * What the sheet has done in a file. What the shaders do is not lost with the scene; the files of earlier sheets are no work of
         * this one, but for the turning of the camera.
         */
        private val WORK = mapOf(
            "pointlight" to POINT,
            "spotlight" to SPOT,
            "scene" to SCENE,
            "troncamera" to ORBIT,
            "transformable" to ORBIT,
            "material" to setOf(Check.MATERIAL),
            "renderable" to COLORS,
        )
    }
}
