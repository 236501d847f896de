package cga.inspect.tune

import cga.exercise.components.geometry.Renderable
import cga.exercise.components.light.PointLight
import cga.exercise.game.Scene
import cga.exercise.game.Step
import cga.inspect.knob.Knob
import cga.inspect.knob.KnobGroup
import cga.inspect.light.InspectedLight
import org.joml.Vector3f

/** One light of the scene, by its name among all, and its knobs. */
internal class TunedLight(
    val name: String,
    val inspected: InspectedLight,
) {
    val light: PointLight get() = inspected.light
    val groups: List<KnobGroup> = inspected.groups()
}

/**
 * Every number of the [scene] that the panel turns: it changes the scene itself, so whatever asks the scene sees it.
 *
 * @param turned is told each knob that is turned, by its name among all of them, and its value.
 * @param wasReset is told that all were reset.
 */
internal class Tuning(
    private val scene: Scene,
    private val turned: (String, Float) -> Unit = { _, _ -> },
    private val wasReset: () -> Unit = {},
) {
    private val all = named(everyLight().map { InspectedLight.of(it, scene) })

    /** The lights that shine at the scene's step, in its order. */
    var lights: List<TunedLight> = emptyList()
        private set

    /** The same, for their gizmos. */
    var inspected: List<InspectedLight> = emptyList()
        private set

    /** L_a and gamma. */
    val picture: KnobGroup = KnobGroup("ambient light L_a and gamma", ambient() + gamma())

    /** The exponents k. */
    val materials: KnobGroup =
        KnobGroup("exponent k", listOf(exponent("ground", scene.ground), exponent("motorcycle", scene.motorcycle)))

    /** The knobs by names that are one word each: `spotLight.inner`, `scene.gamma`. */
    val knobs: Map<String, Knob> =
        buildMap {
            for (light in all) for (knob in light.groups.flatMap { it.knobs }) put("${light.name}.${knob.name}", knob)
            for (knob in picture.knobs) put("scene.${knob.name.replace(' ', '.')}", knob)
            for (knob in materials.knobs) put("${knob.name}.k", knob)
        }
    private val names = knobs.entries.associate { (name, knob) -> knob to name }

    init {
        stepChanged()
    }

    /** Turns [knob] to [value]. */
    fun turn(
        knob: Knob,
        value: Float,
    ) {
        knob.value = value
        turned(names.getValue(knob), value)
    }

    /** A step has its own attenuations, which are what [reset] goes back to from now on. */
    fun stepChanged() {
        lights = scene.lights.shining.map { light -> all.first { it.light === light } }
        inspected = lights.map { it.inspected }
        for (light in lights) light.groups.first { it.title == InspectedLight.ATTENUATION }.knobs.forEach(Knob::remember)
    }

    /** Everything as it was at the start. */
    fun reset() {
        knobs.values.forEach(Knob::reset)
        // The motorcycle's colour goes with the time again.
        scene.motorcycleColor = null
        wasReset()
    }

    /** The values as Kotlin code, for the scene's own files. */
    fun toKotlin(): String = KotlinCode.of(scene, lights)

    /** Those of all steps. */
    private fun everyLight(): Set<PointLight> {
        val lights = LinkedHashSet<PointLight>()
        for (step in Step.entries) {
            scene.lights.switchTo(step)
            lights += scene.lights.shining
        }
        scene.lights.switchTo(scene.step)
        return lights
    }

    private fun named(lights: List<InspectedLight>): List<TunedLight> {
        val corners = lights.filter { it.light.parent == null }
        return lights.map { TunedLight(if (it in corners) "cornerLight${corners.indexOf(it) + 1}" else it.kind, it) }
    }

    private fun ambient() =
        listOf("L_a red", "L_a green", "L_a blue").mapIndexed { i, name ->
            Knob(name, 0f, 1f, { scene.ambient.get(i) }) { scene.ambient = Vector3f(scene.ambient).setComponent(i, it) }
        }

    private fun gamma() = Knob("gamma", MIN_GAMMA, MAX_GAMMA, { scene.gamma }) { scene.gamma = it }

    /** The exponent of the model's first material; the others keep their proportion to it. */
    private fun exponent(
        name: String,
        model: Renderable,
    ): Knob {
        val materials = model.meshes.mapNotNull { it.material }.distinct()
        val own = materials.map { it.shininess }
        return Knob(name, 0f, MAX_EXPONENT, { materials.first().shininess }) { k ->
            for (i in materials.indices) materials[i].shininess = k / own.first() * own[i]
        }
    }

    private companion object {
        const val MIN_GAMMA = 1f
        const val MAX_GAMMA = 3f
        const val MAX_EXPONENT = 256f
    }
}
