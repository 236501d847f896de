package cga.grading.study

import cga.grading.scene.ArrayNames
import cga.grading.scene.ArrayNames.arrayOf

/**
 * Elements of the arrays that lights are sent in with which no light is computed, as a loop leaves them out that begins or ends too early.
 */
internal object IdleElements {
    /** What [study]'s idle elements would be as lights, told by [lights] of the same array. */
    fun of(study: ProgramStudy, lights: List<LightRefs>): List<LightRefs> {
        val slots = study.colors.lights.map { it.name }.toSet()
        val active = study.box.program.uniforms.map { it.name }.toSet()
        return lights.mapNotNull { light -> arrayOf(light.color)?.to(light) }.distinctBy { it.first }.flatMap { (array, light) ->
            active.filter { it !in slots && arrayOf(it) == array }.mapNotNull { name -> light.sentTo(element(name), active) }
        }
    }

    private fun element(name: String): String = ArrayNames.ELEMENT.find(name)?.value.orEmpty()
}
