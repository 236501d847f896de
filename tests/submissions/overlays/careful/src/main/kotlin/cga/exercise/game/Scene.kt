package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math.toRadians
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.sin

/** The ground, the motorcycle and the lights. */
class Scene(private val window: GameWindow) {
    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val ground = createGround()
    private val motorcycle = createMotorcycle()
    private val camera = createCamera()

    // the motorcycle's light is the first of all point lights
    private val motorcycleLight = createMotorcycleLight()
    private val pointLights = listOf(motorcycleLight) + createCornerLights()
    private val headlight = createHeadlight()

    /** Where the mouse was at the last event, null before the first one. */
    private var lastMouseX: Double? = null

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)
    }

    // ---------------------------------------------------------------- creation

    private fun createGround(): Renderable {
        val material = Material(
            loadTexture("assets/textures/ground_diff.png"),
            loadTexture("assets/textures/ground_emit.png"),
            loadTexture("assets/textures/ground_spec.png"),
            GROUND_SHININESS,
            Vector2f(GROUND_TILES, GROUND_TILES)
        )
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val stride = 8 * Float.SIZE_BYTES
        val attributes = arrayOf(
            VertexAttribute(3, stride, 0),                      // position
            VertexAttribute(2, stride, 3 * Float.SIZE_BYTES),   // texture coordinate
            VertexAttribute(3, stride, 5 * Float.SIZE_BYTES)    // normal
        )
        return Renderable(mutableListOf(Mesh(obj.vertexData, obj.indexData, attributes, material)))
    }

    private fun createMotorcycle(): Renderable {
        val model = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
        requireNotNull(model) { "motorcycle.obj could not be loaded" }
        model.scaleLocal(Vector3f(0.8f))
        return model
    }

    private fun createCamera(): TronCamera {
        val camera = TronCamera()
        camera.parent = motorcycle
        camera.rotateLocal(toRadians(-30.0f), 0.0f, 0.0f)
        camera.translateLocal(Vector3f(0.0f, 0.0f, 5.0f))
        return camera
    }

    /** Above the motorcycle, so that the ground gets some of it as well. */
    private fun createMotorcycleLight(): PointLight {
        val light = PointLight(Vector3f(0.0f, 1.7f, 0.4f), motorcycleColor(0.0f))
        light.parent = motorcycle
        return light
    }

    private fun createHeadlight(): SpotLight {
        val light = SpotLight(Vector3f(0.0f, 1.1f, -1.7f), HEADLIGHT_COLOR, toRadians(INNER_DEGREES), toRadians(OUTER_DEGREES))
        light.rotateLocal(toRadians(-14.0f), 0.0f, 0.0f)
        light.parent = motorcycle
        return light
    }

    /** One light in each corner of the ground. */
    private fun createCornerLights(): List<PointLight> {
        return listOf(
            PointLight(Vector3f(CORNER, LIGHT_HEIGHT, CORNER), Vector3f(7.0f, 1.0f, 0.0f)),
            PointLight(Vector3f(CORNER, LIGHT_HEIGHT, -CORNER), Vector3f(0.0f, 3.0f, 8.0f)),
            PointLight(Vector3f(-CORNER, LIGHT_HEIGHT, CORNER), Vector3f(6.0f, 0.0f, 6.0f)),
            PointLight(Vector3f(-CORNER, LIGHT_HEIGHT, -CORNER), Vector3f(6.0f, 6.0f, 1.0f))
        )
    }

    private fun loadTexture(path: String): Texture2D {
        val texture = Texture2D(path, true)
        texture.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return texture
    }

    // ---------------------------------------------------------------- drawing

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        val color = motorcycleColor(t)
        motorcycleLight.lightColor = color

        // first everything that all objects need, then the objects
        shader.use()
        camera.bind(shader)
        bindLights()
        renderTinted(ground, GROUND_COLOR)
        renderTinted(motorcycle, color)
    }

    private fun bindLights() {
        shader.setUniform("numPointLights", pointLights.size)
        for ((index, light) in pointLights.withIndex()) {
            light.bind(shader, index.toString())
        }
        headlight.bind(shader, "spotLight", camera.getCalculateViewMatrix())
    }

    private fun renderTinted(renderable: Renderable, tint: Vector3f) {
        shader.setUniform("emissiveTint", tint)
        renderable.render(shader)
    }

    /** Red, green and blue swing one after the other, so that it is never black. */
    private fun motorcycleColor(t: Float): Vector3f {
        return Vector3f(swing(t), swing(t + 2.1f), swing(t + 4.2f))
    }

    /** From 0 to 1 and back. */
    private fun swing(x: Float): Float {
        return 0.5f + 0.5f * sin(x)
    }

    // ---------------------------------------------------------------- input

    fun update(dt: Float, t: Float) {
        if (window.getKeyState(GLFW_KEY_W)) drive(SPEED * dt)
        if (window.getKeyState(GLFW_KEY_S)) drive(-SPEED * dt)
    }

    /** Forwards or, with a negative distance, backwards; steers with A and D. */
    private fun drive(distance: Float) {
        if (window.getKeyState(GLFW_KEY_A)) motorcycle.rotateLocal(0.0f, STEERING * distance, 0.0f)
        if (window.getKeyState(GLFW_KEY_D)) motorcycle.rotateLocal(0.0f, -STEERING * distance, 0.0f)
        motorcycle.translateLocal(Vector3f(0.0f, 0.0f, -distance))
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    /** Turns the camera about the motorcycle, which is its parent: so the pivot is the origin. */
    fun onMouseMove(xpos: Double, ypos: Double) {
        val deltaX = xpos - (lastMouseX ?: xpos)
        lastMouseX = xpos
        val yaw = -(deltaX * MOUSE_SENSITIVITY).toFloat()
        camera.rotateAroundPoint(0.0f, yaw, 0.0f, PIVOT)
    }

    fun cleanup() {
        ground.cleanup()
        motorcycle.cleanup()
        shader.cleanup()
    }

    companion object {
        private const val GROUND_SHININESS = 60.0f
        private const val GROUND_TILES = 64.0f
        private val GROUND_COLOR = Vector3f(0.0f, 1.0f, 0.0f)

        private val HEADLIGHT_COLOR = Vector3f(3.0f, 3.0f, 2.5f)
        private const val INNER_DEGREES = 15.0f
        private const val OUTER_DEGREES = 28.0f
        private const val CORNER = 13.0f
        private const val LIGHT_HEIGHT = 2.0f

        private const val SPEED = 6.0f
        private const val STEERING = 0.25f
        private const val MOUSE_SENSITIVITY = 0.002
        private val PIVOT = Vector3f(0.0f)
    }
}
