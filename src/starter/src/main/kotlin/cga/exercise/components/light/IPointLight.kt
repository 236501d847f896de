package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram

// solution 4.2.1: write the class PointLight, in a file of its own in this folder. It is a Transformable and an IPointLight.
// Lösung 4.2.1: Schreiben Sie die Klasse PointLight in eine eigene Datei in diesem Ordner: ein Transformable und ein IPointLight.
// end of solution
interface IPointLight {
    /** Sends the light to the shaders, which know it by [name]. */
    fun bind(shaderProgram: ShaderProgram, name: String)
}
