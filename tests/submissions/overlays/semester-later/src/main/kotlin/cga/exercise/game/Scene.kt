package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.LightManager
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*

class Scene(private val window: GameWindow) {

    private val tronShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val ground: Renderable
    private val motorcycle: Renderable
    private val camera = TronCamera()

    private val lightManager = LightManager()
    private val bikeLight: PointLight
    private val headlight: SpotLight

    private var firstMouseEvent = true
    private var lastMouseX = 0.0

    init {
        initOpenGL()

        ground = createGround()
        motorcycle = createMotorcycle()

        camera.parent = motorcycle
        camera.rotate(Math.toRadians(-28.0f), 0.0f, 0.0f)
        camera.translate(Vector3f(0.0f, 0.3f, 4.8f))

        // light that surrounds the motorcycle
        bikeLight = PointLight(Vector3f(0.0f, 1.6f, 0.3f), Vector3f(1.0f))
        bikeLight.parent = motorcycle
        lightManager.addPointLight(bikeLight)

        // headlight
        headlight = SpotLight(
            Vector3f(0.0f, 1.1f, -1.6f),
            Vector3f(15.0f, 15.0f, 13.0f),
            Math.toRadians(14.0f),
            Math.toRadians(26.0f)
        )
        headlight.rotate(Math.toRadians(-12.0f), 0.0f, 0.0f)
        headlight.parent = motorcycle
        lightManager.setHeadlight(headlight)

        // one light for each corner of the ground
        createCornerLights()

        GLError.checkThrow("Scene.init")
    }

    private fun initOpenGL() {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)
    }

    private fun createGround(): Renderable {
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attributes = arrayOf(
            VertexAttribute(3, BYTES_PER_VERTEX, 0),
            VertexAttribute(2, BYTES_PER_VERTEX, 12),
            VertexAttribute(3, BYTES_PER_VERTEX, 20)
        )
        val material = Material(
            diff = loadTexture("ground_diff"),
            emit = loadTexture("ground_emit"),
            specular = loadTexture("ground_spec"),
            shininess = 60.0f,
            tcMultiplier = Vector2f(64.0f)
        )
        val result = Renderable()
        result.meshes.add(Mesh(obj.vertexData, obj.indexData, attributes, material))
        result.glowTint = Vector3f(0.0f, 1.0f, 0.0f)
        return result
    }

    private fun createMotorcycle(): Renderable {
        val result = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            ?: throw IllegalStateException("The motorcycle could not be loaded")
        result.scale(Vector3f(0.8f))
        return result
    }

    private fun createCornerLights() {
        val colors = arrayOf(
            Vector3f(20.0f, 2.0f, 1.0f),
            Vector3f(1.0f, 3.0f, 20.0f),
            Vector3f(18.0f, 1.0f, 18.0f),
            Vector3f(16.0f, 15.0f, 1.0f)
        )
        var index = 0
        for (x in intArrayOf(-1, 1)) {
            for (z in intArrayOf(-1, 1)) {
                val position = Vector3f(x * CORNER, 1.7f, z * CORNER)
                lightManager.addPointLight(PointLight(position, colors[index]))
                index++
            }
        }
    }

    private fun loadTexture(name: String): Texture2D {
        val texture = Texture2D("assets/textures/$name.png", true)
        texture.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return texture
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        updateBikeColor(t)

        val viewMatrix = camera.getCalculateViewMatrix()
        tronShader.use()
        camera.bind(tronShader)
        lightManager.bindAll(tronShader, viewMatrix)

        ground.render(tronShader, viewMatrix)
        motorcycle.render(tronShader, viewMatrix)
    }

    /** The motorcycle and its light always have the same color. */
    private fun updateBikeColor(t: Float) {
        val color = Vector3f(wave(t * 1.1f), wave(t * 0.7f + 2.0f), wave(t * 1.6f + 4.0f))
        motorcycle.glowTint = color
        bikeLight.color.set(color)
    }

    /** sine between 0 and 1 */
    private fun wave(x: Float): Float {
        return (Math.sin(x) + 1.0f) / 2.0f
    }

    fun update(dt: Float, t: Float) {
        val forward = window.getKeyState(GLFW_KEY_W)
        val backward = window.getKeyState(GLFW_KEY_S)
        if (forward == backward) {
            return
        }
        val direction = if (forward) 1.0f else -1.0f

        if (window.getKeyState(GLFW_KEY_A)) {
            motorcycle.rotate(0.0f, direction * TURN_SPEED * dt, 0.0f)
        }
        if (window.getKeyState(GLFW_KEY_D)) {
            motorcycle.rotate(0.0f, -direction * TURN_SPEED * dt, 0.0f)
        }
        motorcycle.translate(Vector3f(0.0f, 0.0f, -direction * SPEED * dt))
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        // nothing to do, see update()
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMouseEvent) {
            firstMouseEvent = false
            lastMouseX = xpos
            return
        }
        val yaw = (lastMouseX - xpos).toFloat() * MOUSE_FACTOR
        lastMouseX = xpos
        // the camera is a child of the motorcycle, so the origin is the motorcycle
        camera.rotateAroundPoint(0.0f, yaw, 0.0f, Vector3f(0.0f))
    }

    fun cleanup() {
        ground.cleanup()
        motorcycle.cleanup()
        tronShader.cleanup()
    }

    private companion object {
        const val BYTES_PER_VERTEX = 8 * Float.SIZE_BYTES
        const val CORNER = 17.0f
        const val SPEED = 6.0f
        const val TURN_SPEED = 1.5f
        const val MOUSE_FACTOR = 0.002f
    }
}
