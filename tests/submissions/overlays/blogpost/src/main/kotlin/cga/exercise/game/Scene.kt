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
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math.toRadians
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val lightingShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val ground: Renderable
    private val motorcycle: Renderable
    private val camera: TronCamera

    private val pointLights: Array<PointLight>
    private val spotLight: SpotLight

    // mouse
    private var firstMouse = true
    private var lastX = 0.0

    init {
        // configure global opengl state
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_DEPTH_TEST)
        glEnable(GL_CULL_FACE)

        // load models
        val diffuseMap = loadTexture("assets/textures/ground_diff.png")
        val specularMap = loadTexture("assets/textures/ground_spec.png")
        val emissionMap = loadTexture("assets/textures/ground_emit.png")
        val groundMaterial = Material(diffuseMap, emissionMap, specularMap, 64.0f, Vector2f(64.0f, 64.0f))
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attributes = arrayOf(
            VertexAttribute(3, 8 * 4, 0),
            VertexAttribute(2, 8 * 4, 3 * 4),
            VertexAttribute(3, 8 * 4, 5 * 4)
        )
        ground = Renderable(mutableListOf(Mesh(obj.vertexData, obj.indexData, attributes, groundMaterial)))

        val model = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
        motorcycle = model ?: throw IllegalStateException("could not load the motorcycle")
        motorcycle.scaleLocal(Vector3f(0.8f, 0.8f, 0.8f))

        camera = TronCamera(motorcycle)

        // the first point light belongs to the motorcycle, the others are in the corners
        pointLights = arrayOf(
            PointLight(Vector3f(0.0f, 1.6f, 0.2f), Vector3f(1.0f, 1.0f, 1.0f)),
            PointLight(Vector3f(-12.0f, 1.2f, -12.0f), Vector3f(7.0f, 1.0f, 0.0f)),
            PointLight(Vector3f(12.0f, 1.2f, -12.0f), Vector3f(0.0f, 2.0f, 7.0f)),
            PointLight(Vector3f(12.0f, 1.2f, 12.0f), Vector3f(6.0f, 0.0f, 6.0f)),
            PointLight(Vector3f(-12.0f, 1.2f, 12.0f), Vector3f(0.0f, 6.0f, 5.0f))
        )
        pointLights[0].parent = motorcycle

        spotLight = SpotLight(
            Vector3f(0.0f, 1.0f, -1.8f),
            Vector3f(4.0f, 4.0f, 3.6f),
            toRadians(15.0f),
            toRadians(24.0f)
        )
        spotLight.rotateLocal(toRadians(-9.0f), 0.0f, 0.0f)
        spotLight.parent = motorcycle

        GLError.checkThrow()
    }

    private fun loadTexture(path: String): Texture2D {
        val texture = Texture2D(path, true)
        texture.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return texture
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        val bikeColor = Vector3f(
            0.55f + 0.45f * sin(t * 2.0f),
            0.55f + 0.45f * sin(t * 0.7f),
            0.55f + 0.45f * sin(t * 1.3f)
        )
        pointLights[0].lightColor = bikeColor

        // be sure to activate shader when setting uniforms/drawing objects
        lightingShader.use()
        camera.bind(lightingShader)
        lightingShader.setUniform("ambientColor", Vector3f(0.04f))
        for (i in pointLights.indices) {
            pointLights[i].bind(lightingShader, "pointLights[$i]")
        }
        spotLight.bind(lightingShader, "spotLight", camera.getCalculateViewMatrix())

        lightingShader.setUniform("emissionColor", bikeColor)
        motorcycle.render(lightingShader)

        lightingShader.setUniform("emissionColor", Vector3f(0.0f, 1.0f, 0.0f))
        ground.render(lightingShader)
    }

    fun update(dt: Float, t: Float) {
        processInput(dt)
    }

    private fun processInput(deltaTime: Float) {
        val velocity = 5.0f * deltaTime
        val turn = 1.5f * deltaTime
        if (window.getKeyState(GLFW_KEY_W)) {
            motorcycle.translateLocal(Vector3f(0.0f, 0.0f, -velocity))
            if (window.getKeyState(GLFW_KEY_A)) motorcycle.rotateLocal(0.0f, turn, 0.0f)
            if (window.getKeyState(GLFW_KEY_D)) motorcycle.rotateLocal(0.0f, -turn, 0.0f)
        }
        if (window.getKeyState(GLFW_KEY_S)) {
            motorcycle.translateLocal(Vector3f(0.0f, 0.0f, velocity))
            if (window.getKeyState(GLFW_KEY_A)) motorcycle.rotateLocal(0.0f, -turn, 0.0f)
            if (window.getKeyState(GLFW_KEY_D)) motorcycle.rotateLocal(0.0f, turn, 0.0f)
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMouse) {
            lastX = xpos
            firstMouse = false
        }
        val xoffset = xpos - lastX
        lastX = xpos

        val sensitivity = 0.002f
        camera.yaw -= xoffset.toFloat() * sensitivity
    }

    fun cleanup() {
        ground.cleanup()
        motorcycle.cleanup()
        lightingShader.cleanup()
    }
}
