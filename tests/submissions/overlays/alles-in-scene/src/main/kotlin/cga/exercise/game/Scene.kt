package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.Transformable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW
import org.lwjgl.opengl.GL11.*

class Scene(private val window: GameWindow) {
    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")
    private val bike: Renderable
    private val boden: Renderable
    private val cam = TronCamera()
    // leeres Objekt in der Mitte vom Motorrad, die Kamera hängt daran
    private val pivot = Transformable()

    private val light1: PointLight
    private val light2: SpotLight
    private val light3 = PointLight(Vector3f(-18.0f, 2.0f, -18.0f), Vector3f(9.0f, 0.0f, 0.0f))
    private val light4 = PointLight(Vector3f(18.0f, 2.0f, -18.0f), Vector3f(0.0f, 0.0f, 9.0f))
    private val light5 = PointLight(Vector3f(-18.0f, 2.0f, 18.0f), Vector3f(8.0f, 8.0f, 0.0f))
    private val light6 = PointLight(Vector3f(18.0f, 2.0f, 18.0f), Vector3f(6.0f, 0.0f, 9.0f))

    private var oldX = 0.0
    private var oldY = 0.0
    private var firstMouse = true

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)

        // Boden
        val diff = Texture2D("assets/textures/ground_diff.png", true)
        diff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val emit = Texture2D("assets/textures/ground_emit.png", true)
        emit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val spec = Texture2D("assets/textures/ground_spec.png", true)
        spec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val mat = Material(diff, emit, spec, 60.0f, Vector2f(64.0f, 64.0f))
        val res = OBJLoader.loadOBJ("assets/models/ground.obj")
        val pos = VertexAttribute(3, 32, 0)
        val tex = VertexAttribute(2, 32, 12)
        val norm = VertexAttribute(3, 32, 20)
        boden = Renderable(mutableListOf(Mesh(res.vertexData, res.indexData, arrayOf(pos, tex, norm), mat)))

        // Motorrad
        bike = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)!!
        bike.scaleLocal(Vector3f(0.8f, 0.8f, 0.8f))

        // Kamera -> Pivot -> Motorrad
        pivot.parent = bike
        cam.parent = pivot
        cam.rotateLocal(Math.toRadians(-30.0f), 0.0f, 0.0f)
        cam.translateLocal(Vector3f(0.0f, 0.5f, 4.5f))

        // Lichter am Motorrad
        light1 = PointLight(Vector3f(0.0f, 1.6f, 0.5f), Vector3f(1.0f, 1.0f, 1.0f))
        light1.parent = bike
        light2 = SpotLight(Vector3f(0.0f, 1.0f, -1.9f), Vector3f(3.0f, 3.0f, 3.0f), Math.toRadians(15.0f), Math.toRadians(28.0f))
        light2.rotateLocal(Math.toRadians(-12.0f), 0.0f, 0.0f)
        light2.parent = bike
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        shader.use()

        // Kamera
        shader.setUniform("view", cam.getCalculateViewMatrix(), false)
        shader.setUniform("projection", cam.getCalculateProjectionMatrix(), false)

        // Farbe vom Motorrad und von Licht 1
        val r = (Math.sin(t) + 1.0f) / 2.0f
        val g = (Math.sin(t * 0.7f) + 1.0f) / 2.0f
        val b = (Math.sin(t * 1.3f + 2.0f) + 1.0f) / 2.0f
        light1.farbe = Vector3f(r, g, b)

        // Lichter
        light1.bind(shader, "light1")
        light2.bind(shader, "light2", cam.getCalculateViewMatrix())
        light3.bind(shader, "light3")
        light4.bind(shader, "light4")
        light5.bind(shader, "light5")
        light6.bind(shader, "light6")

        // Boden
        shader.setUniform("farbe", Vector3f(0.0f, 1.0f, 0.0f))
        shader.setUniform("model", boden.getWorldModelMatrix(), false)
        for (m in boden.meshes) m.render(shader)

        // Motorrad
        shader.setUniform("farbe", Vector3f(r, g, b))
        shader.setUniform("model", bike.getWorldModelMatrix(), false)
        for (m in bike.meshes) m.render(shader)
    }

    fun update(dt: Float, t: Float) {
        if (window.getKeyState(GLFW.GLFW_KEY_W)) {
            bike.translateLocal(Vector3f(0.0f, 0.0f, -6.0f * dt))
            if (window.getKeyState(GLFW.GLFW_KEY_A)) bike.rotateLocal(0.0f, 1.5f * dt, 0.0f)
            if (window.getKeyState(GLFW.GLFW_KEY_D)) bike.rotateLocal(0.0f, -1.5f * dt, 0.0f)
        }
        if (window.getKeyState(GLFW.GLFW_KEY_S)) {
            bike.translateLocal(Vector3f(0.0f, 0.0f, 6.0f * dt))
            if (window.getKeyState(GLFW.GLFW_KEY_A)) bike.rotateLocal(0.0f, -1.5f * dt, 0.0f)
            if (window.getKeyState(GLFW.GLFW_KEY_D)) bike.rotateLocal(0.0f, 1.5f * dt, 0.0f)
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMouse) {
            oldX = xpos
            oldY = ypos
            firstMouse = false
        }
        val dx = xpos - oldX
        oldX = xpos
        oldY = ypos
        pivot.rotateLocal(0.0f, (dx * -0.002).toFloat(), 0.0f)
    }

    fun cleanup() {
        boden.cleanup()
        bike.cleanup()
        shader.cleanup()
    }
}
