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
import org.joml.Math
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW
import org.lwjgl.opengl.GL30.*
import kotlin.math.cos
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    // has to be the same as in tron_frag.glsl
    private val NR_CORNER_LAMPS = 4

    private val lightingShader: ShaderProgram

    private val ground = Renderable()
    private val motorcycle: Renderable
    private val camera = TronCamera()

    private val bikeLamp: PointLight
    private val headLamp: SpotLight

    private val cornerPositions = arrayOf(
        Vector3f(15.0f, 1.8f, 15.0f),
        Vector3f(15.0f, 1.8f, -15.0f),
        Vector3f(-15.0f, 1.8f, -15.0f),
        Vector3f(-15.0f, 1.8f, 15.0f)
    )
    private val cornerColors = arrayOf(
        Vector3f(9.0f, 8.0f, 0.6f),
        Vector3f(9.0f, 0.4f, 2.0f),
        Vector3f(0.3f, 3.0f, 10.0f),
        Vector3f(7.0f, 0.5f, 9.0f)
    )
    private val cornerLamps = ArrayList<PointLight>()

    // mouse
    private var firstMouse = true
    private var lastX = 0.0

    init {
        lightingShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

        // configure global opengl state
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)

        // ground
        val groundMaterial = Material(
            loadTexture("assets/textures/ground_diff.png"),
            loadTexture("assets/textures/ground_emit.png"),
            loadTexture("assets/textures/ground_spec.png"),
            60.0f,
            Vector2f(64.0f)
        )
        val stride = 8 * Float.SIZE_BYTES
        val attributes = arrayOf(
            VertexAttribute(3, stride, 0),
            VertexAttribute(2, stride, 3 * Float.SIZE_BYTES),
            VertexAttribute(3, stride, 5 * Float.SIZE_BYTES)
        )
        val plane = OBJLoader.loadOBJ("assets/models/ground.obj")
        ground.meshes.add(Mesh(plane.vertexData, plane.indexData, attributes, groundMaterial))
        ground.emissionTint = Vector3f(0.0f, 1.0f, 0.0f)

        // motorcycle
        motorcycle = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            ?: throw RuntimeException("ERROR::MODEL::motorcycle not loaded")
        motorcycle.scaleLocal(Vector3f(0.8f))

        // camera, hangs on the motorcycle
        camera.parent = motorcycle
        camera.translateLocal(Vector3f(0.0f, 2.4f, 3.4f))
        camera.rotateLocal(Math.toRadians(-28.0f), 0.0f, 0.0f)

        // lights
        bikeLamp = PointLight(Vector3f(0.0f, 1.7f, 0.3f), Vector3f(1.0f))
        bikeLamp.parent = motorcycle

        headLamp = SpotLight(
            Vector3f(0.0f, 1.0f, -1.9f), Vector3f(2.2f, 2.2f, 2.0f),
            Math.toRadians(12.5f), Math.toRadians(22.5f)
        )
        headLamp.rotateLocal(Math.toRadians(-14.0f), 0.0f, 0.0f)
        headLamp.parent = motorcycle

        for (i in 0 until NR_CORNER_LAMPS) {
            cornerLamps.add(PointLight(cornerPositions[i], cornerColors[i]))
        }

        GLError.checkThrow("Scene.init")
    }

    private fun loadTexture(path: String): Texture2D {
        val texture = Texture2D(path, true)
        texture.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return texture
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        // colour of the motorcycle and its light
        val bikeColor = Vector3f(
            sin(t * 0.8f) * 0.4f + 0.6f,
            cos(t * 1.1f) * 0.4f + 0.6f,
            sin(t * 0.5f + 2.0f) * 0.4f + 0.6f
        )
        motorcycle.emissionTint = bikeColor
        bikeLamp.color = bikeColor

        // don't forget to use the shader before setting uniforms
        lightingShader.use()
        camera.bind(lightingShader)
        bikeLamp.bind(lightingShader, "bikeLamp")
        headLamp.bind(lightingShader, "headLamp", camera.getCalculateViewMatrix())
        for (i in 0 until NR_CORNER_LAMPS) {
            cornerLamps[i].bind(lightingShader, "cornerLamps[$i]")
        }

        // draw
        ground.render(lightingShader)
        motorcycle.render(lightingShader)
    }

    fun update(dt: Float, t: Float) {
        val distance = 6.0f * dt
        val angle = Math.toRadians(80.0f) * dt

        if (window.getKeyState(GLFW.GLFW_KEY_W)) {
            motorcycle.translateLocal(Vector3f(0.0f, 0.0f, -distance))
            steer(angle)
        } else if (window.getKeyState(GLFW.GLFW_KEY_S)) {
            motorcycle.translateLocal(Vector3f(0.0f, 0.0f, distance))
            steer(-angle)
        }
    }

    private fun steer(angle: Float) {
        if (window.getKeyState(GLFW.GLFW_KEY_A)) motorcycle.rotateLocal(0.0f, angle, 0.0f)
        if (window.getKeyState(GLFW.GLFW_KEY_D)) motorcycle.rotateLocal(0.0f, -angle, 0.0f)
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMouse) {
            lastX = xpos
            firstMouse = false
        }

        var xoffset = xpos - lastX
        lastX = xpos

        val sensitivity = 0.002
        xoffset *= sensitivity

        // (0, 0, 0) is the motorcycle, because it is the parent of the camera
        camera.rotateAroundPoint(0.0f, -xoffset.toFloat(), 0.0f, Vector3f(0.0f, 0.0f, 0.0f))
    }

    fun cleanup() {
        ground.cleanup()
        motorcycle.cleanup()
        lightingShader.cleanup()
    }
}
