package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f

// solution 4.3.1: write the class SpotLight, in a file of its own in this folder. It is a PointLight and an ISpotLight.
// Lösung 4.3.1: Schreiben Sie die Klasse SpotLight in eine eigene Datei in diesem Ordner: ein PointLight und ein ISpotLight.
// end of solution
interface ISpotLight {
    /** Sends the light to the shaders, which know it by [name]; its direction through [viewMatrix]. */
    fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f)
}
