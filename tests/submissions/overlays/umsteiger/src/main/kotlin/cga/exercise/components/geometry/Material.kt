package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

class Material {
    private var m_diffuse: Texture2D
    private var m_emissive: Texture2D
    private var m_specular: Texture2D
    private var m_shininess: Float
    private var m_tcMultiplier: Vector2f

    constructor(diff: Texture2D, emit: Texture2D, specular: Texture2D, shininess: Float = 50.0f, tcMultiplier: Vector2f = Vector2f(1.0f)) {
        this.m_diffuse = diff
        this.m_emissive = emit
        this.m_specular = specular
        this.m_shininess = shininess
        this.m_tcMultiplier = tcMultiplier
    }

    fun bind(shaderProgram: ShaderProgram) {
        bindTexture(shaderProgram, "Emissive", m_emissive, 0)
        bindTexture(shaderProgram, "Diffuse", m_diffuse, 1)
        bindTexture(shaderProgram, "Specular", m_specular, 2)
        shaderProgram.setUniform("uShininess", m_shininess)
        shaderProgram.setUniform("uTcMultiplier", m_tcMultiplier)
    }

    private fun bindTexture(shaderProgram: ShaderProgram, kind: String, texture: Texture2D, unit: Int) {
        texture.bind(unit)
        shaderProgram.setUniform("uTex" + kind, unit)
    }
}
