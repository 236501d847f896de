package cga.inspect.tune

import cga.exercise.game.Scene
import cga.inspect.knob.literal

/** What the panel was turned to, as Kotlin code in the course's own classes. */
internal object KotlinCode {
    /** Code that makes [lights] and sets the [scene]'s numbers. */
    fun of(
        scene: Scene,
        lights: List<TunedLight>,
    ): String =
        buildString {
            appendLine("// The scene as the panel was turned: sheet ${scene.step.sheet}, t = ${scene.time} s")
            for (light in lights) appendLine("val ${light.name} = ${light.inspected.code()}")
            appendLine("scene.ambient = ${literal(scene.ambient)}")
            appendLine("scene.gamma = ${literal(scene.gamma)}")
            for ((name, model) in listOf("ground" to scene.ground, "motorcycle" to scene.motorcycle)) {
                appendLine("// exponents k of the $name's meshes")
                val exponents = model.meshes.joinToString { literal(it.material?.shininess ?: 0f) }
                appendLine("$name.meshes.zip(listOf($exponents)) { mesh, k -> mesh.material?.shininess = k }")
            }
        }
}
