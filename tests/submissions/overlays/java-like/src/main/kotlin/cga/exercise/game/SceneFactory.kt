package cga.exercise.game

import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.texture.Texture2D
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.opengl.GL11.*

class SceneFactory private constructor() {

    companion object {

        private const val FLOAT_SIZE: Int = 4

        fun createGround(): Renderable {
            val data = OBJLoader.loadOBJ("assets/models/ground.obj")
            val attributes: Array<VertexAttribute> = arrayOf(
                VertexAttribute(3, 8 * FLOAT_SIZE, 0),
                VertexAttribute(2, 8 * FLOAT_SIZE, 3 * FLOAT_SIZE),
                VertexAttribute(3, 8 * FLOAT_SIZE, 5 * FLOAT_SIZE)
            )
            val material = Material(
                createTexture("assets/textures/ground_diff.png"),
                createTexture("assets/textures/ground_emit.png"),
                createTexture("assets/textures/ground_spec.png"),
                60.0f,
                Vector2f(64.0f, 64.0f)
            )
            val ground = Renderable()
            ground.meshes.add(Mesh(data.vertexData, data.indexData, attributes, material))
            return ground
        }

        fun createMotorcycle(): Renderable {
            val motorcycle: Renderable? = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            if (motorcycle == null) {
                throw RuntimeException("motorcycle.obj could not be loaded")
            }
            motorcycle.scaleLocal(Vector3f(0.8f, 0.8f, 0.8f))
            return motorcycle
        }

        fun createCornerLights(): ArrayList<PointLight> {
            val lights = ArrayList<PointLight>()
            lights.add(PointLight(Vector3f(18.0f, 2.0f, 18.0f), Vector3f(6.0f, 0.6f, 0.0f)))
            lights.add(PointLight(Vector3f(18.0f, 2.0f, -18.0f), Vector3f(0.0f, 6.0f, 0.6f)))
            lights.add(PointLight(Vector3f(-18.0f, 2.0f, 18.0f), Vector3f(0.6f, 0.0f, 6.0f)))
            lights.add(PointLight(Vector3f(-18.0f, 2.0f, -18.0f), Vector3f(5.0f, 5.0f, 0.0f)))
            return lights
        }

        private fun createTexture(path: String): Texture2D {
            val texture = Texture2D(path, true)
            texture.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
            return texture
        }
    }
}
