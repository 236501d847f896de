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
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*

class Scene(private val window: GameWindow) {
    private val staticShader: ShaderProgram
    private val ground: Renderable
    private val cycle: Renderable
    private val camera: TronCamera
    private val light1: PointLight
    private val light2: SpotLight
    private val light3: PointLight
    private val light4: PointLight
    private val light5: PointLight

    private var oldX = 0.0
    private var oldY = 0.0
    private var firstMove = true

    //scene setup
    init {
        staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

        //initial opengl state
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        val res = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attr1 = VertexAttribute(3, 8 * 4, 0)
        val attr2 = VertexAttribute(2, 8 * 4, 3 * 4)
        val attr3 = VertexAttribute(3, 8 * 4, 5 * 4)
        val texEmit = Texture2D("assets/textures/ground_emit.png", true)
        val texDiff = Texture2D("assets/textures/ground_diff.png", true)
        val texSpec = Texture2D("assets/textures/ground_spec.png", true)
        texEmit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        texDiff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        texSpec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundMat = Material(texDiff, texEmit, texSpec, 60.0f, Vector2f(64.0f, 64.0f))
        val groundMesh = Mesh(res.vertexData, res.indexData, arrayOf(attr1, attr2, attr3), groundMat)
        ground = Renderable(mutableListOf(groundMesh))

        cycle = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)!!
        cycle.scaleLocal(Vector3f(0.8f, 0.8f, 0.8f))
        //cycle.rotateLocal(0f, Math.toRadians(180f), 0f)

        camera = TronCamera()
        camera.parent = cycle
        camera.rotateLocal(Math.toRadians(-20.0f), 0.0f, 0.0f)
        camera.translateLocal(Vector3f(0.0f, 0.5f, 5.0f))

        light1 = PointLight(Vector3f(0.0f, 2.0f, 0.0f), Vector3f(1.0f, 0.0f, 1.0f))
        light1.parent = cycle

        light2 = SpotLight(Vector3f(0.0f, 1.0f, -2.0f), Vector3f(2.0f, 2.0f, 2.0f), Math.toRadians(15.0f), Math.toRadians(30.0f))
        light2.rotateLocal(Math.toRadians(-12.0f), 0.0f, 0.0f)
        light2.parent = cycle

        light3 = PointLight(Vector3f(10.0f, 2.0f, -10.0f), Vector3f(5.0f, 0.0f, 0.0f))
        light4 = PointLight(Vector3f(-10.0f, 2.0f, -10.0f), Vector3f(0.0f, 0.0f, 5.0f))
        light5 = PointLight(Vector3f(0.0f, 2.0f, 12.0f), Vector3f(5.0f, 5.0f, 0.0f))
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        staticShader.use()
        camera.bind(staticShader)

        val r = Math.sin(t) * 0.5f + 0.5f
        val g = Math.sin(t + 2.0f) * 0.5f + 0.5f
        val b = Math.sin(t + 4.0f) * 0.5f + 0.5f
        val farbe = Vector3f(r, g, b)
        light1.lightCol = farbe

        light1.bind(staticShader, "light1")
        light2.bind(staticShader, "light2", camera.getCalculateViewMatrix())
        light3.bind(staticShader, "light3")
        light4.bind(staticShader, "light4")
        light5.bind(staticShader, "light5")

        staticShader.setUniform("farbe", Vector3f(0.0f, 1.0f, 0.0f))
        ground.render(staticShader)
        staticShader.setUniform("farbe", farbe)
        cycle.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        if (window.getKeyState(GLFW_KEY_W)) {
            if (window.getKeyState(GLFW_KEY_A)) {
                cycle.rotateLocal(0.0f, 1.5f * dt, 0.0f)
            }
            if (window.getKeyState(GLFW_KEY_D)) {
                cycle.rotateLocal(0.0f, -1.5f * dt, 0.0f)
            }
            cycle.translateLocal(Vector3f(0.0f, 0.0f, -5.0f * dt))
        }
        if (window.getKeyState(GLFW_KEY_S)) {
            if (window.getKeyState(GLFW_KEY_A)) {
                cycle.rotateLocal(0.0f, 1.5f * dt, 0.0f)
            }
            if (window.getKeyState(GLFW_KEY_D)) {
                cycle.rotateLocal(0.0f, -1.5f * dt, 0.0f)
            }
            cycle.translateLocal(Vector3f(0.0f, 0.0f, 5.0f * dt))
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMove) {
            oldX = xpos
            oldY = ypos
            firstMove = false
        }
        val deltaX = (oldX - xpos).toFloat()
        //val deltaY = (oldY - ypos).toFloat()
        oldX = xpos
        oldY = ypos
        camera.rotateAroundPoint(0.0f, deltaX * 0.002f, 0.0f, Vector3f(0.0f, 0.0f, 0.0f))
    }

    fun cleanup() {
        ground.cleanup()
        cycle.cleanup()
        staticShader.cleanup()
    }
}
