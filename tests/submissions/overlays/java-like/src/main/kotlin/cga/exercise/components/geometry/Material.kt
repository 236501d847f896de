package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.UniformSender
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

class Material {

    private var diffuseTexture: Texture2D
    private var emissiveTexture: Texture2D
    private var specularTexture: Texture2D
    private var shininess: Float
    private var textureRepeat: Vector2f

    constructor(diffuseTexture: Texture2D, emissiveTexture: Texture2D, specularTexture: Texture2D, shininess: Float) :
            this(diffuseTexture, emissiveTexture, specularTexture, shininess, Vector2f(1.0f, 1.0f))

    constructor(diffuseTexture: Texture2D, emissiveTexture: Texture2D, specularTexture: Texture2D, shininess: Float, textureRepeat: Vector2f) {
        this.diffuseTexture = diffuseTexture
        this.emissiveTexture = emissiveTexture
        this.specularTexture = specularTexture
        this.shininess = shininess
        this.textureRepeat = textureRepeat
    }

    fun getDiffuseTexture(): Texture2D {
        return this.diffuseTexture
    }

    fun getEmissiveTexture(): Texture2D {
        return this.emissiveTexture
    }

    fun getSpecularTexture(): Texture2D {
        return this.specularTexture
    }

    fun getShininess(): Float {
        return this.shininess
    }

    fun getTextureRepeat(): Vector2f {
        return this.textureRepeat
    }

    fun bind(shaderProgram: ShaderProgram) {
        UniformSender.sendMaterial(shaderProgram, this)
    }
}
