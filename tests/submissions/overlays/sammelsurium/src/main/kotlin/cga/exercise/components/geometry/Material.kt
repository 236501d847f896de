package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

class Material(var diff: Texture2D,
               var emit: Texture2D,
               var specular: Texture2D,
               var shininess: Float = 50.0f,
               var tcMultiplier: Vector2f = Vector2f(1.0f)) {

    fun bind(shaderProgram: ShaderProgram) {
        //wichtig: erst alle Texturen binden, dann die Sampler setzen
        diff.bind(0)
        specular.bind(1)
        emit.bind(2)

        shaderProgram.setUniform("diffTex", 0)
        shaderProgram.setUniform("specTex", 1)
        shaderProgram.setUniform("emitTex", 2)
        shaderProgram.setUniform("shininess", shininess)
        shaderProgram.setUniform("tcMultiplier", tcMultiplier)
    }
}
