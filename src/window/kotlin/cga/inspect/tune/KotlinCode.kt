package cga.inspect.tune

import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.game.Scene
import org.joml.Vector2f
import org.joml.Vector3fc

/** What the panel was turned to, as Kotlin code in the course's own classes. */
internal object KotlinCode {
    /** Code that makes [lights] and sets the [scene]'s numbers. */
    fun of(
        scene: Scene,
        lights: List<TunedLight>,
    ): String =
        buildString {
            appendLine("// The scene as the panel was turned: sheet ${scene.step.sheet}, t = ${scene.time} s")
            for (light in lights) appendLine("val ${light.name} = ${light.light.code()}")
            appendLine("scene.ambient = ${code(scene.ambient)}")
            appendLine("scene.gamma = ${code(scene.gamma)}")
            for ((name, model) in listOf("ground" to scene.ground, "motorcycle" to scene.motorcycle)) {
                appendLine("// exponents k of the $name's meshes")
                val exponents = model.meshes.joinToString { code(it.material?.shininess ?: 0f) }
                appendLine("$name.meshes.zip(listOf($exponents)) { mesh, k -> mesh.material?.shininess = k }")
            }
        }

    private fun PointLight.code(): String =
        if (this is SpotLight) {
            val cone = getCone(Vector2f())
            "SpotLight(${code(getPosition())}, ${code(lightColor)}, ${code(cone.x)}, ${code(cone.y)}, ${code(attenuation)})" +
                " // ${LightKnobs.degrees(cone.x)}° and ${LightKnobs.degrees(cone.y)}°"
        } else {
            "PointLight(${code(getPosition())}, ${code(lightColor)}, ${code(attenuation)})"
        }

    private fun code(vector: Vector3fc) = "Vector3f(${code(vector.x())}, ${code(vector.y())}, ${code(vector.z())})"

    // Kotlin's own text of a Float, which is read back as the same number.
    private fun code(number: Float) = "${number}f"
}
